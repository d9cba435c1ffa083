"""The file NAME.vtkhdf on disk, which a run may be writing while it is read (docs/reliability.md).

The text before the HDF5 data counts the changes of the file. The number is odd while a run is changing the
file, and the run holds a lock meanwhile.
"""

from __future__ import annotations

import fcntl
import io
import os
import re
import time as clock
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar

import h5py
from numpy.typing import NDArray

from .errors import FileError

__all__ = ["ResultsFile", "frozen", "results_nearby", "text_of"]

_NEWEST_FORMAT = 1
_PATIENCE = 10.0  # [s] to wait for a run that is changing the file; it needs milliseconds
_LONG_AGO = 60.0  # [s] after which a change without a lock counts as abandoned
_MARK_SIZE = 512  # [bytes] of text before the HDF5 data
_MARK = b"BLOCKS results; HDF5 from byte 512 on. Changes: "
_MARK_DIGITS = 20
_HDF5_HEAD = b"\x89HDF\r\n\x1a\n"

_T = TypeVar("_T")


class _Marked(io.FileIO):
    """The file as HDF5 reads it, and the mark before its data. HDF5 takes no locks of it."""

    def readinto(self, buffer: Any) -> int:
        """Reads until the buffer is full or the file ends; HDF5 expects that."""
        view, done = memoryview(buffer).cast("B"), 0
        while done < len(view) and (count := super().readinto(view[done:])):
            done += count
        return done

    def changes(self) -> int:
        """Returns the number of changes; 0 for a file of an older version, which has no mark."""
        head = os.pread(self.fileno(), len(_MARK) + _MARK_DIGITS, 0)
        digits = head[len(_MARK) :]
        return int(digits) if head.startswith(_MARK) and digits.isdigit() else 0

    def settled(self, until: float) -> int | None:
        """Returns the number of changes when none is in progress; None if that takes too long."""
        pause = 0.001
        while True:
            number = self.changes()
            if number % 2 == 0 or self._is_abandoned():
                return number
            if clock.monotonic() > until:
                return None
            clock.sleep(pause)
            pause = min(2 * pause, 0.02)

    def _is_abandoned(self) -> bool:
        """Whether the run that made the number odd has ended."""
        descriptor = self.fileno()
        try:
            fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        except OSError:  # the file system has no locks
            return clock.time() - os.fstat(descriptor).st_mtime > _LONG_AGO
        fcntl.flock(descriptor, fcntl.LOCK_UN)
        return True

    def fault(self) -> str:
        """Says what the file is if it is not a results file; empty if it may be one."""
        head, name = os.pread(self.fileno(), 4096, 0), os.fsdecode(self.name)
        if not head:
            return "it is empty"
        if head.startswith(_MARK):
            if os.fstat(self.fileno()).st_size <= _MARK_SIZE:
                return "it is truncated, it has no data; copy it again or repeat the run"
            return ""
        if head.startswith(_HDF5_HEAD):
            return ""
        line = head.split(b"\n", 1)[0].rstrip()
        what = "a text file"
        if line.startswith(b"BLOCKS ") and line.endswith(b"two-dimensional block motion"):
            what = "a listing of a run"
        elif line == b"BLOCKS checkpoint":
            what = "a checkpoint, for RESTART"
        elif name.endswith(".deck"):
            what = "a deck; `blocks run` makes results from it"
        elif b"\0" in head:
            what = "a file of another program"
        elif head.lstrip().startswith(b"{"):
            what = "a JSON file"
        return f"it is not a results file of BLOCKS, but {what}"


