"""Reads results files NAME.vtkhdf, which `blocks run` writes (docs/results.md).

`read()` opens a file. Arrays are read when they are first used, and are then kept by their frame. Values are
those of the file, in the units of the deck. A file may be read while a run is writing it.
"""

from __future__ import annotations

import functools
import operator
import os
import weakref
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, overload

import h5py
import numpy as np
from numpy.typing import NDArray

from . import notebooks
from .dimensions import Units
from .errors import FileError
from .frames import Frame
from .histories import History, read_history
from .results_file import ResultsFile, expected, frozen, results_nearby, text_of
from .state_tables import crack_count, crack_table

if TYPE_CHECKING:
    from .drawing import Drawing

__all__ = ["Frame", "History", "Results", "read"]


def read(path: str | os.PathLike[str]) -> Results:
    """Opens a results file NAME.vtkhdf.

    Raises:
        FileError: if there is none, if it is no results file, or if it has no frames yet.
    """
    return Results(path)


class Results(Sequence[Frame]):
    """The results of a run: its frames, histories and cracks, as NAME.vtkhdf holds them.

    `results[i]` is a Frame, also for negative i; a slice is a list of frames. The frames are those that the
    file had when it was opened; refresh() looks for later ones. A `with` statement or close() closes it.

    Args:
        path: of the file.

    Attributes:
        path: of the file.
        title: of the deck.
        deck: text of the deck.
        deck_file: name of the deck.
        overrides: options of the program that changed the deck, one a line.
        seed: of random layers and joints.
        units: of the deck, or None if it has no UNITS card.
        materials: names of the materials that have one, by number.
        version: of the program that wrote the file.
        run_id: drawn at random, the same in the checkpoint.
        continues_run: run_id of the run that this one continues; may be empty.
        times: (f,) [T] times of the frames.
        steps: (f,) numbers of the steps of the frames.
    """

    def __init__(self, path: str | os.PathLike[str]):
        self.path = os.fspath(path)
        self._frames: weakref.WeakValueDictionary[int, Frame] = weakref.WeakValueDictionary()
        try:
            self._file = ResultsFile(self.path)
            self._load()
        except FileError as error:
            raise FileError(f"{error}\n  hint: {results_nearby(self.path)}") from error.__cause__

    def _load(self) -> None:
        """Reads what all frames share."""

        def action(file: h5py.File) -> None:
            own, steps = file["BLOCKS"], file["VTKHDF/Steps"]
            frames = int(steps.attrs["NSteps"])
            self.title = text_of(own, "title")
            self.deck = text_of(own, "deck_text")
            self.deck_file = text_of(own, "deck_file")
            self.overrides = text_of(own, "overrides")
            self.version = text_of(own, "version")
            self.run_id = text_of(own, "run_id")
            self.continues_run = text_of(own, "continues_run")
            self.seed = int(own.attrs["seed"])
            names = text_of(own, "units").splitlines()
            self.units = Units(*names[:3]) if len(names) >= 3 else None
            lines = [line.partition(" ") for line in text_of(own, "materials").splitlines()]
            self.materials = {int(number): name for number, _, name in lines}
            self.times: NDArray[np.float64] = frozen(
                expected("Steps/Values", steps["Values"][:frames], (frames,), "f")
            )
            self.steps: NDArray[np.integer] = frozen(
                expected("BLOCKS/steps", own["steps"][:frames], (frames,), "iu")
            )

        self._file.known_frames = 1
        self._file.read(action)
        self._file.known_frames = len(self)

    def refresh(self) -> int:
        """Looks for frames that were added, and returns their number.

        The number is negative if a restart has removed frames. Frames, histories and cracks that were taken
        before keep their values.

        Raises:
            FileError: if another file has the name now, such as that of a new run.
        """
        if self._file.is_open and self._file.is_replaced():
            raise FileError(f"cannot read {self.path}: another file has replaced it; read it again")
        before = len(self)
        for name in ("history", "cracks"):
            self.__dict__.pop(name, None)
        self._frames.clear()
        self._file.forget()
        self._load()
        return len(self) - before

    def __reduce__(self):
        return read, (self.path,)

    def close(self) -> None:
        """Closes the file. Arrays that have been read can still be used."""
        self._file.close()

    def __enter__(self) -> Results:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __len__(self) -> int:
        return len(self.times)

    @overload
    def __getitem__(self, index: int) -> Frame: ...
    @overload
    def __getitem__(self, index: slice) -> list[Frame]: ...
    def __getitem__(self, index: int | slice) -> Frame | list[Frame]:
        """Returns a frame, or the list of the frames of a slice. Raises IndexError."""
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        i = operator.index(index)
        if not -len(self) <= i < len(self):
            raise IndexError(f"{self.path} has frames 0 to {len(self) - 1}, not {i}")
        i %= len(self)
        frame = self._frames.get(i)
        if frame is None:
            frame = self._frames[i] = Frame(self, i)
        return frame

    def __iter__(self) -> Iterator[Frame]:
        return (self[i] for i in range(len(self)))

    def at(self, time: float) -> Frame:
        """Returns the frame nearest to a time [T]; the earlier of two times equally near, and the
        last frame of that time.

        Raises:
            ValueError: if the time is outside the run.
        """
        first, last = float(self.times[0]), float(self.times[-1])
        slack = 1e-3 * (last - first)  # a run ends up to one step late
        if not first - slack <= time <= last + slack:
            raise ValueError(f"{self.path} has times {first:g} to {last:g}, not {time:g}")
        nearest = self.times[np.argmin(np.abs(self.times - time))]
        return self[int(np.searchsorted(self.times, nearest, side="right")) - 1]

    @functools.cached_property
    def first_state(self) -> tuple[NDArray[np.float64], int]:
        """Centroids (n, 2) [L] and number of cracks of the first frame, for displacements."""
        first = self[0]
        return first.centroid, first._crack_count

    @functools.cached_property
    def history(self) -> History:
        """The samples of the HISTORY cards; without columns if the deck has none."""
        return self._file.read(lambda file: read_history(file["BLOCKS"], self.units, self.title))

    @functools.cached_property
    def cracks(self) -> NDArray[np.void]:
        """Structured array, a row for each crack up to the last frame, in the order in which blocks split.

        Fields: `step`, `time` [T], `parent`, `child` (blocks, from 0; the larger piece keeps the number of
        its parent), `cause` (0: stress, 1: point loads), `stress` [F/L^2], `begin`, `end` [L] of the cut,
        `parent_area`, `child_area` [L^2] and `released` [F L], as those of `Simulation.cracks`. The file
        also has `moved` [L], `kinetic_before`, `kinetic_after`, `strain_before` and `strain_after` [F L].
        """
        return self._file.read(lambda file: crack_table(file, crack_count(file, len(self) - 1)))

    def plot(self, time: float | None = None, ax: Any = None, **options: Any) -> Drawing:
        """Draws the frame nearest to a time [T], by default the last; see `blocks.plotting.plot`."""
        return (self[-1] if time is None else self.at(time)).plot(ax, **options)

    def __repr__(self) -> str:
        frames = f"{len(self)} frame" + ("s" if len(self) != 1 else "")
        if self._file.is_open:
            frames += f", {len(self[-1])} block" + ("s" if len(self[-1]) != 1 else "")
        else:
            frames += ", closed"
        return f"<Results {os.path.basename(self.path)}: {frames}, t {self.times[0]:g} to {self.times[-1]:g}>"

    def _repr_png_(self) -> bytes | None:
        return notebooks.png_of(self[-1])

    def _repr_html_(self) -> str:
        return notebooks.html_of(self, pictured=self[-1])
