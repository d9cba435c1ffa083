#!/usr/bin/python3
"""Judges whether polygons tile an outline, in exact arithmetic.

tiling.py BLOCKS [--outline FILE] [--units-in-the-last-place N]

BLOCKS and the outline are GeoJSON (Polygon, MultiPolygon), WKT (POLYGON, MULTIPOLYGON; Z and M are
left out) or ASCII DXF (closed LWPOLYLINE and POLYLINE), from any program. Coordinates are the doubles
nearest to the numbers of the file. This file shares nothing with BLOCKS: it is written from the
definition alone (docs/joints.md#why-the-certificate-is-a-proof), and needs nothing but Python.

A simple clockwise polygon winds around each point inside it once, and around no other point. So the sum
of the windings of all blocks is the number of blocks that contain a point. Blocks tile an outline if that
sum is the winding of the outline everywhere. Edges that cancel each other add nothing to it; what is left
is swept from the left to the right, and each cell of the sweep is exactly a trapezium.

Verdicts: "tiles exactly"; "tiles up to rounding" (no overlap of two blocks; what lies between the blocks
and the outline, or among the blocks, is at most N units in the last place of the largest coordinate wide,
4 by default); "overlaps"; "does not tile". Without an outline: "no overlap" or "overlaps". The exit code is
0 if they tile or do not overlap, 1 if not, and 2 if a file cannot be read.
"""

import argparse
import json
import math
import re
import sys
from collections import defaultdict
from fractions import Fraction


class Unreadable(Exception):
    """A file is none of these, or has a polygon that is none."""


# Reading

def ring(points, place):
    """The corners of a ring as fractions, without the repeated last one."""
    corners = []
    for point in points:
        x, y = float(point[0]), float(point[1])
        if not (math.isfinite(x) and math.isfinite(y)):
            raise Unreadable(f"{place}: a coordinate is not finite")
        corners.append((Fraction(x), Fraction(y)))
    if len(corners) > 1 and corners[0] == corners[-1]:
        corners.pop()
    if len(corners) < 3:
        raise Unreadable(f"{place}: a ring has {len(corners)} corners")
    return corners


def of_geojson(text):
    def polygons(geometry):
        kind = geometry.get("type")
        if kind == "FeatureCollection":
            return [p for feature in geometry["features"] for p in polygons(feature)]
        if kind == "Feature":
            return polygons(geometry["geometry"] or {})
        if kind == "GeometryCollection":
            return [p for part in geometry["geometries"] for p in polygons(part)]
        if kind == "MultiPolygon":
            return geometry["coordinates"]
        return [geometry["coordinates"]] if kind == "Polygon" else []
    try:
        return polygons(json.loads(text))
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise Unreadable(f"no GeoJSON: {error}") from None


def of_wkt(text):
    found = []
    for match in re.finditer(r"(?:MULTI)?POLYGON\s*(?:ZM|Z|M)?\s*\(", text, re.I):
        depth, at = 1, match.end()
        while depth and at < len(text):
            depth += {"(": 1, ")": -1}.get(text[at], 0)
            at += 1
        body = text[match.end():at - 1]
        parts = [body]
        if match.group().upper().startswith("MULTI"):
            parts = re.findall(r"\(((?:\s*\([^()]*\)\s*,?)+)\)", body)
        found += [[[point.split()[:2] for point in inner.split(",")]
                   for inner in re.findall(r"\(([^()]*)\)", part)] for part in parts]
    return found


def of_dxf(text):
    lines = text.splitlines()
    pairs = [(lines[i].strip(), lines[i + 1].strip()) for i in range(0, len(lines) - 1, 2)]
    found, points, closed, kind = [], [], False, None
    for code, value in [*pairs, ("0", "EOF")]:
        if code == "0":
            if kind == "POLYLINE" and value in ("VERTEX", "SEQEND"):
                continue
            if kind in ("LWPOLYLINE", "POLYLINE") and closed and points:
                found.append([points if kind == "LWPOLYLINE" else points[1:]])  # [0]: of the entity
            points, closed, kind = [], False, value
        elif kind in ("LWPOLYLINE", "POLYLINE"):
            if code == "10":
                points.append([value, None])
            elif code == "20" and points:
                points[-1][1] = value
            elif code == "70" and not (kind == "POLYLINE" and len(points) > 1):
                closed = bool(int(value) & 1)
    return found


