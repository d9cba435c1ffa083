"""The sides of blocks in colours of their joints or bonds, as `blocks plot --colour joint` and `bond` draw them."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from . import _blocks
from .colours import joint_colour
from .scenes import Scene

__all__ = ["SIDES", "add_sides", "side_handles"]

SIDES = ("joint", "bond")  #: colours of plot() that are those of sides

_SLIPPED = ("failed", "weakened")  # bonds whose faces have the colours of slip
_DASHES = {"weakened": (0, (5, 3))}  # of bonds

_Floats = NDArray[np.float64]


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
    segments, tones, dashes = _joint_sides(scene) if colour == "joint" else _bond_sides(scene)
    plain = [np.array([outline, np.roll(outline, -1, axis=0)]).swapaxes(0, 1) for outline in scene.polygons]
    below = np.concatenate([one for one in plain if len(one)]) if any(len(one) for one in plain) else []
    lines = LineCollection(
        [*below, *segments],
        colors=[_blocks._NO_JOINT_COLOUR] * len(below) + tones,
        linestyles=["solid"] * len(below) + dashes,
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
    _, bonds, slips = _face_parts(scene)
    half = 0.5 if slips.max(initial=0.0) > 0.0 else 0.0
    return [
        Line2D([], [], color=_bond_colour(bond, half), linestyle=_DASHES.get(bond, "solid"), label=bond)
        for bond in ("bonded", "weakened", "failed", "intact")
        if bond in bonds
    ]


def _joint_sides(scene: Scene) -> tuple[list[_Floats], list[Any], list[Any]]:
    """Returns the sides (2, 2) that have a joint id, their colours and their dashes."""
    state, segments, tones = scene.state, [], []
    for b, outline in enumerate(scene.polygons):
        joints = state.joint[state.first_corner[b] : state.first_corner[b + 1]]
        for k in np.flatnonzero(joints[: len(outline)]):
            segments.append(np.array([outline[k], outline[(k + 1) % len(outline)]]))
            tones.append(joint_colour(int(joints[k])))
    if not segments:
        raise ValueError("no side of a block has a joint id, which CUT gives to the sides along joints")
    return segments, tones, ["solid"] * len(segments)


def _bond_sides(scene: Scene) -> tuple[list[_Floats], list[Any], list[Any]]:
    """Returns the parts (2, 2) of faces that contacts with a law stand for, their colours and their dashes."""
    parts, bonds, slips = _face_parts(scene)
    shares = slips / (slips.max(initial=0.0) or 1.0)
    tones = [_bond_colour(bond, share) for bond, share in zip(bonds, shares.tolist())]
    return list(parts), tones, [_DASHES.get(bond, "solid") for bond in bonds]


def _bond_colour(bond: str, share: float) -> tuple[float, float, float]:
    """Returns the colour of a face that has slipped by a share of the largest slip."""
    return _blocks._slip_colour(share) if bond in _SLIPPED else _blocks._BONDED_COLOUR


def _face_parts(scene: Scene) -> tuple[_Floats, list[str], _Floats]:
    """Returns the ends (k, 2, 2) of the parts of faces in the order of drawing, their bonds, and their slips (k)."""
    state = scene.state
    contacts = getattr(state, "contacts", None)
    if contacts is None or "law" not in contacts.dtype.names or not np.any(contacts["law"]):
        raise ValueError("no contact has the law of a joint, which the cards JOINT and JPAIR give")
    return _blocks._face_parts(state.corners, state.first_corner, contacts)
