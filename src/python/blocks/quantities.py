"""The quantities of blocks and of the model, with the names that the program gives them.

The functions accept each state of blocks of this package: a Frame, a Simulation or an Assembly.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _blocks
from . import dimensions as dim
from .dimensions import Dimension

__all__ = [
    "CURVES", "ENERGIES", "QUANTITIES", "Kind", "kind_of", "kind_of_curve", "quantity", "quantity_names",
]

_Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Kind:
    """What a quantity means.

    Attributes:
        label: what it is called on an axis.
        dimension: of its unit.
        zero: "middle" for a signed quantity, "lowest" for a magnitude, otherwise "none".
        attribute: the attribute of a state of blocks that it is computed from.
        part: returns its values (n,) from that attribute.
    """

    label: str
    dimension: Dimension = dim.NONE
    zero: str = "none"
    attribute: str = ""
    part: Callable[[NDArray[Any]], NDArray[Any]] = lambda values: values


def _entry(*index: int) -> Callable[[NDArray[Any]], NDArray[Any]]:
    return lambda values: values[(slice(None), *index)]


def _length(vectors: _Floats) -> _Floats:
    """Lengths of vectors (n, 2), with the same bits as the program computes."""
    return np.sqrt(vectors[:, 0] * vectors[:, 0] + vectors[:, 1] * vectors[:, 1])


def _degrees(angle: _Floats) -> _Floats:
    return angle * (180.0 / math.pi)


_TENSION = ", tension positive"

#: The quantities of blocks. Most have the names of `blocks plot --colour`.
QUANTITIES: dict[str, Kind] = {
    "speed": Kind("speed", dim.VELOCITY, "lowest", "velocity", _length),
    "displacement": Kind("displacement", dim.LENGTH, "lowest", "displacement", _length),
    "rotation": Kind("rotation", dim.DEGREES, "middle", "angle", _degrees),
    "x": Kind("x", dim.LENGTH, "none", "centroid", _entry(0)),
    "y": Kind("y", dim.LENGTH, "none", "centroid", _entry(1)),
    "dx": Kind("displacement x", dim.LENGTH, "middle", "displacement", _entry(0)),
    "dy": Kind("displacement y", dim.LENGTH, "middle", "displacement", _entry(1)),
    "vx": Kind("velocity x", dim.VELOCITY, "middle", "velocity", _entry(0)),
    "vy": Kind("velocity y", dim.VELOCITY, "middle", "velocity", _entry(1)),
    "spin": Kind("spin", dim.SPIN, "middle", "spin"),
    "fx": Kind("force x", dim.FORCE, "middle", "force", _entry(0)),
    "fy": Kind("force y", dim.FORCE, "middle", "force", _entry(1)),
    "moment": Kind("moment", dim.MOMENT, "middle", "moment"),
    "p1": Kind("principal stress 1" + _TENSION, dim.STRESS, "middle", "stress", lambda s: _blocks._principal(s, 1.0)),
    "p2": Kind("principal stress 2" + _TENSION, dim.STRESS, "middle", "stress", lambda s: _blocks._principal(s, -1.0)),
    "unbalanced": Kind("unbalanced force", dim.FORCE, "lowest", "unbalanced"),
    "local_ratio": Kind("local ratio", dim.NONE, "lowest", "local_ratio"),
    "water_x": Kind("force of water x", dim.FORCE, "middle", "water_force", _entry(0)),
    "water_y": Kind("force of water y", dim.FORCE, "middle", "water_force", _entry(1)),
    "mass": Kind("mass", dim.MASS, "none", "mass"),
    "area": Kind("area", dim.AREA, "none", "area"),
    "inertia": Kind("moment of inertia", dim.INERTIA, "none", "inertia"),
    "angle": Kind("angle", dim.RADIANS, "middle", "angle"),
    "velocity": Kind("speed", dim.VELOCITY, "lowest", "velocity", _length),
    "force": Kind("force", dim.FORCE, "lowest", "force", _length),
    "contact_force": Kind("contact force", dim.FORCE, "lowest", "contact_force", _length),
}
for _letter, _label, _attribute, _dimension in (
    ("s", "stress {}" + _TENSION, "stress", dim.STRESS),
    ("a", "applied stress {}" + _TENSION, "applied_stress", dim.STRESS),
    ("e", "strain rate {}", "strain_rate", dim.STRAIN_RATE),
):
    for _i, _j in ((0, 0), (0, 1), (1, 0), (1, 1)):
        _index = f"{_i + 1}{_j + 1}"
        QUANTITIES[_letter + _index] = Kind(
            _label.format(_index), _dimension, "middle", _attribute, _entry(_i, _j)
        )
del QUANTITIES["e21"]  # the same as e12

#: What a HISTORY card can record besides the quantities of blocks.
CURVES: dict[str, Kind] = {
    "kinetic_energy": Kind("kinetic energy", dim.ENERGY),
    "momentum_x": Kind("momentum x", dim.MOMENTUM),
    "momentum_y": Kind("momentum y", dim.MOMENTUM),
    "angular_momentum": Kind("angular momentum", dim.ANGULAR_MOMENTUM),
    "contacts": Kind("contacts"),
    "normal_force": Kind("normal contact force", dim.FORCE),
    "shear_force": Kind("shear contact force", dim.FORCE),
    "overlap": Kind("overlap", dim.LENGTH),
    "bonded": Kind("bonded contacts"),
    "failed": Kind("failed contacts"),
    "slip": Kind("slip", dim.LENGTH),
    "dilation": Kind("dilation", dim.LENGTH),
    "joint_length": Kind("length in contact", dim.LENGTH),
    "normal_stress": Kind("normal stress", dim.STRESS),
    "shear_stress": Kind("shear stress", dim.STRESS),
    "t": Kind("time", dim.TIME),
    "time": Kind("time", dim.TIME),
    "step": Kind("step"),
    "blocks": Kind("blocks"),
    "cracks": Kind("cracks"),
    "unbalanced_ratio": Kind("ratio of the unbalanced forces"),
    "unbalanced:local": Kind("largest local ratio"),
}

#: Labels of the quantities "energy:...".
ENERGIES: dict[str, str] = {
    "start": "energy at the start",
    "gravity": "work of gravity",
    "loads": "work of loads",
    "water": "work of water",
    "drives": "work of driven blocks",
    "dilation": "work of dilation",
    "kinetic": "kinetic energy",
    "elastic": "energy of springs",
    "strain": "strain energy of blocks",
    "friction": "energy taken by friction",
    "dashpots": "energy taken by dashpots",
    "breaking": "energy taken by breaking",
    "hysteresis": "energy taken by hysteresis",
    "transfer": "energy lost in transfers of springs",
    "removed": "energy removed",
    "artificial": "energy taken by artificial damping",
    "quiet": "energy through quiet sides",
    "cracks": "energy released by cracks",
    "integration": "error of the integration",
    "residual": "residual of the energies",
    "at_play": "energy at play",
}


def kind_of_curve(name: str) -> Kind:
    """Returns the kind of a quantity of HISTORY, such as "y:3" or "energy:friction"."""
    quantity, _, place = name.partition(":")
    if quantity == "energy" and place in ENERGIES:
        return Kind(ENERGIES[place], dim.ENERGY)
    return CURVES.get(name) or QUANTITIES.get(quantity) or CURVES.get(quantity) or Kind(quantity)


def kind_of(name: str) -> Kind:
    """Returns the kind of a quantity of blocks. That of another attribute has no unit."""
    return QUANTITIES.get(name) or Kind(name)


def quantity(state: Any, name: str) -> _Floats:
    """Returns one number for each block, (n,): a copy. Removed blocks have NaN.

    Args:
        state: a Frame, a Simulation or an Assembly.
        name: a name of QUANTITIES, or of an attribute with one number for each block.

    Raises:
        KeyError: if the state has no such quantity.
    """
    kind = kind_of(name)
    values = getattr(state, kind.attribute or name, None)
    values = kind.part(values) if isinstance(values, np.ndarray) else None
    if values is None or values.shape != (len(state),) or values.dtype.kind not in "biuf":
        raise KeyError(f"there is no quantity {name!r}: choose {', '.join(quantity_names(state))}")
    copy = np.array(values, np.float64)
    if (removed := getattr(state, "is_removed", None)) is not None:
        copy[removed] = math.nan
    return copy


def quantity_names(state: Any) -> tuple[str, ...]:
    """Returns the names of QUANTITIES that a state has."""
    attributes = set(dir(state))  # because the values of some attributes take long
    for name in ("unbalanced", "local_ratio"):
        if not hasattr(state, name):  # frames have it only if the deck asks for equilibrium
            attributes.discard(name)
    return tuple(name for name, kind in QUANTITIES.items() if kind.attribute in attributes)
