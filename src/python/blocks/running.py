"""Whole runs of a deck, as the command line makes them."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

from . import _blocks
from .deck import Deck
from .errors import BlocksError, FileError, UnsoundRun
from .inputs import DeckLike, name_and_text, seed_of, sets_of, whole
from .notebooks import html_of
from .results import Results, read

__all__ = ["Run", "run"]

#: Exit codes of the program (docs/README.md).
_UNSOUND, _FILES, _TIME_LIMIT, _INTERRUPTED = 4, 5, 75, 130


class Run:
    """A run that has ended, and its files.

    Attributes:
        name: path of the files without ending: name.out, name.vtkhdf, name.ckpt.h5, name.summary.json.
        summary: dict, the contents of name.summary.json.
    """

    def __init__(self, name: str):
        self.name = name
        self.summary: dict[str, Any] = json.loads(Path(name + ".summary.json").read_text(encoding="utf-8"))

    @property
    def title(self) -> str:
        """The title of the deck."""
        return self.summary["title"]

    @property
    def status(self) -> str:
        """'done', 'time limit', ..."""
        return self.summary["status"]

    @cached_property
    def results(self) -> Results:
        """The frames, histories, contacts and cracks of the run."""
        return read(self.name + ".vtkhdf")

    @property
    def listing(self) -> str:
        """The text of name.out."""
        return Path(self.name + ".out").read_text(encoding="utf-8")

    def __repr__(self) -> str:
        return f"<Run {self.name}: {self.status}, {self.summary['steps']} steps, time {self.summary['time']:g}>"

    def _repr_html_(self) -> str:
        return html_of(self, pictured=self.results[-1])


def run(deck: DeckLike, out: str | os.PathLike | None = None, *, seed: int | None = None,
        set: Mapping[str, Any] | None = None, threads: int = 0, until: float | None = None,
        restart: str | os.PathLike | None = None, time_limit: float = 0.0, audit: int = 0,
        quiet: bool = True) -> Run:
    """Runs a deck and writes its files, as `blocks run` does, with the same bits.

    Other threads of Python run meanwhile. Ctrl-C ends the run at a checkpoint and raises KeyboardInterrupt.

    Args:
        deck: text, path or `Deck`.
        out: name of the files, or a folder if it ends with '/'; None: the name of the deck, in the current
            folder. Missing folders are made.
        seed: of the random layers; replaces that of the SEED card.
        set: fields of cards to replace, as `{"FRICTN.fric": 0.4, "LAYER[2].ns": -20}`.
        threads: 0: as many as the machine has; does not change the results.
        until: [T] time at which the run ends.
        restart: checkpoint from which the run continues.
        time_limit: seconds after which the run stops; 0: none.
        audit: steps between two audits of the contacts; 0: none.
        quiet: False: print the table of steps and the progress, to the terminal and not to `sys.stdout`.

    Raises:
        DeckError: if cards contain errors. Warnings become `DeckWarning` and `RunWarning`.
        UnsoundRun: if a step made the state unusable. The files are written.
        FileError: if a file cannot be read or written.
    """
    deck_name, text = name_and_text(deck)
    given = "" if out is None else os.fspath(out)
    code = _blocks._run(deck_name, text, given, seed_of(seed), sets_of(set), whole(threads, "threads", 0, 1024), until,
                        None if restart is None else os.fspath(restart), time_limit, whole(audit, "audit", 0), quiet)
    name = given or Path(deck_name).stem
    if name.endswith("/"):
        name += Path(deck_name).stem
    if code == _INTERRUPTED:
        raise KeyboardInterrupt
    if code == _FILES:
        raise FileError(f"{name}: a file cannot be read or written")
    if code == _UNSOUND:
        ended = Run(name)
        raise UnsoundRun((ended.summary.get("warnings") or ["the run is unsound"])[-1])
    if code not in (0, _TIME_LIMIT):
        raise BlocksError(f"{deck_name}: the run ended with code {code}")
    return Run(name)


setattr(Deck, "run", run)  # deck.run(...)
