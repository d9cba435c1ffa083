"""What a picture of blocks needs from a Frame, a Simulation or an Assembly."""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .dimensions import unit_text
from .figures import math_text
from .quantities import kind_of

__all__ = ["MARGIN", "Scene"]

MARGIN = 0.03  # between blocks and frame, as a share of the larger extent

_Floats = NDArray[np.float64]
_Bools = NDArray[np.bool_]


class Scene:
    """The blocks of a picture.

    Args:
        state: a Frame, a Simulation or an Assembly: it has `polygons`, `centroid`, `area`, `material` and a
            length. It may have `is_free`, `is_removed`, `units` and `materials`.

    Attributes:
        state: the object itself, for quantities and contacts.
        is_removed: (n,).
        is_fixed: (n,) whether each block is neither free nor removed; all False if that is not known.
        polygons: the outline (k, 2) of each block, [L]; without corners if it has been removed.
        materials: names of the materials that have one, by number.
    """

    def __init__(self, state: Any):
        none = np.zeros(len(state), bool)
        self.state = state
        self.is_removed: _Bools = getattr(state, "is_removed", none)
        self.is_fixed: _Bools = ~getattr(state, "is_free", ~none) & ~self.is_removed
        self.polygons: list[_Floats] = [
            outline[:0] if gone else outline for outline, gone in zip(state.polygons, self.is_removed)
        ]
        self.materials: dict[int, str] = getattr(state, "materials", {})

    def __len__(self) -> int:
        return len(self.is_removed)

    @functools.cached_property
    def extent(self) -> tuple[_Floats, _Floats]:
        """[L] Lower left and upper right of all blocks; (0, 0) and (1, 1) without blocks."""
        corners = [outline for outline in self.polygons if len(outline)]
        if not corners:
            return np.zeros(2), np.ones(2)
        together = np.concatenate(corners)
        return together.min(axis=0), together.max(axis=0)

    @property
    def shape(self) -> float:
        """Height of the picture in its widths."""
        low, high = self.extent
        width, height = np.maximum(high - low + 2 * MARGIN * np.max(high - low), 1e-300)
        return float(height / width)

    @property
    def block_size(self) -> float:
        """[L] size of an ordinary block: the square root of the median area."""
        areas = self.state.area[~self.is_removed]
        return math.sqrt(float(np.median(areas))) if areas.size else 1.0

    def unit(self, quantity: str) -> str:
        """Returns the unit of a quantity in brackets, with a blank before; empty if there is none."""
        unit = unit_text(kind_of(quantity).dimension, getattr(self.state, "units", None))
        return f" [{math_text(unit)}]" if unit else ""
