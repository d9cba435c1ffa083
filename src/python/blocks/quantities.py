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
from .dimensions import Dimension

__all__ = ["KINDS", "QUANTITIES", "Kind", "kind_of", "kind_of_curve", "quantity", "quantity_names"]

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
    dimension: Dimension = Dimension()
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


#: Each quantity of a block, of the contacts or of the model that the program knows, by the name that a HISTORY
#: card gives it: its label, its dimension, and whether it has a sign.
KINDS: dict[str, tuple[str, Dimension, bool]] = {
    name: (label, Dimension(*dimension), is_signed)
    for name, (label, dimension, is_signed) in _blocks._quantity_kinds().items()
}


def _known(name: str, attribute: str, part: Callable[[Any], Any] = lambda values: values, zero: str = "none") -> Kind:
    """Returns a kind that the program knows; `zero` is that of a quantity without a sign."""
    label, dimension, is_signed = KINDS[name]
    return Kind(label, dimension, "middle" if is_signed else zero, attribute, part)


#: The quantities of blocks. Most have the names of `blocks plot --colour`.
QUANTITIES: dict[str, Kind] = {
    "speed": _known("speed", "velocity", _length, "lowest"),
    "displacement": _known("displacement", "displacement", _length, "lowest"),
    "rotation": _known("rotation", "angle", _degrees),
    "x": _known("x", "centroid", _entry(0)),
    "y": _known("y", "centroid", _entry(1)),
    "dx": _known("dx", "displacement", _entry(0)),
    "dy": _known("dy", "displacement", _entry(1)),
    "vx": _known("vx", "velocity", _entry(0)),
    "vy": _known("vy", "velocity", _entry(1)),
    "spin": _known("spin", "spin"),
    "fx": _known("fx", "force", _entry(0)),
    "fy": _known("fy", "force", _entry(1)),
    "moment": _known("moment", "moment"),
    "p1": _known("p1", "stress", lambda tensors: _blocks._principal(tensors, 1.0)),
    "p2": _known("p2", "stress", lambda tensors: _blocks._principal(tensors, -1.0)),
    "unbalanced": _known("unbalanced", "unbalanced", zero="lowest"),
    "local_ratio": _known("local_ratio", "local_ratio", zero="lowest"),
    "water_x": _known("water_x", "water_force", _entry(0)),
    "water_y": _known("water_y", "water_force", _entry(1)),
    "mass": _known("mass", "mass"),
    "area": _known("area", "area"),
    "inertia": _known("inertia", "inertia"),
    "angle": Kind("angle", Dimension(si="rad", angle="rad"), "middle", "angle"),
    "velocity": _known("speed", "velocity", _length, "lowest"),
    "force": Kind("force", KINDS["fx"][1], "lowest", "force", _length),
    "contact_force": Kind("contact force", KINDS["fx"][1], "lowest", "contact_force", _length),
}
for _letter, _attribute in ("s", "stress"), ("a", "applied_stress"), ("e", "strain_rate"):
    for _i, _j in (0, 0), (0, 1), (1, 0), (1, 1):
        _name = f"{_letter}{_i + 1}{_j + 1}"
        if _name in KINDS:  # e21 is the same as e12
            QUANTITIES[_name] = _known(_name, _attribute, _entry(_i, _j))


def kind_of_curve(name: str) -> Kind:
    """Returns the kind of a quantity of HISTORY, such as "y:3" or "energy:friction"; "t" is the time."""
    quantity = name.partition(":")[0]
    known = KINDS.get("time" if name == "t" else name) or KINDS.get(quantity)
    return Kind(*known[:2]) if known else Kind(quantity)


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
