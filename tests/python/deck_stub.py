"""Writes the type stub of blocks.Deck, whose methods are made from the card table.

./go python tests/python/deck_stub.py > src/python/blocks/deck.pyi
"""

import inspect

from blocks import Deck, card_table

HEAD = '''\
# Written by tests/python/deck_stub.py; do not edit.
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


def stub() -> str:
    """Returns the text of the stub."""
    text = HEAD
    for card in card_table():
        method = getattr(Deck, card["name"].lower())
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
        text += f"    def {method.__name__}({', '.join(words)}) -> Deck: ...\n"
    return text


if __name__ == "__main__":
    print(stub(), end="")
