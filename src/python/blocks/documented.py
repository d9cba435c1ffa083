"""Properties whose help is the section "Attributes" of the docstring of their class."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

__all__ = ["add_properties", "attributes_of"]


def attributes_of(cls: type) -> dict[str, str]:
    """Returns the text of each attribute that the docstring of a class lists."""
    section = (inspect.getdoc(cls) or "").partition("Attributes:\n")[2]
    found = re.findall(r"^    (\w+): (.*(?:\n     .*)*)", section, re.MULTILINE)
    return {name: re.sub(r"\n +", "\n", text) for name, text in found}


def add_properties(cls: type, source: Callable[[Any], Any]) -> None:
    """Adds a read-only property for each listed attribute that the class does not have.

    Args:
        cls: the class.
        source: returns the object that has the values, from an object of the class.
    """
    for name, text in attributes_of(cls).items():
        if name not in vars(cls):
            setattr(cls, name, _property(name, text, source))


def _property(name: str, text: str, source: Callable[[Any], Any]) -> property:
    return property(lambda self: getattr(source(self), name), doc=text)
