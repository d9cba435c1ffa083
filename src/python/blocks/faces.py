"""The faces between blocks in colours of their motion, as `blocks plot --colour opening` draws them."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from numpy.typing import NDArray

from . import _blocks
from .scenes import Scene

__all__ = ["FACES", "OUTLINE", "add_faces"]

#: Colours of plot() that are those of faces, with their labels. Shear is positive if dextral.
FACES = {"opening": "opening", "shear_displacement": "shear displacement"}

OUTLINE = (0.36, 0.36, 0.4)  #: colour of the outlines of blocks, which are on top

_STEPS = 8  # parts of a side with a colour of their own

_Floats = NDArray[np.float64]


def add_faces(ax: Axes, scene: Scene, colour: str, size: float, zorder: float) -> tuple[LineCollection, _Floats]:
    """Adds lines on both sides of faces, the largest values on top, and the outlines of blocks.

    Args:
        ax: the Axes.
        scene: the blocks of a frame of results.
        colour: a name of FACES.
        size: [pt] of an ordinary block.
        zorder: of the blocks.

    Returns:
        The lines and the values that give their colours, [L]. Outlines have NaN.

    Raises:
        ValueError: if the blocks are not those of a frame, or no two of them have a common face.
    """
    state = scene.state
    if not hasattr(state, "results"):
        raise ValueError(f"{colour} is since the first frame of results: only their frames have it")
    ends, *motion = _blocks._face_motions(state.results.path, state.index)
    values = motion[list(FACES).index(colour)]
    if not len(values):
        raise ValueError("no two blocks have a common face that was closed in the first frame")
    order = np.argsort(np.abs(values).max(axis=1), kind="stable")
    ends, values = ends[order], values[order]
    part = np.linspace(0.0, 1.0, _STEPS + 1)
    points = ends[:, :, :1] + part[:, None] * (ends[:, :, 1:] - ends[:, :, :1])  # face, side, point, axis
    pieces = np.stack([points[:, :, :-1], points[:, :, 1:]], axis=3).reshape(-1, 2, 2)
    middle = 0.5 * (part[1:] + part[:-1])
    along = values[:, :1] + middle * (values[:, 1:] - values[:, :1])
    outlines = [np.concatenate([outline, outline[:1]]) for outline in scene.polygons if len(outline)]
    width = float(np.clip(0.1 * size, 1.2, 3.5))
    lines = LineCollection(
        [*pieces, *outlines],
        linewidths=[width] * len(pieces) + [min(0.15 * width, 0.4)] * len(outlines),
        capstyle="butt",
        zorder=zorder + 0.02,
    )
    ax.add_collection(lines, autolim=False)
    both = np.repeat(along[:, None], 2, axis=1).reshape(-1)
    return lines, np.concatenate([both, np.full(len(outlines), np.nan)])
