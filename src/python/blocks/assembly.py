"""Blocks with the certificate that no two of them overlap, before anything moves."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from . import _blocks, exports
from .deck import Deck
from .dimensions import Units
from .documented import add_properties
from .inputs import DeckLike, name_and_text, seed_of, sets_of, whole
from .notebooks import html_of
from .selectors import Selectors

__all__ = ["Assembly", "check", "joints", "layers"]


class Assembly(Selectors):
    """Blocks and their certificate, as `blocks check` makes them. n blocks have m corners.

    Arrays cannot be written to.

    Attributes:
        corners: (m, 2) [L] corners of all blocks, clockwise.
        first_corner: (n + 1,) block b has the corners from first_corner[b] to first_corner[b + 1], half open.
        joint: (m,) joint id of the side that begins at each corner; 0: none.
        centroid: (n, 2) [L].
        area: (n,) [L^2].
        mass: (n,) [M].
        material: (n,) number of the MATERIAL card.
        is_free: (n,) False if fixed, driven, outside the domain or removed. A copy.
        is_removed: (n,) True for blocks that REMOVE has taken out. A copy.
        layer: (n,) LAYER card that made the block, from 1; 0: none.
        certificate: dict with the result of the exact check of every pair of blocks: `holds`, the numbers
            of `overlaps`, `roundings`, `gaps`, `rounding_slits` and `t_junctions`, `largest_rounding` (a part
            of the smaller area) and the `verdict` in words.
        report: what `blocks check` prints.
        time_step: [T] that a run would take.
        seed: of the random layers.
        title: of the deck.
        materials: names of the materials that have one, by number.
        units: names of the units `length`, `mass` and `time`; None if the deck names none.
    """

    def __init__(self, checked: _blocks.Checked):
        self._checked = checked

    def __len__(self) -> int:
        return len(self._checked)

    @property
    def _chooser(self) -> _blocks.Checked:
        return self._checked

    @property
    def units(self) -> Units | None:
        """Names of the units; None if the deck names none."""
        return Units(*self._checked._units) if self._checked._units else None

    @property
    def polygons(self) -> list[np.ndarray]:
        """The outline (k, 2) of each block, [L], clockwise: views of `corners`. Removed blocks keep theirs."""
        return np.split(self.corners, self.first_corner[1:-1]) if len(self) else []

    def to_deck(self, deck: Deck, fixed: Iterable[int] = ()) -> Deck:
        """Adds a CREATE card for each block that is not removed to a deck. Returns the deck.

        Args:
            deck: the deck.
            fixed: blocks that cannot move, from 0.
        """
        held = set(fixed)
        material, polygons = self.material.tolist(), self.polygons
        for b in np.flatnonzero(~self.is_removed):
            outline = polygons[b]
            deck.create(len(outline), material[b], int(b in held), lines=[outline[:, 0], outline[:, 1]])
        return deck

    def to_geojson(self, path: str | os.PathLike | None = None) -> str | None:
        """Writes the blocks as `blocks export` does for a deck, a GeoJSON feature for each.

        Blocks have the numbers of the cards, from 1. Removed blocks are left out. An older file with this path
        is kept as PATH.bak, PATH.bak2, ...

        Args:
            path: of the file; None: return the text.

        Raises:
            FileError: if the file cannot be written, or the path is a link.
        """
        text = exports.geojson_of_assembly(self)
        if path is None:
            return text
        _blocks._replace_file(os.fspath(path), text)
        return None

    def plot(self, ax=None, **options: Any):
        """Draws the blocks on Matplotlib axes; see `blocks.plotting.plot`."""
        from .plotting import plot
        return plot(self, ax, **options)

    def _repr_html_(self) -> str:
        return html_of(self)

    def __repr__(self) -> str:
        return f"<Assembly: {len(self)} blocks, {self.certificate.get('verdict', 'no certificate')}>"


add_properties(Assembly, lambda assembly: assembly._checked)


def check(deck: DeckLike, *, seed: int | None = None, set: Mapping[str, Any] | None = None) -> Assembly:
    """Checks a deck and makes its blocks, without a step.

    Args:
        deck: text, path or `Deck`.
        seed: of the random layers; replaces that of the SEED card.
        set: fields of cards to replace, as `{"FRICTN.fric": 0.4}`.

    Returns:
        The blocks before the first motion, with their certificate. A deck without MOTION, CYCLE and SOLVE is
        one that a program drives, so there is no warning about that.

    Raises:
        DeckError: if there are errors. Warnings become `DeckWarning`.
    """
    name, text = name_and_text(deck)
    return Assembly(_blocks._check(name, text, seed_of(seed), sets_of(set)))


setattr(Deck, "check", check)  # deck.check(...)


def _frame(points: np.ndarray, blocks: int, corners: int, units: Sequence[str] | None) -> Deck:
    """Returns the cards before END for blocks around these points."""
    low, high = points.min(axis=0), points.max(axis=0)
    size = float((high - low).max())
    deck = Deck(name="blocks")
    deck.start(blocks, corners, lines=["BLOCKS"])
    deck.xlimits(float(low[0] - size), float(high[0] + size))
    deck.ylimits(float(low[1] - size), float(high[1] + size))
    deck.boxes(10, 10, size * 1e-3).stiff(1e9, 1e9).fraction(0.05)
    deck.material(1, 1e9, 4e8, 2500.0)
    if units is not None:
        deck.units(*units)
    return deck.rigid()


def layers(quadrilaterals: Sequence[Any], blocks: int | Sequence[int], *, seed: int = 1982,
           random: bool = True, units: Sequence[str] | None = None) -> Assembly:
    """Cuts layers of rock into blocks (LAYER).

    Args:
        quadrilaterals: (k, 4, 2) [L] the corners of each layer, clockwise from the lower left one; or (4, 2)
            for one layer.
        blocks: number of blocks of every layer, or (k,) of each.
        seed: of the random widths.
        random: random blocks; False: blocks of equal width.
        units: names of the units of length, mass and time, for figures.

    Returns:
        The blocks with their certificate.
    """
    shapes = np.asarray(quadrilaterals, dtype=float)
    if shapes.shape == (4, 2):
        shapes = shapes[None]
    if shapes.ndim != 3 or shapes.shape[1:] != (4, 2):
        raise ValueError(f"quadrilaterals must have the shape (k, 4, 2), not {shapes.shape}")
    given = [blocks] * len(shapes) if np.ndim(blocks) == 0 else list(blocks)
    if len(given) != len(shapes):
        raise ValueError(f"there are {len(shapes)} layers, and numbers of blocks for {len(given)}")
    counts = [whole(count, "the number of blocks of a layer", 1, 1_000_000) for count in given]
    deck = _frame(shapes.reshape(-1, 2), sum(counts) + 1, 12, units)
    deck.seed(seed).end()
    for shape, count in zip(shapes, counts):
        deck.layer(-count, 1, *shape.ravel(), *(["RANDOM"] if random else []))
    return check(deck.cycle(1))


def joints(outline: Any, sets: Iterable[Mapping[str, Any]] = (), traces: Any = None, *,
           seed: int = 1982, units: Sequence[str] | None = None, **cut: Any) -> Assembly:
    """Cuts an outline into blocks along joints (OUTLINE, JSET, TRACES, CUT).

    Args:
        outline: (k, 2) [L] clockwise.
        sets: for each set of joints the fields of its JSET card by name.
        traces: file of traces, for a TRACES card.
        seed: of the random joints.
        units: names of the units of length, mass and time, for figures.
        cut: fields of the CUT card by name.

    Returns:
        The blocks with their certificate.
    """
    corners = np.asarray(outline, dtype=float)
    if corners.ndim != 2 or corners.shape[1] != 2:
        raise ValueError(f"outline must have the shape (k, 2), not {corners.shape}")
    deck = _frame(corners, 1_000_000, 1000, units)
    deck.seed(seed).end()
    deck.card("OUTLINE", len(corners), 1, lines=[corners[:, 0], corners[:, 1]])
    for one in sets:
        deck.jset(**one)
    if traces is not None:
        deck.traces(traces)
    return check(deck.cut(**cut).cycle(1))