def read(path):
    """The polygons of a file: lists of rings, the outer one first."""
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise Unreadable(error) from None
    form = of_geojson if text.lstrip().startswith("{") else of_dxf if "SECTION" in text else of_wkt
    found = []
    for number, polygon in enumerate(form(text), 1):
        try:
            rings = [ring(points, f"polygon {number}") for points in polygon]
        except (ValueError, TypeError, IndexError) as error:
            raise Unreadable(f"polygon {number}: {error}") from None
        found.append([turned(corners, inner=k > 0) for k, corners in enumerate(rings)])
    if not found:
        raise Unreadable("there are no polygons")
    return found


# Geometry

def cross(o, a, b):
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def twice_area(corners):
    """Positive for clockwise rings."""
    return sum(b[0] * a[1] - a[0] * b[1] for a, b in edges_of(corners))


def edges_of(corners):
    return list(zip(corners, corners[1:] + corners[:1]))


def turned(corners, inner):
    """Outer rings run clockwise, inner ones anticlockwise."""
    return corners if (twice_area(corners) > 0) != inner else corners[::-1]


def meet(p, q):
    """Whether two edges of a ring that do not follow each other have a point in common."""
    (a, b), (c, d) = p, q
    if (max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0])
            or max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1])):
        return False
    sides = [cross(a, b, c), cross(a, b, d), cross(c, d, a), cross(c, d, b)]
    return sides[0] * sides[1] <= 0 and sides[2] * sides[3] <= 0


def is_simple(corners):
    edges, n = edges_of(corners), len(corners)
    if twice_area(corners) == 0:
        return False
    for i in range(n):
        if edges[i][0] == edges[i][1]:
            return False
        a, b, c = corners[i - 1], corners[i], corners[(i + 1) % n]
        if cross(a, b, c) == 0 and (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) < 0:
            return False  # a spike
        for k in range(i + 2, n if i else n - 1):
            if meet(edges[i], edges[k]):
                return False
    return True


def line_of(a, b):
    """A key that all edges on one line share: slope and intercept, or x."""
    if a[0] == b[0]:
        return None, a[0]
    slope = (b[1] - a[1]) / (b[0] - a[0])
    return slope, a[1] - slope * a[0]


def left_over(edges):
    """What is left of edges after opposite parts on one line have cancelled: (left end, right end,
    multiplicity), where 1 means that an edge ran from the left to the right. Vertical edges bound no
    trapezium and are left out."""
    lines = defaultdict(lambda: defaultdict(int))
    for a, b in edges:
        if a[0] != b[0]:
            changes, way = lines[line_of(a, b)], 1 if a[0] < b[0] else -1
            changes[min(a[0], b[0])] += way
            changes[max(a[0], b[0])] -= way
    left = []
    for (slope, level), changes in lines.items():
        total, places = 0, sorted(changes)
        for x, following in zip(places, places[1:]):
            total += changes[x]
            if total:
                left.append(((x, slope * x + level), (following, slope * following + level), total))
    return left


