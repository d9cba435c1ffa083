"""Draws blocks, contact forces, histories and bands of runs with Matplotlib.

Every function returns the artists that it adds, so that all of them can be changed. For figures of one
journal column:

    with blocks.plotting.style():
        blocks.read("stack.vtkhdf").plot(forces=True).figure.savefig("stack.pdf")
"""

from __future__ import annotations

import io
from typing import Any

try:
    import matplotlib
except ImportError:
    raise ImportError("pictures need Matplotlib: apt install python3-matplotlib") from None

from .colours import material_colour
from .curves import Band, draw_history, plot_band, plot_history
from .drawing import Drawing, plot
from .figures import STYLE, fit_height, new_figure, style
from .force_lines import force_scale
from .scenes import Scene

__all__ = [
    "STYLE", "Band", "Drawing", "force_scale", "material_colour", "picture", "plot", "plot_band",
    "plot_history", "style",
]

_MOST_CURVES = 6  # more would not fit a notebook


def picture(shown: Any) -> bytes:
    """Returns a picture of a Frame, a Simulation, an Assembly or a History for notebooks, as PNG."""
    with matplotlib.rc_context({"figure.figsize": (6.4, 4.0), "font.size": 9.0}):
        if not hasattr(shown, "polygons"):  # a History
            figure = draw_history(shown, shown.names[:_MOST_CURVES], None, {}, pyplot=False)[0].figure
        else:
            figure = new_figure(pyplot=False, shape=Scene(shown).shape)
            drawing = plot(shown, figure.subplots())
            if hasattr(shown, "time"):
                units = getattr(shown, "units", None)
                text = f"t = {shown.time:.4g} {units.time if units else ''}"
                drawing.ax.set_title(text.rstrip(), loc="left")
            fit_height(figure)
        file = io.BytesIO()
        figure.savefig(file, format="png", dpi=110)
    return file.getvalue()
