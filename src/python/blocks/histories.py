"""The samples of HISTORY cards."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
from numpy.typing import NDArray

from . import notebooks
from .dimensions import Units, unit_text
from .quantities import kind_of_curve
from .results_file import frozen, text_of

if TYPE_CHECKING:
    import pandas

__all__ = ["History", "read_history"]

_Floats = NDArray[np.float64]


class History:
    """The h samples of the HISTORY cards of a run.

    `history["t"]` are the times (h,) [T] and `history[name]` the values (h,) of a quantity, named as on the
    card: "y:3", "kinetic_energy", "energy:friction". Such names have the numbers of the cards: "y:3" is of
    block 2 in arrays. If several cards recorded different quantities, the table has all of them, with NaN
    where a quantity was not recorded. NaN also means that the block does not exist, or has split and its
    displacement is not known. `len(history)` is h. To iterate over it is to iterate over `names`.

    Attributes:
        names: of the quantities.
        interval: [T] of the last card; NaN if there are no samples.
        units: of the deck, or None.
        title: of the deck.
    """

    def __init__(self, times: _Floats, columns: dict[str, _Floats], interval: float = math.nan,
                 units: Units | None = None, title: str = ""):
        self.names: tuple[str, ...] = tuple(columns)
        self.interval = interval
        self.units = units
        self.title = title
        self._columns = {"t": times, **columns}

    def __getitem__(self, name: str) -> _Floats:
        """Returns the values of a quantity, or the times for "t". Raises KeyError."""
        if name not in self._columns:
            names = ", ".join(self.names)
            recorded = f"recorded are {names}" if names else "the deck has no HISTORY card"
            raise KeyError(f"{name!r} was not recorded; {recorded}")
        return self._columns[name]

    @property
    def times(self) -> _Floats:
        """(h,) [T] multiples of the interval."""
        return self._columns["t"]

    def __len__(self) -> int:
        return len(self.times)

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __contains__(self, name: object) -> bool:
        return name in self._columns

    def keys(self) -> tuple[str, ...]:
        """The same as `names`, so that dict(history) works."""
        return self.names

    def label(self, name: str) -> str:
        """Returns what the quantity of a name is called on an axis: "y" for "y:3"."""
        return kind_of_curve(name).label

    def unit(self, name: str) -> str:
        """Returns the unit of the quantity of a name: "m/s", or "L T⁻¹"; "t" is the time."""
        return unit_text(kind_of_curve(name).dimension, self.units)

    def to_pandas(self) -> pandas.DataFrame:
        """Returns a pandas.DataFrame with the times as index and a column for each quantity.

        Its attribute `attrs` has "units", a dictionary of the units of the columns, "time_unit" and "title".

        Raises:
            ImportError: if pandas is missing.
        """
        try:
            import pandas
        except ImportError:
            raise ImportError("to_pandas() needs pandas: apt install python3-pandas") from None
        index = pandas.Index(self.times, name="t")
        table = pandas.DataFrame({name: self[name] for name in self.names}, index)
        table.attrs["units"] = {name: self.unit(name) for name in self.names}
        table.attrs["time_unit"] = self.unit("t")
        table.attrs["title"] = self.title
        return table

    def plot(self, names: str | Sequence[str] | None = None, ax: Any = None, **options: Any) -> list[Any]:
        """Draws quantities against time; see `blocks.plotting.plot_history`."""
        from .plotting import plot_history

        return plot_history(self, names, ax, **options)

    def __repr__(self) -> str:
        if not self.names:
            return "<History: no samples>"
        shown = ", ".join(self.names[:5]) + (", ..." if len(self.names) > 5 else "")
        return f"<History: {len(self)} samples of {shown}, t {self.times[0]:g} to {self.times[-1]:g}>"

    def _repr_png_(self) -> bytes | None:
        return notebooks.png_of(self) if self.names else None


def read_history(own: h5py.Group, units: Units | None, title: str) -> History:
    """Reads the sections history/1, history/2, ..., which follow each other in time.

    Args:
        own: the group BLOCKS of a results file.
        units: of the deck.
        title: of the deck.
    """
    times: list[float] = []
    columns: dict[str, list[float]] = {}
    interval, number = math.nan, 1
    while (place := f"history/{number}") in own:
        group = own[place]
        rows = int(group.attrs["rows"])
        names = text_of(group, "quantities").splitlines()
        section, values = group["time"][:rows], group["values"][:rows]
        number += 1
        if rows == 0:
            continue
        interval = float(group.attrs["interval"])
        for name in names:
            columns.setdefault(name, [math.nan] * len(times))
        # Two sections may share the time at which one ends and the next begins.
        if times and section[0] == times[-1]:
            for name, value in zip(names, values[0]):
                if math.isnan(columns[name][-1]):
                    columns[name][-1] = float(value)
        later = section > times[-1] if times else np.ones(rows, bool)
        times += section[later].tolist()
        kept = dict(zip(names, values[later].T.tolist()))
        for name, column in columns.items():
            column += kept.get(name, [math.nan] * int(later.sum()))
    arrays = {name: frozen(np.array(column)) for name, column in columns.items()}
    return History(frozen(np.array(times, np.float64)), arrays, interval, units, title)