class ResultsFile:
    """An open results file.

    Args:
        path: of the file.

    Raises:
        FileError: if the file cannot be opened. read() finds out whether it is a results file.

    Attributes:
        path: of the file.
        known_frames: number of frames that a file must have to be read.
    """

    def __init__(self, path: str):
        self.path = path
        self.known_frames = 1
        self._data: h5py.File | None = None
        self._opened_at: int | None = None  # number of changes when _data was opened
        self._marked: _Marked | None = None
        self._has_own_data = False  # was tested; it takes as long as reading a frame
        if os.path.exists(path) and not (os.path.isfile(path) or os.path.isdir(path)):
            raise self._error("it is not a regular file")  # opening a FIFO may never end
        try:
            self._marked = _Marked(path)
        except OSError as error:
            raise self._error(error.strerror) from None

    def _error(self, reason: str) -> FileError:
        return FileError(f"cannot read {self.path}: {reason}")

    @property
    def is_open(self) -> bool:
        """Whether close() has not been called."""
        return self._marked is not None

    def is_replaced(self) -> bool:
        """Whether another file has the path now, or none has."""
        try:
            return not os.path.samestat(os.fstat(self._marked.fileno()), os.stat(self.path))
        except FileNotFoundError:
            return True

    def read(self, action: Callable[[h5py.File], _T]) -> _T:
        """Returns action(file). If the file changes meanwhile, it is opened again and read again.

        Raises:
            FileError: if the file is not a results file, is damaged, or changes all the time.
            ValueError: if it has been closed.
        """
        marked = self._marked
        if marked is None:
            raise ValueError(f"{self.path} is closed")
        until = clock.monotonic() + _PATIENCE
        while (number := marked.settled(until)) is not None:
            try:
                if self._data is None or self._opened_at != number:
                    self._open(marked)
                    self._opened_at = number
                result = action(self._data)
                if marked.changes() == number:
                    return result
            except FileError:
                if marked.changes() == number:
                    raise
            except Exception as error:  # any error of h5py, because data are changing
                if marked.changes() == number:
                    raise self._error(_reason(error)) from error
            if clock.monotonic() > until:
                break
        raise self._error("a run is writing to it now; try again")

    def _open(self, marked: _Marked) -> None:
        """Opens the HDF5 data. Each change needs this, because HDF5 keeps what it has read."""
        self.forget()
        if fault := marked.fault():
            raise self._error(fault)
        self._data = h5py.File(marked, "r")
        if fault := self._fault(self._data):
            self.forget()
            raise self._error(fault)

    def _fault(self, data: h5py.File) -> str:
        """Says why the data cannot be used; empty if they can."""
        if not self._has_own_data and (fault := _data_elsewhere(data)):
            return fault
        self._has_own_data = True
        if "VTKHDF" not in data or "BLOCKS" not in data or "seed" not in data["BLOCKS"].attrs:
            return "it is not a results file of BLOCKS, but an HDF5 file of another program"
        if data["BLOCKS"].attrs["format"] > _NEWEST_FORMAT:
            return "a newer version of BLOCKS wrote it"
        frames = data["VTKHDF/Steps"].attrs["NSteps"]
        if frames <= 0:
            return "it has no frames yet"
        if frames < self.known_frames:
            return "a restart has removed frames from it; refresh() reads it again"
        return ""

    def forget(self) -> None:
        """Makes the next read() open the data again."""
        if self._data is not None:
            self._data.close()
            self._data = None

    def close(self) -> None:
        """Closes the file."""
        self.forget()
        if self._marked is not None:
            self._marked.close()
            self._marked = None

    def __del__(self) -> None:
        if hasattr(self, "_marked"):  # opened
            self.close()


def results_nearby(path: str) -> str:
    """Names the newest results files of the folder of a path, for a message."""
    folder = Path(path).parent
    try:
        found = [file for file in folder.glob("*.vtkhdf") if file.is_file() and file != Path(path)]
        found.sort(key=lambda file: file.stat().st_mtime, reverse=True)
    except OSError:
        found = []
    if not found:
        return "`blocks run DECK` writes results to NAME.vtkhdf"
    names = ", ".join(map(str, found[:5]))
    return f"results in this folder: {names}" + (", ..." if len(found) > 5 else "")


def _data_elsewhere(group: h5py.Group, depth: int = 0) -> str:
    """Names an object whose data are not in the file, because HDF5 would open any other file; empty if none.

    Files of BLOCKS have no such objects.
    """
    for name in group:
        place = f"{group.name}/{name}".lstrip("/")
        if not isinstance(group.get(name, getlink=True), h5py.HardLink) or depth > 8:
            return f"{place} is a link to another place or file"
        item = group[name]
        if isinstance(item, h5py.Group):
            if fault := _data_elsewhere(item, depth + 1):
                return fault
        elif isinstance(item, h5py.Dataset) and (item.external or item.is_virtual):
            return f"{place} is stored in another file"
    return ""


def _reason(error: Exception) -> str:
    """Returns the text of an error of h5py without the details of HDF5."""
    text = str(error.args[0]) if error.args else type(error).__name__
    if match := re.search(r"truncated file: eof = (\d+), .*base_addr = (\d+), stored_eof = (\d+)", text):
        end, start, whole = map(int, match.groups())
        return f"it is truncated, it has {end + start} of {whole} bytes; copy it again or repeat the run"
    return f"it is damaged ({text})"


def text_of(group: h5py.Group, name: str) -> str:
    """Returns a stored text; empty if there is none of that name."""
    value = group[name][()] if name in group else ""
    return value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)


def expected(name: str, values: NDArray[Any], shape: tuple[int, ...], kinds: str) -> NDArray[Any]:
    """Returns values that were read. Raises ValueError if they have another shape or kind of type, as of NumPy."""
    if values.shape != shape or values.dtype.kind not in kinds:
        raise ValueError(f"{name} has the wrong shape or type")
    return values


def frozen(array: NDArray[Any]) -> NDArray[Any]:
    """Returns the array, which cannot be written to from now on."""
    array.flags.writeable = False
    return array
