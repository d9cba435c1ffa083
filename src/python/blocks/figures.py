"""Figures and their style for journals."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import matplotlib
import matplotlib.style
import numpy as np
from matplotlib.figure import Figure

__all__ = ["STYLE", "fit_height", "math_text", "new_figure", "style"]

#: Name of the style sheet for journals, for matplotlib.style.use().
STYLE = str(Path(__file__).with_name("journal.mplstyle"))

_MM = 1 / 25.4  # [in]
_SHAPES = (0.12, 1.4)  # least and largest height of a new picture, in its widths


@contextmanager
def style(width: float = 84.0, height: float | None = None) -> Iterator[None]:
    """Uses the style sheet for journals for the figures made inside a `with` statement.

    Args:
        width: [mm] of figures, by default one column.
        height: [mm]; by default three quarters of the width. plot() chooses its own height.
    """
    size = (width * _MM, (0.75 * width if height is None else height) * _MM)
    with matplotlib.style.context(STYLE), matplotlib.rc_context({"figure.figsize": size}):
        yield


def new_figure(pyplot: bool, shape: float | None = None) -> Figure:
    """Makes a figure as wide as the style says.

    Args:
        pyplot: whether pyplot knows the figure; only then it is shown in a window or a notebook.
        shape: height in widths; None: that of the style.
    """
    width, height = matplotlib.rcParams["figure.figsize"]
    size = (width, height if shape is None else float(np.clip(shape, *_SHAPES)) * width)
    if not pyplot:
        return Figure(figsize=size, layout="compressed")
    from matplotlib import pyplot as plt

    return plt.figure(figsize=size, layout="compressed")


def fit_height(figure: Figure) -> None:
    """Gives a figure with one picture the height that its blocks and labels need."""
    width = float(figure.get_size_inches()[0])
    (x0, x1), (y0, y1) = figure.axes[0].get_xlim(), figure.axes[0].get_ylim()
    tallest = float(np.clip((y1 - y0) / (x1 - x0), *_SHAPES)) * width
    figure.set_size_inches(width, tallest + 1.5)  # more than the labels need
    figure.draw_without_rendering()
    inches = figure.get_tightbbox()
    pad = figure.get_layout_engine().get()["h_pad"]
    figure.set_size_inches(width, min(inches.height + 2 * pad + 0.01, tallest + 1.5))


def math_text(unit: str) -> str:
    """Writes raised numbers as math text, because few fonts have them all."""
    raised = "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"
    plain = str.maketrans(raised, "-0123456789")
    return re.sub(f"[{raised}]+", lambda power: f"$^{{{power[0].translate(plain)}}}$", unit)
