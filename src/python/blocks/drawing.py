"""Draws blocks."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

import matplotlib
import numpy as np
from matplotlib import cbook, colors, patheffects
from matplotlib.axes import Axes
from matplotlib.collections import Collection, LineCollection, PolyCollection
from matplotlib.colorbar import Colorbar
from matplotlib.figure import Figure
from matplotlib.legend import Legend
from matplotlib.patches import Patch
from matplotlib.text import Text
from numpy.typing import ArrayLike, NDArray

from . import quantities
from .colours import INK, MAPS, WHOLE, is_dark, material_colour, mix, outlines_on
from .faces import FACES, OUTLINE, add_faces
from .figures import fit_height, new_figure
from .force_lines import add_forces
from .scenes import MARGIN, Scene
from .sides import SIDES, add_sides, side_handles

__all__ = ["Drawing", "plot"]

_HATCH_RC = {"hatch.linewidth": 0.35}  # [pt]
_SMALLEST_TEXT = 4.0  # [pt] of block numbers; they are left out where they do not fit

_Floats = NDArray[np.float64]


@dataclass
class Drawing:
    """What plot() has added to a picture.

    Attributes:
        ax: the Axes.
        blocks: PolyCollection with a polygon for each block.
        fixed: PolyCollection with the hatching of fixed blocks, or None.
        forces: LineCollection of the contact forces, the largest last, or None.
        rims: LineCollection of the rims of these lines, or None.
        sides: LineCollection of the sides of blocks in colours of joints, bonds or faces, or None.
        numbers: Text of the block numbers.
        colorbar: Colorbar, or None.
        legend: Legend of the materials, or None.
    """

    ax: Axes
    blocks: PolyCollection
    fixed: PolyCollection | None = None
    forces: LineCollection | None = None
    rims: LineCollection | None = None
    sides: LineCollection | None = None
    numbers: list[Text] = field(default_factory=list)
    colorbar: Colorbar | None = None
    legend: Legend | None = None

    @property
    def figure(self) -> Figure:
        """The Figure of the Axes."""
        return self.ax.figure

    def __iter__(self) -> Iterator[Collection | Text]:
        """All artists, in the order in which they are drawn."""
        for artist in (self.blocks, self.fixed, self.sides, self.rims, self.forces):
            if artist is not None:
                yield artist
        yield from self.numbers

    def remove(self) -> None:
        """Removes all artists from the picture, such as before the next one of a movie."""
        for artist in (*self, self.legend):
            if artist is not None:
                artist.remove()
        if self.colorbar is not None:
            self.colorbar.ax.remove()

    def __repr__(self) -> str:
        lines = "" if self.forces is None else f", {len(self.forces.get_segments())} force lines"
        return f"<Drawing: {len(self.blocks.get_paths())} blocks{lines}>"


def plot(
    state: Any,
    ax: Axes | None = None,
    colour: str | ArrayLike | None = "material",
    *,
    forces: bool = False,
    numbers: bool = False,
    cmap: Any = None,
    colorbar: bool = False,
    legend: bool = False,
    force_scale: float | None = None,
    force_width: float | None = None,
    **options: Any,
) -> Drawing:
    """Draws blocks with equal scales along x and y, in the colours of `blocks plot`.

    Fixed blocks are hatched, and light grey unless they have a quantity or colours that were given. Removed
    blocks are not drawn. The picture keeps its state when a Simulation makes steps.

    Args:
        state: a Frame, such as results[-1], a Simulation or an Assembly, with n blocks.
        ax: the Axes; None: a new figure, whose height fits the blocks.
        colour: "material"; "joint" (the sides of blocks by joint id) or "bond" (the faces with the law of a
            joint: bonded, or failed and how far they slipped); "opening" or "shear_displacement" (the faces
            between blocks by their motion since the first frame of results); a quantity of `Frame.quantity`, such as
            "speed" or "s22"; an attribute with one number for each block, such as "layer"; an array of such
            numbers, (n,), or of colours, (n, 3) or (n, 4); None: all blocks are light grey. Blocks without a
            number (NaN) are grey.
        forces: draws contact forces. Each pair of touching blocks has a line from centroid to centroid
            through their contact, whose width is proportional to the force.
        numbers: writes the numbers of blocks that are large enough. They index arrays, from 0.
        cmap: colour map of a quantity, by default that of `blocks plot`. With materials a dictionary of
            colours by number or name: {1: "tan", "coal": "0.2"}.
        colorbar: draws a colour bar of the quantity, or of the forces if there is no quantity.
        legend: lists the materials, hatching for fixed blocks, and joints or bonds.
        force_scale: [F] that has the full width; None: the largest. Pass one number for several frames, such
            as that of the function force_scale().
        force_width: [pt] full width; None: it follows the size of the blocks.
        options: of the PolyCollection, such as edgecolor, linewidth, alpha, norm, clim, zorder.

    Raises:
        KeyError: if there is no such quantity.
        NotReadError: if forces of a Simulation are not known: see `Simulation.step`.
        ValueError: if an array has the wrong shape, or there are no contact forces, joints or laws.
    """
    scene, is_new = Scene(state), ax is None
    if ax is None:
        ax = new_figure(pyplot=True, shape=scene.shape).subplots()
    options = cbook.normalize_kwargs(options, PolyCollection)
    sides = colour if isinstance(colour, str) and colour in SIDES else ""
    faces = colour if isinstance(colour, str) and colour in FACES else ""
    on_sides = bool(sides or faces)
    limits = {name: options.pop(name) for name in ("norm", "clim") if faces and name in options}
    ground, values, label, zero = _colours_of(scene, "material" if on_sides else colour, cmap, forces or on_sides)
    scale = _points_per_length(ax, scene)
    size = scene.block_size * scale  # [pt]
    defaults: dict[str, Any] = {"linewidth": float(np.clip(0.03 * size, 0.15, 0.8))}
    if ground is not None:
        defaults["facecolor"] = ground
    blocks = PolyCollection(scene.polygons, **{**defaults, "joinstyle": "round", **options})
    if values is not None and "facecolor" not in options:
        _set_values(blocks, values, zero, cmap, options)
        blocks.update_scalarmappable()
        ground = blocks.get_facecolor()
    else:
        fills = blocks.get_facecolor()  # they repeat; without any the paper is seen
        ground = np.resize(fills if len(fills) else colors.to_rgba_array("white"), (len(scene), 4))
    if "edgecolor" not in options:
        blocks.set_edgecolor(outlines_on(ground, faint=forces) if len(scene) else "none")
    ax.add_collection(blocks)
    drawing = Drawing(ax, blocks)
    zorder = blocks.get_zorder()
    drawing.fixed = _add_hatching(ax, scene, ground, zorder)
    if sides:
        drawing.sides = add_sides(ax, scene, sides, size, zorder)
    if faces:
        drawing.sides, moved = add_faces(ax, scene, faces, size, zorder)
        _set_values(drawing.sides, moved, "middle", cmap, limits)
        drawing.sides.set_cmap(drawing.sides.get_cmap().with_extremes(bad=OUTLINE))
        drawing.sides.set(**limits)
        label = FACES[faces] + scene.unit("x")
    if forces:
        drawing.rims, drawing.forces = add_forces(ax, scene, size, force_scale, force_width, zorder)
    if numbers:
        drawing.numbers = _add_numbers(ax, scene, scale, ground, zorder)
    _set_axes(ax, scene)
    if legend:
        drawing.legend = _add_legend(ax, scene, ground, side_handles(scene, sides) if sides else [])
    if colorbar:
        drawing.colorbar = _add_colorbar(drawing, scene, label)
    if is_new:
        fit_height(ax.figure)
    return drawing


def _colours_of(
    scene: Scene, colour: Any, cmap: Any, pale: bool
) -> tuple[_Floats | None, _Floats | None, str, str]:
    """Returns colours of the blocks or numbers for a colour map, a label, and what zero means."""
    if colour is None:
        return colors.to_rgba_array([WHOLE] * len(scene)), None, "", "none"
    if isinstance(colour, str):
        if colour == "material":
            return _material_colours(scene, cmap if isinstance(cmap, Mapping) else {}, pale), None, "", "none"
        kind, values = quantities.kind_of(colour), quantities.quantity(scene.state, colour)
        return None, values, kind.label + scene.unit(colour), kind.zero
    array = np.asarray(colour)
    if array.shape == (len(scene),) and array.dtype.kind in "biuf":
        values = array.astype(np.float64)
        with_signs = bool(np.any(values < 0.0) and np.any(values > 0.0))
        return None, values, "", "middle" if with_signs else "lowest"
    if array.shape in ((len(scene),), (len(scene), 3), (len(scene), 4)):
        return colors.to_rgba_array(array.tolist() if array.ndim == 1 else array), None, "", "none"
    raise ValueError(
        f"colour has the shape {array.shape}, but there are {len(scene)} blocks: "
        f"give one number, or one colour, for each block"
    )


def _material_colours(scene: Scene, chosen: Mapping[int | str, Any], pale: bool) -> _Floats:
    """Colours of the blocks by material, (n, 3). They are pale under contact forces."""
    numbers, place = np.unique(scene.state.material, return_inverse=True)
    palette, is_chosen = np.zeros((len(numbers), 3)), np.zeros(len(numbers), bool)
    for i, number in enumerate(numbers.tolist()):
        name = scene.materials.get(number, "")
        colour = chosen.get(number, chosen.get(name))
        is_chosen[i] = colour is not None
        palette[i] = mix(colour if is_chosen[i] else material_colour(number), "white", 0.3 if pale else 1.0)
    result = palette[place]
    result[scene.is_fixed & ~is_chosen[place]] = colors.to_rgb(WHOLE)
    return result


def _set_values(
    blocks: Collection, values: _Floats, zero: str, cmap: Any, options: Mapping[str, Any]
) -> None:
    """Gives blocks or lines a colour map and the range of `blocks plot`, unless the options have one."""
    found = matplotlib.colormaps[MAPS[zero]] if cmap is None else cmap
    if isinstance(found, str):
        found = matplotlib.colormaps[found]
    has_range = "norm" in options or "clim" in options
    low, high = _range_of(values, zero, one_sided=cmap is None)
    if zero == "middle" and not has_range and low != -high:
        largest = max(-low, high)
        ends = 0.5 + 0.5 * low / largest, 0.5 + 0.5 * high / largest  # zero keeps the colour in the middle
        found = colors.ListedColormap(found(np.linspace(*ends, 256)), found.name)
    if "cmap" not in options:
        blocks.set_cmap(found.with_extremes(bad="0.85"))
    blocks.set_array(np.ma.masked_invalid(values))
    if not has_range:
        blocks.set_clim(low, high)


def _range_of(values: _Floats, zero: str, one_sided: bool) -> tuple[float, float]:
    """Returns the range of the colours. If zero is in the middle, the range is centred on 0. If `one_sided`, it
    ends there if all values have one sign, and at the values if those of one sign reach less than a tenth as
    far as the others."""
    known = values[np.isfinite(values)]
    low, high = (float(known.min()), float(known.max())) if known.size else (0.0, 0.0)
    if zero == "middle":
        largest = max(abs(low), abs(high)) or 1.0
        if one_sided and low < 0.0 < high and min(-low, high) < 0.1 * largest:
            return low, high
        is_half = one_sided and (low < 0.0) != (high > 0.0)
        return (0.0 if is_half and high > 0.0 else -largest), (0.0 if is_half and low < 0.0 else largest)
    low = min(0.0, low) if zero == "lowest" else low
    return low, high if high > low else low + 1.0


def _points_per_length(ax: Axes, scene: Scene) -> float:
    """[pt/L] Scale of the picture, before its layout is known exactly."""
    low, high = scene.extent
    box = ax.get_window_extent()
    room = np.array([box.width, box.height]) * 72 / ax.figure.dpi
    return float(np.min(room / ((1 + 2 * MARGIN) * np.maximum(high - low, 1e-300))))


def _set_axes(ax: Axes, scene: Scene) -> None:
    ax.set_aspect("equal")
    if ax.get_autoscale_on():
        low, high = scene.extent
        margin = MARGIN * float(np.max(high - low))
        ax.update_datalim([low - margin, high + margin])
        ax.margins(0.0)
        ax.autoscale_view()
    for name, axis in (("x", ax.xaxis), ("y", ax.yaxis)):
        if not axis.get_label_text():
            axis.set_label_text(name + scene.unit(name))


class _Hatched(PolyCollection):
    """Blocks with thin hatching. Matplotlib takes the width of its lines when it draws."""

    def __init__(self, *args: Any, **options: Any):
        with matplotlib.rc_context(_HATCH_RC):
            super().__init__(*args, **options)

    def draw(self, renderer: Any) -> None:
        with matplotlib.rc_context(_HATCH_RC):
            super().draw(renderer)


def _hatch(ax: Axes) -> str:
    """Returns hatching with about as many lines in a picture of any width."""
    width = ax.get_window_extent().width / ax.figure.dpi  # [in]
    return "/" * int(np.clip(round(12.5 / width), 2, 6))


def _add_hatching(ax: Axes, scene: Scene, ground: _Floats, zorder: float) -> PolyCollection | None:
    fixed = np.flatnonzero(scene.is_fixed)
    if fixed.size == 0:
        return None
    lines = np.where(is_dark(ground[fixed])[:, None], (1, 1, 1, 0.45), (0.1, 0.1, 0.1, 0.4))
    hatching = _Hatched(
        [scene.polygons[b] for b in fixed],
        hatch=_hatch(ax),
        facecolor="none",
        edgecolor=lines,
        linewidth=0.0,
        zorder=zorder + 0.01,
    )
    ax.add_collection(hatching, autolim=False)
    return hatching


def _add_numbers(ax: Axes, scene: Scene, scale: float, ground: _Floats, zorder: float) -> list[Text]:
    dark, texts = is_dark(ground), []
    for b, outline in enumerate(scene.polygons):
        if len(outline) == 0:
            continue
        size = float(np.ptp(outline, axis=0).min()) * scale  # [pt] smaller side of the bounding box
        if size < 1.3 * _SMALLEST_TEXT:
            continue
        text = ax.text(
            *scene.state.centroid[b].tolist(),
            str(b),
            size=float(np.clip(0.42 * size, _SMALLEST_TEXT, 9.0)),
            color="white" if dark[b] else INK,
            ha="center",
            va="center_baseline",
            zorder=zorder + 0.5,
            clip_on=True,
            path_effects=[patheffects.withStroke(linewidth=1.5, foreground=ground[b][:3])],
        )
        texts.append(text)
    return texts


def _add_legend(ax: Axes, scene: Scene, ground: _Floats, more: list[Any]) -> Legend:
    look = {"edgecolor": "0.4", "linewidth": 0.4}
    is_grey = scene.is_fixed & np.all(ground[:, :3] == colors.to_rgb(WHOLE), axis=1)
    material, is_listed = scene.state.material, ~scene.is_removed & ~is_grey
    handles = []
    for number in np.unique(material[is_listed]).tolist():
        first = ground[np.flatnonzero(is_listed & (material == number))[0]]
        name = scene.materials.get(number, f"material {number}")
        handles.append(Patch(facecolor=first, label=name, **look))
    if scene.is_fixed.any():
        handles.append(Patch(facecolor=WHOLE, label="fixed", hatch=_hatch(ax), **look))
    handles += more
    low, high = scene.extent
    if (high - low)[1] < 0.5 * (high - low)[0]:
        place = {"loc": "lower left", "bbox_to_anchor": (0.0, 1.0), "ncol": min(4, len(handles))}
    else:
        place = {"loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
    return ax.legend(handles=handles, frameon=False, borderaxespad=0.4, **place)


def _add_colorbar(drawing: Drawing, scene: Scene, label: str) -> Colorbar:
    """Adds a bar as long as the Axes: on the right, or above wide pictures that have no legend there."""
    ax = drawing.ax
    with_values = [one for one in (drawing.blocks, drawing.sides) if one is not None and one.get_array() is not None]
    mapped: Any = with_values[0] if with_values else drawing.forces
    if mapped is None:
        raise ValueError("a colour bar needs a quantity, such as colour='speed', or forces=True")
    if mapped is drawing.forces:
        label = "contact force" + scene.unit("fx")
    width, height = np.ptp([ax.get_xlim(), ax.get_ylim()], axis=1)
    thick, gap = 0.03, 0.02  # shares of the width
    if height < 0.5 * width and drawing.legend is None:
        share = width / height
        inset = ax.inset_axes([0.0, 1.0 + gap * share, 1.0, thick * share])
        bar = ax.figure.colorbar(mapped, cax=inset, orientation="horizontal", label=label)
        inset.xaxis.set_ticks_position("top")
        inset.xaxis.set_label_position("top")
    else:
        inset = ax.inset_axes([1.0 + gap, 0.0, thick, 1.0])
        bar = ax.figure.colorbar(mapped, cax=inset, label=label)
    bar.outline.set_linewidth(matplotlib.rcParams["axes.linewidth"])
    return bar
