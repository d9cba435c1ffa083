"""Cards that a simulation executes."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from ._blocks import card_table
from .card_methods import add_card_methods
from .deck import Deck

__all__ = ["SimulationCards"]

_OF_A_GROUP = ("CLOOP", "OUTLINE", "JSET", "TRACES", "VORONOI", "CUT")  # need the cards beside them
_WITHOUT_EFFECT = ("DUMP", "HISTORY", "OUTPUT", "PLOTS", "STOP")  # a simulation writes no files of its own


class SimulationCards:
    """Executes further problem cards in a simulation, as text, as a `Deck`, or by a method for each card.

    Methods have the fields of the card as arguments, as those of `Deck` have. They return the cards, so calls
    can be joined. Cards count blocks from 1. CLOOP, and OUTLINE to CUT, need the cards beside them: give them
    together, as a text or a `Deck`.

        sim.cards("FRICTN, 0.4")
        sim.cards.frictn(0.4).joint(1, fric=0.7, coh=2e5, kn=1e9).bond(1)
        sim.cards(blocks.Deck().cloop(3, 1.5).create(...))

    Raises:
        DeckError: if the cards contain errors. The model is then unchanged, unless a MOTION, CYCLE or SOLVE
            among them has advanced the time.
    """

    def __init__(self, execute: Callable[[str], None]):
        self._execute = execute

    def __call__(self, text: str | Deck) -> None:
        """Executes cards, one a line."""
        self._execute(text if isinstance(text, str) else text.text)

    def card(self, name: str, *fields: Any, lines: Iterable[Iterable[Any] | str] = ()) -> SimulationCards:
        """Executes a card by its name, with the line or lines that follow it. See `Deck.card`."""
        self._execute(Deck().card(name, *fields, lines=lines).text)
        return self

    def __repr__(self) -> str:
        return "<SimulationCards: call it with cards, or use a method such as frictn(0.4)>"


add_card_methods(
    SimulationCards,
    [
        card
        for card in card_table()
        if card["phase"] == "problem" and card["name"] not in _OF_A_GROUP + _WITHOUT_EFFECT
    ],
)
