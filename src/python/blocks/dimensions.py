"""Units of quantities, written as the program writes them."""

from __future__ import annotations

from typing import NamedTuple

from ._blocks import _unit_text

__all__ = ["Dimension", "Units", "unit_text"]


class Units(NamedTuple):
    """The units of a deck, as its UNITS card names them."""

    length: str
    mass: str
    time: str


class Dimension(NamedTuple):
    """Powers of length, mass and time, per unit thickness.

    Attributes:
        length, mass, time: the powers.
        si: usual name of the unit if the units are m, kg, s.
        angle: "rad" or "degrees", written before the other units.
    """

    length: int = 0
    mass: int = 0
    time: int = 0
    si: str = ""
    angle: str = ""


def unit_text(dimension: Dimension, units: Units | None) -> str:
    """Returns a unit as the program writes it: "m/s", or "cm ms⁻¹" in other units.

    Without units of the deck, L, M and T replace them: "L T⁻¹". The unit of a quantity without a dimension is
    empty.
    """
    return _unit_text(dimension, units)
