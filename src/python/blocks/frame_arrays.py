"""The arrays of one frame of a results file: cells, outlines and water."""

from __future__ import annotations

from typing import Any

import h5py
import numpy as np
from numpy.typing import NDArray

from .results_file import expected, frozen

__all__ = [
    "OF_EVERY_FRAME", "cell_array", "cell_names", "field_value", "outlines_of", "water_table_of", "wet_side_table",
]

# Columns of the cell arrays that have more than one.
_WIDTHS = {"Centroid": 3, "Velocity": 3, "Force": 3, "Stress": 4, "AppliedStress": 4, "StrainRate": 4, "WaterForce": 3}
#: Cell arrays that the program writes with every frame.
OF_EVERY_FRAME = {*_WIDTHS, "BlockNumber", "Material", "Fixed", "Area", "Mass", "Inertia", "Angle", "Spin", "Moment"}
OF_EVERY_FRAME -= {"WaterForce"}

_Floats = NDArray[np.float64]
_Integers = NDArray[np.integer]


def cell_names(file: h5py.File, frame: int) -> tuple[str, ...]:
    """Returns the names of the cell arrays that a frame has."""
    offsets = file["VTKHDF/Steps/CellDataOffsets"]
    # A run that was interrupted while it added an array left frames without it.
    return tuple(
        name for name in file["VTKHDF/CellData"] if name in offsets and offsets[name].shape[0] > frame
    )


def cell_array(file: h5py.File, frame: int, name: str) -> NDArray[Any]:
    """Reads a cell array of a frame, (n,) or (n, 3 or 4)."""
    vtk = file["VTKHDF"]
    part = vtk["Steps/PartOffsets"][frame]
    blocks = vtk["NumberOfCells"][part]
    first = vtk["Steps/CellDataOffsets"][name][frame]
    values = vtk["CellData"][name][first : first + blocks]
    shape = (blocks, _WIDTHS[name]) if name in _WIDTHS else (blocks,)
    if first < 0:
        raise ValueError(f"CellDataOffsets/{name} is out of range")
    return frozen(expected(f"CellData/{name}", values, shape, "biuf"))


def field_value(file: h5py.File, frame: int, name: str) -> float:
    """Reads a number of a frame."""
    offset = file["VTKHDF/Steps/FieldDataOffsets"][name][frame]
    return float(file["VTKHDF/FieldData"][name][offset].item())


def outlines_of(file: h5py.File, frame: int) -> tuple[_Floats, _Integers, _Integers, _Integers]:
    """Reads the corners of all blocks that are not removed (m, 2), where each block begins (n + 1,), and the joint
    ids and the points of the corners (m,)."""
    vtk = file["VTKHDF"]
    steps = vtk["Steps"]
    part = int(steps["PartOffsets"][frame])
    blocks, points, ids = (
        int(vtk[name][part]) for name in ("NumberOfCells", "NumberOfPoints", "NumberOfConnectivityIds")
    )
    first = int(steps["PointOffsets"][frame])
    corners = vtk["Points"][first : first + points, :2]
    first = int(steps["CellOffsets"][frame]) + part  # each part has one more than cells
    starts = vtk["Offsets"][first : first + blocks + 1]
    first = int(steps["ConnectivityIdOffsets"][frame])
    order = vtk["Connectivity"][first : first + ids]
    joint = np.zeros(points, np.int32)
    offsets = steps.get("PointDataOffsets/Joint")
    if offsets is not None and offsets.shape[0] > frame:
        first = int(offsets[frame])
        joint = vtk["PointData/Joint"][first : first + points]
    expected("Points", corners, (points, 2), "f")
    expected("Offsets", starts, (blocks + 1,), "iu")
    expected("Connectivity", order, (ids,), "iu")
    expected("PointData/Joint", joint, (points,), "iu")
    if starts[0] != 0 or starts[-1] != ids or (np.diff(starts) < 0).any():
        raise ValueError("Offsets is out of range")
    if ((order < 0) | (order >= points)).any():
        raise ValueError("Connectivity is out of range")
    return frozen(corners[order]), frozen(starts), frozen(joint[order]), frozen(order)


def _of_water(file: h5py.File, frame: int, rows: str, names: tuple[str, ...]) -> tuple[NDArray[Any], ...]:
    """Rows of a frame of datasets of BLOCKS/water, without any if there is no water."""
    water = file.get("BLOCKS/water")
    first, count = 0, 0
    if water is not None and "points_of_frame" in water and water[rows].shape[0] > frame:
        first, count = map(int, water[rows][frame])
    return tuple(water[name][first : first + count] for name in names) if count else ()


def wet_side_table(file: h5py.File, frame: int, points: _Integers) -> NDArray[np.void]:
    """Reads the parts of sides on which water presses; points: those of the corners (m,)."""
    kind = np.dtype([("corner", np.int64), ("share", np.float64, 2), ("pressure", np.float64, 2)])
    found = _of_water(file, frame, "parts_of_frame", ("corner", "part"))
    table = np.zeros(len(found[0]) if found else 0, kind)
    if found:
        rows = np.full(int(points.max()) + 1, -1, np.int64)
        rows[points] = np.arange(len(points))
        expected("BLOCKS/water/part", found[1], (len(table), 4), "f")
        table["corner"], table["share"], table["pressure"] = rows[found[0]], found[1][:, :2], found[1][:, 2:]
    return frozen(table)


def water_table_of(file: h5py.File, frame: int) -> _Floats:
    """Reads the water table (k, 2), from the left to the right."""
    found = _of_water(file, frame, "points_of_frame", ("point",))
    return frozen(found[0] if found else np.zeros((0, 2)))
