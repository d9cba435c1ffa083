"""Colours of materials, outlines and contact forces, those of `blocks plot`."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import colors
from numpy.typing import NDArray

__all__ = ["FORCES", "INK", "MAPS", "WHOLE", "is_dark", "luminance", "material_colour", "mix", "outlines_on"]

INK = (0.16, 0.16, 0.18)
WHOLE = "#e4e4e4"  # blocks without a colour of their own, and fixed ones
MAPS = {"lowest": "YlGnBu", "middle": "RdBu_r", "none": "viridis"}  # by the meaning of zero
FORCES = colors.LinearSegmentedColormap.from_list(
    "forces", ["#fec488", "#fc8961", "#e75263", "#b73779", "#832681", "#51127c", "#1d1147"]
)
_MATERIALS = ("#c9b79c", "#6b7f8f", "#b5886b", "#8fa88b", "#d8c27a", "#8a7a99", "#a9c1cf", "#7d6b5d")
_SHADES = (("white", 0.0), ("white", 0.5), ("black", 0.35), ("white", 0.75), ("black", 0.6))

_Colours = NDArray[np.float64]


def mix(a: Any, b: Any, share: float) -> _Colours:
    """Returns the colours (k, 3) that consist of a, with this share, and b."""
    first, second = (np.asarray(colors.to_rgba_array(c))[:, :3] for c in (a, b))
    return share * first + (1.0 - share) * second


def material_colour(material: int) -> str:
    """Returns the colour "#c9b79c" of a material, by the number of its card."""
    index = (material - 1) % (len(_MATERIALS) * len(_SHADES))
    shade, share = _SHADES[index // len(_MATERIALS)]
    return colors.to_hex(mix(shade, _MATERIALS[index % len(_MATERIALS)], share)[0])


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
