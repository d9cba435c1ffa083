"""Colours of materials, joints, outlines and contact forces, those of `blocks plot`."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import colors
from numpy.typing import NDArray

from . import _blocks

__all__ = [
    "FORCES", "INK", "MAPS", "WHOLE", "is_dark", "joint_colour", "luminance", "material_colour", "mix", "outlines_on",
]

INK = (0.16, 0.16, 0.18)
WHOLE = "#e4e4e4"  # blocks without a colour of their own, and fixed ones
MAPS = {"lowest": "YlGnBu", "middle": "RdBu_r", "none": "viridis"}  # by the meaning of zero
FORCES = colors.ListedColormap([_blocks._force_colour(i / 255) for i in range(256)], "forces")

_Colours = NDArray[np.float64]


def mix(a: Any, b: Any, share: float) -> _Colours:
    """Returns the colours (k, 3) that consist of a, with this share, and b."""
    first, second = (np.asarray(colors.to_rgba_array(c))[:, :3] for c in (a, b))
    return share * first + (1.0 - share) * second


def material_colour(material: int) -> str:
    """Returns the colour "#c9b79c" of a material, by the number of its card."""
    return colors.to_hex(_blocks._material_colour(material))


def joint_colour(joint: int) -> str:
    """Returns the colour "#004587" of a joint id from 1."""
    return colors.to_hex(_blocks._joint_colour(joint))


def luminance(colour: _Colours) -> _Colours:
    """Relative luminances of colours (k, 3 or 4), from 0 for black to 1 for white."""
    s = colour[:, :3]
    linear = np.where(s <= 0.04045, s / 12.92, ((s + 0.055) / 1.055) ** 2.4)
    return linear @ np.array([0.2126, 0.7152, 0.0722])


def is_dark(ground: _Colours) -> NDArray[np.bool_]:
    """Whether white is easier to see than black on each colour."""
    return luminance(ground) < 0.179


def outlines_on(ground: _Colours, faint: bool) -> _Colours:
    """Returns colours of outlines: darker than a light ground, lighter than a dark one."""
    on_dark = mix(ground, "white", 0.7 if faint else 0.4)
    on_light = mix(ground, "black", 0.65 if faint else 0.3)
    return np.where(is_dark(ground)[:, None], on_dark, on_light)
