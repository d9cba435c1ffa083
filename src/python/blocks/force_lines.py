"""Contact forces drawn as lines between blocks."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from numpy.typing import NDArray

from .colours import FORCES, INK, luminance
from .scenes import Scene

__all__ = ["Links", "add_forces", "force_scale", "links_of"]

_THINNEST = 0.08  # [pt] of force lines; thinner ones cannot be seen and are left out


class Links(NamedTuple):
    """The k pairs of touching blocks, sorted by their forces.

    Attributes:
        first: (k,) a block of the pair; -1: a symmetry plane.
        second: (k,) the other block.
        point: (k, 2) [L] middle of their contacts, weighted by the forces.
        force: (k,) [F] magnitude of the sum of their forces.
    """

    first: NDArray[np.int_]
    second: NDArray[np.int_]
    point: NDArray[np.float64]
    force: NDArray[np.float64]


def links_of(state: Any) -> Links:
    """Returns the links of a Frame or a Simulation. Raises ValueError if it has no contacts."""
    contacts = getattr(state, "contacts", None)
    if contacts is None:
        raise ValueError(f"there are no contact forces in {state!r}")
    blocks = np.stack([contacts["corner_block"], contacts["edge_block"]], axis=1).astype(np.int_)
    order = np.where(blocks[:, 0] > blocks[:, 1], 1.0, -1.0)[:, None]
    pairs, place = np.unique(np.sort(blocks, axis=1), axis=0, return_inverse=True)
    place = place.reshape(-1)
    sums, points, weights = np.zeros((len(pairs), 2)), np.zeros((len(pairs), 2)), np.zeros(len(pairs))
    weight = np.hypot(*contacts["force"].T)
    np.add.at(sums, place, order * contacts["force"])
    np.add.at(points, place, weight[:, None] * contacts["point"])
    np.add.at(weights, place, weight)
    force = np.hypot(*sums.T)
    chosen = np.argsort(force, kind="stable")
    chosen = chosen[weights[chosen] > 0.0]
    middle = points[chosen] / weights[chosen][:, None]
    return Links(pairs[chosen, 0], pairs[chosen, 1], middle, force[chosen])


def force_scale(states: Iterable[Any]) -> float:
    """Returns one force_scale [F] for pictures of several frames: see plot().

    It is the median of their largest forces, as in `blocks plot`, so that a single impact does not hide all
    others. It is 0 if no frame has a contact.
    """
    largest = [float(force[-1]) for state in states if (force := links_of(state).force).size]
    return float(np.median(largest)) if largest else 0.0


def add_forces(
    ax: Axes, scene: Scene, size: float, scale: float | None, width: float | None, zorder: float
) -> tuple[LineCollection, LineCollection]:
    """Adds lines from centroid to centroid through the contact; fixed blocks have no half.

    Args:
        ax: the Axes.
        scene: the blocks.
        size: [pt] of an ordinary block.
        scale: [F] that has the full width; None: the largest.
        width: [pt] full width; None: it follows the size of the blocks.
        zorder: of the blocks.

    Returns:
        The rims of the lines, and the lines.
    """
    links, centroid = links_of(scene.state), scene.state.centroid
    full = float(np.clip(0.3 * size, 1.2, 7.0)) if width is None else width
    if scale is None:
        scale = float(links.force[-1]) if links.force.size else 0.0
    lines, forces = [], []
    least = 0.0 if full <= 0.0 else _THINNEST / full * scale
    for first, second, point, force in zip(*links):
        if force < least:
            continue
        ends = [centroid[b] for b in (first, second) if b >= 0 and not scene.is_fixed[b]]
        if ends:
            lines.append(np.array([ends[0], point, *ends[1:]]))
            forces.append(force)
    array = np.array(forces)
    widths = full * np.minimum(array / scale, 1.5) if scale > 0.0 else np.zeros(len(array))
    shape = {"capstyle": "round", "joinstyle": "round"}
    core = LineCollection(lines, linewidths=widths, cmap=FORCES, zorder=zorder + 0.3, **shape)
    core.set_array(array)
    core.set_clim(0.0, scale or 1.0)
    core.update_scalarmappable()
    # A dark rim beside a pale line and a white one beside a dark line show it on any block.
    is_pale = luminance(core.get_colors().reshape(-1, 4)) > 0.2
    rim = np.where(is_pale[:, None], INK, (1.0, 1.0, 1.0)) if len(lines) else "none"
    # Thin lines have none: a dark rim would make small forces look larger than others.
    added = np.clip(0.6 * (widths - 0.5), 0.0, 0.7)
    rim_widths = np.where(added > 0.0, widths + added, 0.0)
    rims = LineCollection(lines, linewidths=rim_widths, colors=rim, zorder=zorder + 0.2, **shape)
    for collection in (rims, core):
        ax.add_collection(collection, autolim=False)
    return rims, core
