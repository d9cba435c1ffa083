"""The blocks of a frame in the forms of other programs."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np

from . import _blocks

__all__ = ["geojson_of_assembly", "geojson_text", "pyvista_mesh"]

_QUANTITIES = ("speed", "displacement", "rotation", "s11", "s12", "s22", "p1", "p2")


def _digits(value: float) -> str:
    """Returns the shortest decimal that reads back as the same double, or null."""
    return repr(value).removesuffix(".0") if math.isfinite(value) else "null"


def geojson_text(frame: Any) -> str:
    """Returns the GeoJSON text that `blocks export` writes for a Frame. Blocks are counted from 1."""
    columns: dict[str, Any] = {}
    if len(frame.results.cracks) > 0 and "Parent" in frame:
        columns["parent"] = frame["Parent"].tolist()
    for name in _QUANTITIES:
        columns[name] = frame.quantity(name).tolist()
    return _geojson(frame, columns, f'"time": {_digits(frame.time)},\n')


def geojson_of_assembly(assembly: Any) -> str:
    """Returns the GeoJSON text that `blocks export` writes for a deck, here an Assembly. Blocks are counted from 1."""
    return _geojson(assembly, {}, "")


def _geojson(state: Any, columns: dict[str, Any], head: str) -> str:
    """Returns the features of all blocks that are not removed, with further columns of properties."""
    material, is_free = state.material.tolist(), state.is_free.tolist()
    area = _blocks._areas(state.corners, state.first_corner).tolist()
    with_joints = bool(state.joint.any())
    polygons, features = state.polygons, []
    for b in np.flatnonzero(~state.is_removed):
        outline = polygons[b].tolist()
        facts = f'"number": {b + 1}, "material": {material[b]}'
        if name := state.materials.get(material[b], ""):
            facts += f', "material_name": {json.dumps(name, ensure_ascii=False)}'
        facts += f', "fixed": {"false" if is_free[b] else "true"}, "area": {_digits(area[b])}'
        if with_joints:
            joint = state.joint[state.first_corner[b] : state.first_corner[b + 1]]
            facts += f', "joints": [{", ".join(map(str, reversed(joint.tolist())))}]'
        for name, values in columns.items():
            facts += f', "{name}": {_digits(values[b])}'
        ring = ", ".join(f"[{_digits(x)}, {_digits(y)}]" for x, y in (outline[:1] + outline[::-1]))
        features.append(
            f'{{"type": "Feature", "properties": {{{facts}}}, '
            f'"geometry": {{"type": "Polygon", "coordinates": [[{ring}]]}}}}'
        )
    return f'{{"type": "FeatureCollection",\n{head}"features": [\n' + ",\n".join(features) + "\n]}\n"


def pyvista_mesh(frame: Any) -> Any:
    """Returns the blocks of a Frame that are not removed as a pyvista.PolyData with all cell arrays."""
    try:
        import pyvista
    except ImportError:
        raise ImportError("to_pyvista() needs pyvista: python3 -m pip install pyvista") from None
    shown = ~frame.is_removed
    faces, first = [], 0
    for count in np.diff(frame.first_corner)[shown].tolist():
        faces += [count, *range(first, first + count)]
        first += count
    points = np.column_stack([frame.corners, np.zeros(len(frame.corners))])
    mesh = pyvista.PolyData(points, np.array(faces, np.int64))
    for name in frame.names:
        mesh.cell_data[name] = frame[name][shown]
    return mesh
