"""Exceptions and warnings of the package. All of them are also in `blocks` itself."""

from __future__ import annotations

import sys
import warnings

__all__ = ["BlocksError", "DeckError", "DeckWarning", "FileError", "NotReadError", "RunWarning", "UnsoundRun"]


class BlocksError(Exception):
    """Base class of the exceptions of this package."""


class _WithDiagnostics(BlocksError):
    """An error about a deck, with its diagnostics."""

    def __init__(self, printed: str, diagnostics: list | None = None):
        super().__init__(printed.rstrip("\n"))
        self.diagnostics = list(diagnostics or [])

    def __reduce__(self):
        return type(self), (str(self), self.diagnostics)


class DeckError(_WithDiagnostics, ValueError):
    """Cards contain errors.

    `str()` is what the command line prints: every error and warning as file:line:col, with the line of
    the deck, a caret and a hint.

    Attributes:
        diagnostics: list of `Diagnostic`, one for each error and warning, in the order of the deck.
    """


class UnsoundRun(BlocksError, RuntimeError):
    """A step has made the state unusable, most often because the time step is too large.

    Lower FRACTION or raise STIFF. The simulation can still be read and plotted, but not continued.
    """


class FileError(_WithDiagnostics, OSError):
    """A file cannot be read or written, or is not what it should be.

    Attributes:
        diagnostics: list of `Diagnostic` if a card names the file; otherwise empty.
    """

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""


class NotReadError(BlocksError, RuntimeError):
    """The contacts of the last step are not known, because that step was not read.

    See `Simulation.step`.
    """


class DeckWarning(UserWarning):
    """A card is allowed, but probably not what was meant. The text is what the command line prints."""


class RunWarning(UserWarning):
    """A step did what was probably not meant, such as a block that left the domain."""


def warn(text: str, category: type[Warning]) -> None:
    """Gives a warning that names the line outside this package."""
    level, frame = 1, sys._getframe()
    while frame is not None and frame.f_globals.get("__name__", "").split(".")[0] == "blocks":
        level, frame = level + 1, frame.f_back
    warnings.warn(text.rstrip("\n"), category, stacklevel=level)
