"""The sides of blocks in colours of their joints or bonds, as `blocks plot --colour joint` and `bond` draw them."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import colors
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from .colours import mix
from .scenes import Scene

__all__ = ["SIDES", "add_sides", "joint_colour", "side_handles"]

SIDES = ("joint", "bond")  #: colours of plot() that are those of sides

_NONE = (0.68, 0.68, 0.7)  # sides without a joint or without a law
_JOINTS = ("#004587", "#ed7833", "#0a7559", "#212121", "#ed3378", "#45ab99", "#b070b8", "#6b3d00")
_TINTS = (1.0, 0.72, 0.5)
_BONDED = (0.05, 0.28, 0.47)
_SLIP = colors.LinearSegmentedColormap.from_list("slip", [(0.96, 0.58, 0.11), (0.83, 0.15, 0.13), (0.38, 0.02, 0.14)])
_FACING = -0.95  # sides of two blocks form a face if the cosine of their directions is at most this

_Floats = NDArray[np.float64]


def joint_colour(joint: int) -> str:
    """Returns the colour "#004587" of a joint id from 1."""
    index = (joint - 1) % (len(_JOINTS) * len(_TINTS))
    return colors.to_hex(mix(_JOINTS[index % len(_JOINTS)], "white", _TINTS[index // len(_JOINTS)])[0])


def add_sides(ax: Axes, scene: Scene, colour: str, size: float, zorder: float) -> LineCollection:
    """Adds lines on the sides of blocks.

    Args:
        ax: the Axes.
        scene: the blocks.
        colour: "joint" or "bond".
        size: [pt] of an ordinary block.
        zorder: of the blocks.

    Raises:
        ValueError: if no side has a joint id, or no contact the law of a joint.
    """
    width = float(np.clip(0.06 * size, 0.7, 2.5))
    thin = min(0.4 * width, 0.6)
    segments, tones = _joint_sides(scene) if colour == "joint" else _bond_sides(scene)
    plain = [np.array([outline, np.roll(outline, -1, axis=0)]).swapaxes(0, 1) for outline in scene.polygons]
    below = np.concatenate([one for one in plain if len(one)]) if any(len(one) for one in plain) else []
    lines = LineCollection(
        [*below, *segments],
        colors=[_NONE] * len(below) + tones,
        linewidths=[thin] * len(below) + [width] * len(segments),
        capstyle="round",
        zorder=zorder + 0.02,
    )
    ax.add_collection(lines, autolim=False)
    return lines


def side_handles(scene: Scene, colour: str) -> list[Line2D]:
    """Returns the entries of a legend for the sides."""
    if colour == "joint":
        ids = np.unique(scene.state.joint)
        return [Line2D([], [], color=joint_colour(id), label=f"joint {id}") for id in ids[ids > 0].tolist()]
    return [Line2D([], [], color=_BONDED, label="bonded"), Line2D([], [], color=_SLIP(0.5), label="failed")]


def _joint_sides(scene: Scene) -> tuple[list[_Floats], list[Any]]:
    """Returns the sides (2, 2) that have a joint id, and their colours."""
    state, segments, tones = scene.state, [], []
    for b, outline in enumerate(scene.polygons):
        joints = state.joint[state.first_corner[b] : state.first_corner[b + 1]]
        for k in np.flatnonzero(joints[: len(outline)]):
            segments.append(np.array([outline[k], outline[(k + 1) % len(outline)]]))
            tones.append(joint_colour(int(joints[k])))
    if not segments:
        raise ValueError("no side of a block has a joint id, which CUT gives to the sides along joints")
    return segments, tones


def _bond_sides(scene: Scene) -> tuple[list[_Floats], list[Any]]:
    """Returns the parts (2, 2) of faces that contacts with a law stand for, and their colours: the more slip, the
    later they are drawn and the darker they are."""
    contacts = getattr(scene.state, "contacts", None)
    if contacts is None or "law" not in contacts.dtype.names or not np.any(contacts["law"]):
        raise ValueError("no contact has the law of a joint, which the cards JOINT and JPAIR give")
    corners, first = scene.state.corners, scene.state.first_corner
    parts = []
    for contact in contacts[(contacts["law"] != 0) & (contacts["edge_block"] >= 0)]:
        own, other = int(contact["corner_block"]), int(contact["edge_block"])
        corner, begin = int(contact["corner"]), corners[contact["edge"]]
        edge = corners[_beside(first, other, int(contact["edge"]), 1)] - begin
        length = float(np.hypot(*edge))
        along = edge / length
        foot = float(np.clip((corners[corner] - begin) @ along, 0.0, length))
        has_slipped = bool(contact["failed"])
        for step in (-1, 1):
            end = corners[_beside(first, own, corner, step)]
            side = step * (end - corners[corner])
            if side @ along > _FACING * np.hypot(*side):
                continue
            middle = 0.5 * (foot + float(np.clip((end - begin) @ along, 0.0, length)))
            parts.append((has_slipped, abs(float(contact["slip"])), begin + foot * along, begin + middle * along))
    parts.sort(key=lambda part: part[:2])
    most = max((slip for _, slip, *_ in parts), default=0.0)
    tones = [_SLIP(slip / most if most > 0.0 else 0.0) if failed else _BONDED for failed, slip, *_ in parts]
    return [np.array(part[2:]) for part in parts], tones


def _beside(first: NDArray[np.integer], block: int, corner: int, step: int) -> int:
    """Returns the corner before (-1) or behind (1) a corner of a block."""
    begin, count = int(first[block]), int(first[block + 1] - first[block])
    return begin + (corner - begin + step) % count
