"""A small chart as SVG: lines for expected values, marks for measured ones."""

import math
from dataclasses import dataclass, field
from html import escape

WIDTH, HEIGHT = 640, 400
LEFT, RIGHT, TOP, BOTTOM = 78, 18, 40, 52
COLOURS = ["#1f6fb2", "#d1603d", "#3a8a4f", "#7a5ba8", "#9a7b1c"]
GREY = "#555555"


@dataclass
class Series:
    """The points of one curve and how they are drawn."""
    x: list
    y: list
    label: str
    marks: bool
    colour: str


@dataclass
class Chart:
    """A chart with a title and labels with units; log is "", "x", "y" or "xy"."""
    title: str
    x_label: str
    y_label: str
    log: str = ""
    same_scale: bool = False
    series: list = field(default_factory=list)

    def expected(self, x, y, label="expected", colour=None):
        """Adds a thin line."""
        self.series.append(Series(list(x), list(y), label, False, colour or GREY))
        return self

    def ours(self, x, y, label="ours", line=False):
        """Adds marks, or a thick line."""
        colour = COLOURS[sum(s.colour in COLOURS for s in self.series) % len(COLOURS)]
        self.series.append(Series(list(x), list(y), label, not line, colour))
        return self

    def svg(self):
        """Returns the chart as SVG."""
        x_axis = Axis([v for s in self.series for v in s.x], "x" in self.log)
        y_axis = Axis([v for s in self.series for v in s.y], "y" in self.log)
        if self.same_scale:
            x_axis.as_wide_as(y_axis, (WIDTH - LEFT - RIGHT) / (HEIGHT - TOP - BOTTOM))

        def px(v):
            return LEFT + x_axis.share(v) * (WIDTH - LEFT - RIGHT)

        def py(v):
            return HEIGHT - BOTTOM - y_axis.share(v) * (HEIGHT - TOP - BOTTOM)

        out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
               f'width="{WIDTH}" height="{HEIGHT}" font-family="DejaVu Sans, sans-serif" '
               'font-size="12" fill="#222222">',
               f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
               f'<text x="{LEFT}" y="22" font-size="14">{escape(self.title)}</text>']
        for v in x_axis.ticks():
            out.append(f'<line x1="{px(v):.1f}" x2="{px(v):.1f}" y1="{TOP}" '
                       f'y2="{HEIGHT - BOTTOM}" stroke="#e4e4e4"/>')
            out.append(f'<text x="{px(v):.1f}" y="{HEIGHT - BOTTOM + 17}" '
                       f'text-anchor="middle">{format_tick(v)}</text>')
        for v in y_axis.ticks():
            out.append(f'<line x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{py(v):.1f}" '
                       f'y2="{py(v):.1f}" stroke="#e4e4e4"/>')
            out.append(f'<text x="{LEFT - 7}" y="{py(v) + 4:.1f}" '
                       f'text-anchor="end">{format_tick(v)}</text>')
        out.append(f'<rect x="{LEFT}" y="{TOP}" width="{WIDTH - LEFT - RIGHT}" '
                   f'height="{HEIGHT - TOP - BOTTOM}" fill="none" stroke="#888888"/>')
        out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2:.0f}" y="{HEIGHT - 14}" '
                   f'text-anchor="middle">{escape(self.x_label)}</text>')
        middle = (TOP + HEIGHT - BOTTOM) / 2
        out.append(f'<text x="18" y="{middle:.0f}" text-anchor="middle" '
                   f'transform="rotate(-90 18 {middle:.0f})">{escape(self.y_label)}</text>')
        for s in self.series:
            points = [(px(x), py(y)) for x, y in zip(s.x, s.y)
                      if math.isfinite(x) and math.isfinite(y)]
            if s.marks:
                out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{s.colour}" '
                        'fill-opacity="0.85"/>' for x, y in points]
            else:
                width = 1.3 if s.colour == GREY else 2
                path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
                out.append(f'<polyline points="{path}" fill="none" stroke="{s.colour}" '
                           f'stroke-width="{width}"/>')
        return "\n".join([*out, *self._legend(px, py), "</svg>", ""])

    def _legend(self, px, py):
        """Draws the legend at the top or the bottom, where the fewest points are."""
        named = [s for s in self.series if s.label]
        if not named:
            return []
        width = 40 + 7.2 * max(len(s.label) for s in named)
        height = 10 + 18 * len(named)
        right = WIDTH - RIGHT - 10 - width
        spots = [(x, y) for x in (LEFT + 10, right, (LEFT + 10 + right) / 2)
                 for y in (TOP + 10, HEIGHT - BOTTOM - 10 - height)]

        def crowd(spot):
            return sum(spot[0] - 6 < px(x) < spot[0] + width + 6 and
                       spot[1] - 6 < py(y) < spot[1] + height + 6
                       for s in self.series for x, y in zip(s.x, s.y))

        left, top = min(spots, key=crowd)
        out = [f'<rect x="{left:.0f}" y="{top:.0f}" width="{width:.0f}" height="{height}" '
               'fill="white" fill-opacity="0.85" stroke="#cccccc"/>']
        for k, s in enumerate(named):
            y = top + 17 + 18 * k
            if s.marks:
                out.append(f'<circle cx="{left + 17:.0f}" cy="{y - 4:.0f}" r="4" '
                           f'fill="{s.colour}"/>')
            else:
                out.append(f'<line x1="{left + 6:.0f}" x2="{left + 28:.0f}" y1="{y - 4:.0f}" '
                           f'y2="{y - 4:.0f}" stroke="{s.colour}" stroke-width="2"/>')
            out.append(f'<text x="{left + 34:.0f}" y="{y:.0f}">{escape(s.label)}</text>')
        return out


class Axis:
    """Maps values to shares 0 ... 1 and places the ticks."""

    def __init__(self, values, log):
        values = [v for v in values if math.isfinite(v) and (v > 0 or not log)]
        self.log = log
        low, high = min(values), max(values)
        if log:
            low, high = math.log10(low), math.log10(high)
        margin = 0.06 * (high - low) or 0.5 * abs(high) or 0.5
        self.low, self.high = low - margin, high + margin

    def as_wide_as(self, other, aspect):
        """Gives both axes the same scale; this one is `aspect` times as long."""
        mine, theirs = self.high - self.low, (other.high - other.low) * aspect
        if mine < theirs:
            self.low, self.high = self.low - (theirs - mine) / 2, self.high + (theirs - mine) / 2
        else:
            more = (mine / aspect - (other.high - other.low)) / 2
            other.low, other.high = other.low - more, other.high + more

    def share(self, value):
        if self.log:
            value = math.log10(value) if value > 0 else self.low
        return (value - self.low) / (self.high - self.low)

    def ticks(self):
        if self.log:
            decades = range(math.ceil(self.low), math.floor(self.high) + 1)
            factors = (1,) if len(decades) > 2 else (1, 2, 5)
            found = [f * 10.0 ** d for d in range(math.floor(self.low), math.ceil(self.high) + 1)
                     for f in factors]
            return [v for v in found if self.low <= math.log10(v) <= self.high]
        rough = (self.high - self.low) / 5
        power = 10.0 ** math.floor(math.log10(rough))
        step = next(f * power for f in (1, 2, 2.5, 5, 10) if f * power >= rough)
        first = math.ceil(self.low / step)
        return [k * step for k in range(first, math.floor(self.high / step) + 1)]


def format_tick(value):
    """Formats the value of a tick as briefly as possible."""
    return f"{value:.4g}".replace("e+0", "e").replace("e-0", "e-")
