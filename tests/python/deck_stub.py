"""Writes the type stubs of blocks.Deck and blocks.SimulationCards, whose methods are made from the card table.

./go python tests/python/deck_stub.py src/python/blocks
"""

import inspect
import sys
from pathlib import Path

from blocks import Deck, SimulationCards, card_table

MARK = "# Written by tests/python/deck_stub.py; do not edit.\n"

DECK = '''\
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from .assembly import Assembly
from .running import Run

_Number = float | int | str | None
_Lines = Iterable[str | Iterable[Any]]

class Deck:
    name: str
    def __init__(self, text: str = ..., name: str = ...) -> None: ...
    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Deck: ...
    @property
    def text(self) -> str: ...
    def card(self, name: str, *fields: Any, lines: _Lines = ...) -> Deck: ...
    def insert(self, before: str, cards: Deck | str) -> Deck: ...
    def comment(self, text: str) -> Deck: ...
    def write(self, path: str | os.PathLike[str]) -> Path: ...
    def check(self, **options: Any) -> Assembly: ...
    def run(self, **options: Any) -> Run: ...
    def __len__(self) -> int: ...
'''


SIMULATION_CARDS = '''\
from collections.abc import Callable, Iterable
from typing import Any

from .deck import Deck

_Number = float | int | str | None
_Lines = Iterable[str | Iterable[Any]]

class SimulationCards:
    def __init__(self, execute: Callable[[str], None]) -> None: ...
    def __call__(self, text: str | Deck) -> None: ...
    def card(self, name: str, *fields: Any, lines: _Lines = ...) -> SimulationCards: ...
'''


def methods_of(cls: type) -> str:
    """Returns the lines of a stub for the methods that are made from cards."""
    text = ""
    for card in card_table():
        method = getattr(cls, card["name"].lower(), None)
        if method is None:
            continue
        words = []
        for parameter in inspect.signature(method).parameters.values():
            if parameter.name == "self":
                words.append("self")
            elif parameter.kind is parameter.VAR_POSITIONAL:
                words.append(f"*{parameter.name}: _Number")
            elif parameter.kind is parameter.KEYWORD_ONLY:
                words += ["*"] if not any(word.startswith("*") for word in words) else []
                words.append(f"{parameter.name}: _Lines = ...")
            else:
                words.append(f"{parameter.name}: _Number" + (" = ..." if parameter.default is None else ""))
        text += f"    def {method.__name__}({', '.join(words)}) -> {cls.__name__}: ...\n"
    return text


def stubs() -> dict[str, str]:
    """Returns the texts of the stubs by the names of their files."""
    return {
        "deck.pyi": MARK + DECK + methods_of(Deck),
        "simulation_cards.pyi": MARK + SIMULATION_CARDS + methods_of(SimulationCards),
    }


if __name__ == "__main__":
    for name, text in stubs().items():
        (Path(sys.argv[1]) / name).write_text(text)
