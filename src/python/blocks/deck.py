"""Decks built in Python: a method for each card."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from ._blocks import _replace_file, card_table
from .card_methods import add_card_methods

__all__ = ["Deck"]


class Deck:
    """A deck of cards.

    Each card is a method with its name in small letters, whose arguments are the fields of the card. Fields
    without a value keep their defaults. Texts are quoted where a card needs it. Lines that follow a card are
    its argument `lines`: for each line a text, which is not changed, or a sequence of numbers. Every method
    returns the deck, so calls can be joined.

        deck = blocks.Deck()
        deck.start(100, 4, lines=["TWO BLOCKS"])
        deck.xlimits(-5, 5).ylimits(-1, 9)
        ...
        deck.create(4, 1, 1, lines=[(-5, -5, 5, 5), (-1, 0, 0, -1)])

    Args:
        text: cards with which the deck begins.

    Attributes:
        name: the name of the deck in messages.
    """

    def __init__(self, text: str = "", name: str = "deck"):
        self.name = name
        self._lines = _lines_of(text)

    @classmethod
    def read(cls, path: str | os.PathLike) -> Deck:
        """Reads a deck from a file. Names of files on its cards are then relative to the current folder."""
        return cls(Path(path).read_text(encoding="utf-8", errors="replace"), os.fspath(path))

    @property
    def text(self) -> str:
        """The deck as text, one card a line."""
        return "".join(line + "\n" for line in self._lines)

    def card(self, name: str, *fields: Any, lines: Iterable[Iterable[Any] | str] = ()) -> Deck:
        """Adds a card by its name, and the line or lines that follow it. A field that is None stays blank.

        Raises:
            ValueError: if a card cannot have such a text: one with a line end, or with both kinds of quotes
                and a blank, a comma, $ or !.
        """
        words = [_word(field) for field in fields]
        while words and not words[-1]:
            words.pop()
        if _needs_quotes(name):
            raise ValueError(f"the name of a card is one word, not {name!r}")
        added = [", ".join([name.upper(), *words])]
        for line in [lines] if isinstance(lines, str) else lines:
            added.append(_one_line(line) if isinstance(line, str) else ", ".join(_word(value) for value in line))
        self._lines += added
        return self

    def insert(self, before: str, cards: Deck | str) -> Deck:
        """Inserts cards before the first card with this name.

        Raises:
            ValueError: if the deck has no such card.
        """
        title = next((i + 1 for i, line in enumerate(self._lines) if _first_word(line) == "START"), None)
        for i, line in enumerate(self._lines):
            if i != title and _first_word(line) == before.upper():
                self._lines[i:i] = _lines_of(cards.text if isinstance(cards, Deck) else cards)
                return self
        raise ValueError(f"the deck has no card {before.upper()}")

    def comment(self, text: str) -> Deck:
        """Adds comment lines."""
        self._lines += ["$ " + line for line in _lines_of(text)]
        return self

    def write(self, path: str | os.PathLike) -> Path:
        """Writes the deck to a file, and returns its path.

        An older file with this path is kept as PATH.bak, PATH.bak2, ..., unless it has the same text.

        Raises:
            FileError: if the file cannot be written, or the path is a link, a folder or a device.
        """
        path, text = Path(path), self.text
        if path.is_symlink() or not path.is_file() or path.read_bytes() != text.encode():
            _replace_file(os.fspath(path), text)
        return path

    def __str__(self) -> str:
        return self.text

    def __len__(self) -> int:
        return len(self._lines)

    def __repr__(self) -> str:
        return f"<Deck {self.name}: {len(self)} lines>"


def _first_word(line: str) -> str:
    """Returns the name of the card on a line, in capitals."""
    return re.split(r"[\s,]", line.strip(), maxsplit=1)[0].upper()


def _word(value: Any) -> str:
    """Returns a field in the form of a card. Numbers keep all their digits."""
    if hasattr(value, "item"):
        value = value.item()  # of NumPy
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(int(value))
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, int):
        return str(value)
    if isinstance(value, (str, os.PathLike)):
        return quoted(os.fspath(value))
    raise TypeError(f"a field of a card is a number, a text or None, not {value!r}")


def _lines_of(text: str) -> list[str]:
    """Returns the lines of a text as a deck has them: only LF, CR LF and CR end a line."""
    lines = re.split("\r\n|\r|\n", text)
    return lines if lines[-1] else lines[:-1]


def _one_line(text: str) -> str:
    """Returns the text. Raises ValueError if it has a line end or another control character."""
    if re.search("[\0-\x08\n\r\x0e-\x19\x1b-\x1f\x7f]", text):
        raise ValueError(f"a deck cannot have this text in a line: {text!r}")
    return text


def _needs_quotes(text: str) -> bool:
    """Whether a card would read the text as several fields, as a comment, or as a quoted text."""
    return bool(re.search("^['\"]|[ \t\f\v\x1a\xa0,$!\n\r]", text))


def quoted(text: str) -> str:
    """Returns a text as one field of a card."""
    if not _needs_quotes(_one_line(text)):
        return text
    quote = next((quote for quote in "\"'" if quote not in text), None)
    if quote is None:
        raise ValueError(f"a card cannot have both kinds of quotes in one text: {text!r}")
    return quote + text + quote


add_card_methods(Deck, card_table())
