"""Pictures and text that notebooks show for an object."""

from __future__ import annotations

import base64
import html
from typing import Any

__all__ = ["html_of", "png_of"]


def png_of(shown: Any) -> bytes | None:
    """Returns a picture of a Frame, Simulation, Assembly or History as PNG; None without Matplotlib."""
    try:
        from . import plotting
    except ImportError:
        return None
    return plotting.picture(shown)


def html_of(shown: Any, pictured: Any = None) -> str:
    """Returns a title, the line of repr() and a picture as HTML.

    Args:
        shown: the object; its attribute `title`, if any, is the title.
        pictured: what the picture shows, if it is not the object itself: see png_of().
    """
    title = html.escape(getattr(shown, "title", ""))
    text = f"<p><strong>{title}</strong><br><code>{html.escape(repr(shown))}</code></p>"
    png = png_of(shown if pictured is None else pictured)
    if png is not None:
        text += f'<img alt="blocks" src="data:image/png;base64,{base64.b64encode(png).decode()}">'
    return text
