"""Blocks, sides and corners by position, material or joint id, as the selectors of cards choose them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["Selectors"]


class Selectors:
    """Functions of a model that return the numbers of its blocks, from 0. Removed blocks are never chosen."""

    @property
    def _chooser(self) -> Any:
        """The object of the extension module that holds the blocks."""
        return self

    def block_at(self, x: float, y: float) -> int:
        """Returns the block that contains the point (x, y) [L]; on a common side, the lowest number.

        The decision is exact for the present corners.

        Raises:
            LookupError: if no block contains it.
        """
        block = self._chooser._block_at(x, y)
        if block < 0:
            raise LookupError(f"no block contains the point ({x:g}, {y:g})")
        return block

    def blocks_in(self, x1: float, y1: float, x2: float, y2: float) -> NDArray[np.int64]:
        """Returns the blocks whose centroid is in the box between two points [L], its sides included."""
        return np.array(self._chooser._blocks_in(x1, y1, x2, y2), dtype=np.int64)

    def blocks_of_material(self, material: int | str) -> NDArray[np.int64]:
        """Returns the blocks of a material, by its number or its name.

        Raises:
            LookupError: if no material has this name.
        """
        if isinstance(material, str):
            numbers = [number for number, name in self.materials.items() if name == material]
            if not numbers:
                raise LookupError(f"no material has the name {material!r}")
            material = numbers[0]
        return np.flatnonzero((self.material == material) & ~self.is_removed)

    def sides_of_joint(self, joint: int) -> NDArray[np.int64]:
        """Returns the sides (k, 2) with a joint id: the block, and the side in it; both from 0."""
        return _pairs(self._chooser._sides_of_joint(joint))

    def sides_on(self, x1: float, y1: float, x2: float, y2: float, tolerance: float = 0.0) -> NDArray[np.int64]:
        """Returns the sides (k, 2) on the line between two points [L]: the block, and the side in it; both from 0.

        Both corners lie on the line, up to `tolerance` [L], but at least 1e-9 of its length. Blocks that have moved
        need a tolerance, such as ctol of BOXES.
        """
        return _pairs(self._chooser._sides_on(x1, y1, x2, y2, tolerance))

    def nearest_corner(self, x: float, y: float) -> tuple[int, int]:
        """Returns the block and the number in it, both from 0, of the corner nearest to the point (x, y) [L].

        Raises:
            LookupError: if there are no blocks.
        """
        block, corner = self._chooser._nearest_corner(x, y)
        if block < 0:
            raise LookupError("there are no blocks")
        return block, corner


def _pairs(values: list[tuple[int, int]]) -> NDArray[np.int64]:
    return np.array(values, dtype=np.int64).reshape(-1, 2)
