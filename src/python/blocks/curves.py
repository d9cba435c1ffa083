"""Draws histories, and bands of several runs."""

from __future__ import annotations

import textwrap
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike

from .figures import math_text, new_figure

__all__ = ["Band", "draw_history", "plot_band", "plot_history"]


def plot_history(
    history: Any, names: str | Sequence[str] | None = None, ax: Any = None, **options: Any
) -> list[Line2D]:
    """Draws recorded quantities against time, and returns the lines.

    Args:
        history: a History, such as results.history.
        names: quantities of the history, with the numbers of the cards: "y:3"; None: all of them.
        ax: the Axes; None: a new figure with a panel for each kind of quantity, one above the other. An array
            of Axes has such panels too.
        options: of all lines, such as color, linewidth, linestyle, marker or label.

    Raises:
        KeyError: if a quantity was not recorded.
        ValueError: if there are no samples, or not as many Axes as panels.
    """
    chosen = history.names if names is None else (names,) if isinstance(names, str) else tuple(names)
    if not history.names:
        raise ValueError("there are no samples: the deck has no HISTORY card")
    return draw_history(history, chosen, ax, options, pyplot=True)


def draw_history(
    history: Any, names: Sequence[str], ax: Any, options: Mapping[str, Any], pyplot: bool
) -> list[Line2D]:
    """Draws quantities as plot_history() does; pyplot: see new_figure()."""
    values = {name: history[name] for name in names}  # raises KeyError before a figure is made
    groups: dict[str, list[str]] = {}
    for name in values:
        groups.setdefault(f"{history.label(name)}|{history.unit(name)}", []).append(name)
    if ax is None:
        shape = None if len(groups) == 1 else 0.42 * len(groups) + 0.08
        figure = new_figure(pyplot, shape)
        axes = figure.subplots(len(groups), sharex=True, squeeze=False).ravel()
    else:
        axes = np.ravel(np.asarray(ax, dtype=object))
        if axes.size == 1:
            groups = {"": list(values)}
        elif axes.size != len(groups):
            raise ValueError(f"there are {len(groups)} kinds of quantities, but {axes.size} Axes")
    lines = []
    for panel, group in zip(axes, groups.values()):
        for name in group:
            lines += panel.plot(history.times, values[name], **{"label": name, **options})
        if not panel.get_ylabel():
            panel.set_ylabel(_wrapped(_label_of(history, group), panel))
        if len(group) > 1:
            panel.legend()
    if ax is None:
        figure.align_ylabels()
    if not axes[-1].get_xlabel():
        axes[-1].set_xlabel(f"time [{history.unit('t')}]")
    return lines


def _label_of(history: Any, names: Sequence[str]) -> str:
    """Returns the label of an axis for several quantities: "y [m]", "energy [J/m]", "[m]"."""
    labels, units = {history.label(name) for name in names}, {history.unit(name) for name in names}
    label = labels.pop() if len(labels) == 1 else ""
    if not label and all(name.startswith("energy:") or name == "kinetic_energy" for name in names):
        label = "energy"
    unit = math_text(units.pop()) if len(units) == 1 else ""
    return f"{label} [{unit}]".strip() if unit else label


def _wrapped(label: str, ax: Axes) -> str:
    """Breaks the label of a y axis into lines that are no longer than the axis."""
    height = 0.8 * ax.get_window_extent().height * 72 / ax.figure.dpi  # [pt] the layout needs the rest
    letters = height / (0.55 * ax.yaxis.label.get_size())
    name, bracket, unit = label.rpartition(" [")
    whole = f"{name}{bracket}{unit.replace(' ', chr(0xA0))}"  # a unit is not broken
    return textwrap.fill(whole, max(int(letters), 8), break_long_words=False, break_on_hyphens=False)


class Band(NamedTuple):
    """What plot_band() has added: the line of the median, and the area of the band."""

    line: Line2D
    area: Any


def plot_band(
    times: ArrayLike,
    values: ArrayLike,
    ax: Axes | None = None,
    *,
    low: float = 10.0,
    high: float = 90.0,
    alpha: float = 0.25,
    **options: Any,
) -> Band:
    """Draws the median of several runs, such as those of different seeds, and a band.

    Args:
        times: (t,), the same for all runs.
        values: (runs, t). NaN is left out, so runs may end early.
        ax: the Axes; None: a new figure.
        low: percentile at which the band begins, from 0 to 100.
        high: percentile at which it ends.
        alpha: opacity of the band.
        options: of the line, such as color, linewidth or label. The band has its colour.

    Raises:
        ValueError: if the shapes do not fit or low is not below high.
    """
    x, y = np.asarray(times, np.float64), np.atleast_2d(np.asarray(values, np.float64))
    if x.ndim != 1 or y.ndim != 2 or y.shape[1] != len(x):
        raise ValueError(f"values have the shape {y.shape}, but need (runs, {x.size}) for these times")
    if not 0.0 <= low < high <= 100.0:
        raise ValueError(f"a band needs 0 <= low < high <= 100, not {low:g} and {high:g}")
    if ax is None:
        ax = new_figure(pyplot=True).subplots()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # times at which no run has a number
        bottom, middle, top = np.nanpercentile(y, [low, 50.0, high], axis=0)
    (line,) = ax.plot(x, middle, **options)
    area = ax.fill_between(
        x, bottom, top, color=line.get_color(), alpha=alpha, linewidth=0.0, zorder=line.get_zorder() - 0.1
    )
    return Band(line, area)
