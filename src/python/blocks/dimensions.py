"""Units of quantities, written as the program writes them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

__all__ = ["Dimension", "Units", "unit_text"]


class Units(NamedTuple):
    """The units of a deck, as its UNITS card names them."""

    length: str
    mass: str
    time: str


@dataclass(frozen=True)
class Dimension:
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


NONE = Dimension()
LENGTH = Dimension(1, 0, 0, "m")
AREA = Dimension(2, 0, 0, "m²")
TIME = Dimension(0, 0, 1, "s")
VELOCITY = Dimension(1, 0, -1, "m/s")
DEGREES = Dimension(0, 0, 0, "degrees", "degrees")
RADIANS = Dimension(0, 0, 0, "rad", "rad")
SPIN = Dimension(0, 0, -1, "rad/s", "rad")
FORCE = Dimension(0, 1, -2, "N/m")
MOMENT = Dimension(1, 1, -2, "N m/m")
STRESS = Dimension(-1, 1, -2, "Pa")
STRAIN_RATE = Dimension(0, 0, -1, "1/s")
MASS = Dimension(-1, 1, 0, "kg/m")
INERTIA = Dimension(1, 1, 0, "kg m")
ENERGY = Dimension(1, 1, -2, "J/m")
MOMENTUM = Dimension(0, 1, -1, "N s/m")
ANGULAR_MOMENTUM = Dimension(1, 1, -1, "N s")

_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit_text(dimension: Dimension, units: Units | None) -> str:
    """Returns a unit as the program writes it: "m/s", or "cm ms⁻¹" in other units.

    Without units of the deck, L, M and T replace them: "L T⁻¹". The unit of a quantity without a dimension is
    empty.
    """
    if units == ("m", "kg", "s") and dimension.si:
        return dimension.si
    length, mass, time = units or ("L", "M", "T")
    parts = [dimension.angle] if dimension.angle else []
    for name, power in ((mass, dimension.mass), (length, dimension.length), (time, dimension.time)):
        if power != 0:
            parts.append(name if power == 1 else name + str(power).translate(_SUPERSCRIPTS))
    return " ".join(parts)
