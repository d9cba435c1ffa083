"""An SVG picture with blocks, arrows, text and boxes: what the scripts beside it draw with.

Lengths are in pixels, y points down as in SVG.
"""

from html import escape
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROCK, OTHER, INK, ACTS, HIDDEN = "#d9e2ea", "#efe3d3", "#333333", "#c0392b", "#1f6fb2"


class Picture:
    """Elements of one SVG file."""

    def __init__(self, width, height):
        self.width, self.height, self.parts = width, height, []

    def block(self, points, colour=ROCK, label="", at=None):
        """A filled polygon with its name."""
        path = " ".join(f"{x},{y}" for x, y in points)
        self.parts.append(f'<polygon points="{path}" fill="{colour}" fill-opacity="0.8" '
                          f'stroke="{INK}" stroke-width="1.5"/>')
        if label:
            self.text(*at, label)

    def line(self, a, b, colour=INK, width=1.5, dashed=False, arrow=False):
        """A line, with an arrow head at b on request."""
        self.parts.append(
            f'<line x1="{a[0]}" y1="{a[1]}" x2="{b[0]}" y2="{b[1]}" stroke="{colour}" '
            f'stroke-width="{width}"' + (' stroke-dasharray="5 4"' if dashed else "") +
            (' marker-end="url(#head)"' if arrow else "") + "/>")

    def dot(self, x, y, colour=ACTS):
        """A contact, or the corner of an axis."""
        self.parts.append(f'<circle cx="{x}" cy="{y}" r="4.5" fill="{colour}"/>')

    def ring(self, x, y, radius, colour=INK):
        """A circle that is not filled."""
        self.parts.append(f'<circle cx="{x}" cy="{y}" r="{radius}" fill="none" '
                          f'stroke="{colour}" stroke-width="1.5"/>')

    def text(self, x, y, text, colour=INK, anchor="middle", size=13):
        """Text around or beside a point."""
        self.parts.append(f'<text x="{x}" y="{y}" fill="{colour}" text-anchor="{anchor}" '
                          f'font-size="{size}">{escape(text)}</text>')

    def box(self, x, y, width, lines, colour="white"):
        """A box of a flow chart, as high as its lines; x is its middle."""
        height = 14 + 17 * len(lines)
        self.parts.append(f'<rect x="{x - width / 2}" y="{y}" width="{width}" height="{height}" '
                          f'rx="5" fill="{colour}" stroke="{INK}"/>')
        for k, line in enumerate(lines):
            self.text(x, y + 21 + 17 * k, line, size=12.5)

    def save(self, name):
        """Writes the file."""
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width} {self.height}" '
                f'width="{self.width}" height="{self.height}" '
                'font-family="DejaVu Sans, sans-serif">\n'
                '<defs><marker id="head" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="8" '
                f'markerHeight="8" orient="auto-start-reverse"><path d="M0 0L10 5L0 10z" '
                f'fill="{INK}"/></marker></defs>\n'
                f'<rect width="{self.width}" height="{self.height}" fill="white"/>\n')
        (HERE / name).write_text(head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")
