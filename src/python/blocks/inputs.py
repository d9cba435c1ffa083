"""What functions accept as a deck, and as values that replace fields of cards."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from typing import Any, Union

from .deck import Deck

#: A deck: its text (with at least one line end), the path of a file, or a `Deck`.
DeckLike = Union[str, os.PathLike, Deck]


def name_and_text(deck: DeckLike) -> tuple[str, str | None]:
    """Returns the name of a deck in messages and its text, or its path and None."""
    if isinstance(deck, Deck):
        return deck.name, deck.text
    if isinstance(deck, str) and "\n" in deck:
        return "deck", deck
    path = os.fsdecode(deck)
    if not path:
        raise ValueError("the path of the deck is empty")
    return path, None


def whole(value: Any, name: str, least: int, most: int = 2**62) -> int:
    """Returns a whole number in a range. Raises TypeError or ValueError that names it."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is not a whole number: {value!r}") from None
    if not least <= number <= most:
        raise ValueError(f"{name} is not in range {least} to {most}: {number}")
    return number


def seed_of(value: Any) -> int | None:
    """Returns the seed of random numbers, or None."""
    return None if value is None else whole(value, "seed", 0, 2**64 - 1)


def sets_of(values: Mapping[str, Any] | None) -> list[str]:
    """Returns CARD.field=value for each item."""
    return [f"{name}={value}" for name, value in (values or {}).items()]