class Sweep:
    """Sums the areas where the number of blocks and the winding of the outline have certain values."""

    def __init__(self, blocks, outline):
        # (left end, right end, change of the number of blocks, of the outline) when going down
        self.edges = [(a, b, m, 0) for a, b, m in blocks] + [(a, b, 0, m) for a, b, m in outline]
        self.areas, self.widths = defaultdict(Fraction), defaultdict(float)
        self.runs = {}  # of each state: where it began, how far it has come, and how thick it is

    def run(self):
        starts = sorted(self.edges, key=lambda edge: edge[0][0])
        places = sorted({x for edge in self.edges for x in (edge[0][0], edge[1][0])})
        active, at = [], 0
        for left, right in zip(places, places[1:]):
            active = [edge for edge in active if edge[1][0] > left]
            while at < len(starts) and starts[at][0][0] <= left:
                active.append(starts[at])
                at += 1
            self.slab(active, left, right)

    @staticmethod
    def height(edge, x):
        (x0, y0), (x1, y1) = edge[:2]
        return y0 + (x - x0) / (x1 - x0) * (y1 - y0)

    def slab(self, active, left, right):
        """Sweeps between two places where no edge begins or ends."""
        ends = [(self.height(edge, left), self.height(edge, right), edge) for edge in active]
        ends.sort(key=lambda end: (end[0] + end[1], end[0]))
        cuts = set()
        for low, high in zip(ends, ends[1:]):  # neighbours cross first, if any edges do
            before, after = high[0] - low[0], high[1] - low[1]
            if before * after < 0:
                cuts.add(left + before / (before - after) * (right - left))
        if cuts:
            places = [left, *sorted(cuts), right]
            for a, b in zip(places, places[1:]):
                self.slab(active, a, b)
            return
        blocks = outline = 0
        for low, high in zip(reversed(ends[:-1]), reversed(ends)):  # from above
            blocks += high[2][2]
            outline += high[2][3]
            wide = (high[0] - low[0]) + (high[1] - low[1])
            if wide and (blocks, outline) != (0, 0):
                state = blocks, outline
                self.areas[state] += wide / 2 * (right - left)
                (x0, y0), (x1, y1) = low[2][:2]
                tilt = math.hypot(1, float((y1 - y0) / (x1 - x0)))
                thick = float(max(high[0] - low[0], high[1] - low[1])) / tilt
                begin, end, most = self.runs.get(state, (left, left, 0.0))
                if end < left:
                    begin, most = left, 0.0
                self.runs[state] = begin, right, max(most, thick)
                # No thicker than it is long: a slit between vertical sides.
                self.widths[state] = max(self.widths[state], min(max(most, thick), float(right - begin) * tilt))


def judge(blocks, outline, ulps=4):
    """Returns the verdict, whether it is good, and lines that explain it."""
    lines = [f"{len(blocks)} blocks"]
    for number, rings in enumerate(blocks, 1):
        if not all(is_simple(corners) for corners in rings):
            return f"block {number} is not simple", False, lines
    edges = [edge for rings in blocks for corners in rings for edge in edges_of(corners)]
    around = [edge for rings in outline or [] for corners in rings for edge in edges_of(corners)]
    sweep = Sweep(left_over(edges), left_over(around))
    sweep.run()
    largest = max(abs(float(v)) for edge in edges + around for point in edge for v in point)
    room = ulps * math.ulp(largest)

    def total(chosen):
        states = [state for state in sweep.areas if chosen(*state)]
        return (sum((sweep.areas[s] for s in states), Fraction(0)),
                max((sweep.widths[s] for s in states), default=0.0))
    overlap, deepest = total(lambda number, _: number > 1 or number < 0)
    lines.append(f"area of overlaps: {float(overlap):.3g}, {'exactly 0' if not overlap else f'{deepest:.3g} deep'}")
    if outline is None:
        return ("overlaps" if overlap else "no overlap"), not overlap, lines
    gap, widest = total(lambda number, inside: number == 0 and inside == 1)
    beyond, farthest = total(lambda number, inside: number == 1 and inside == 0)
    lines += [f"area without a block: {float(gap):.3g}, about {widest:.3g} wide",
              f"area beyond the outline: {float(beyond):.3g}, about {farthest:.3g} wide"]
    if overlap:
        return "overlaps", False, lines
    if not gap and not beyond:
        return "tiles exactly", True, lines
    length = sum(math.dist(map(float, a), map(float, b)) for a, b in edges)
    if max(widest, farthest) <= room and gap + beyond <= room * length:
        lines.append(f"{ulps} units in the last place of {largest:g} are {room:.3g}")
        return "tiles up to rounding", True, lines
    return "does not tile", False, lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("blocks")
    parser.add_argument("--outline", help="polygons that the blocks tile")
    parser.add_argument("--units-in-the-last-place", type=int, default=4, metavar="N",
                        help="how wide slits by rounding may be (4)")
    given = parser.parse_args()
    try:
        blocks = read(given.blocks)
        outline = read(given.outline) if given.outline else None
    except Unreadable as error:
        print(f"tiling.py: error: {error}", file=sys.stderr)
        return 2
    verdict, good, lines = judge(blocks, outline, given.units_in_the_last_place)
    print("\n".join([*lines, verdict]))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
