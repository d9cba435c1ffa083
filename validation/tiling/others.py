#!/usr/bin/python3
"""Judges blocks of this and of two other generators on the same random networks: others.py PROGRAM [NUMBER]

GEOS cuts traces by unary_union and polygonize (python3-shapely). Qhull makes Voronoi cells (python3-scipy), which GEOS
clips by the outline. Prints the table of docs/joints.md#blocks-of-other-programs.
"""

import math
import random
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

import numpy as np
from scipy.spatial import Voronoi
from shapely.geometry import LineString, Polygon
from shapely.ops import polygonize, unary_union

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).parent))
import tiling  # noqa: E402

SIZE = 10.0
OUTLINE = [(0.0, 0.0), (0.0, SIZE), (SIZE, SIZE), (SIZE, 0.0)]
CARDS = "START, 20000, 200\nA\nXLIMITS, -50, 50\nYLIMITS, -50, 50\nBOXES, 9, 9, .01\nSTIFF, 1.E8, 1.E8\n" \
    "FRACTION, .02\nMATERIAL, 1, 1.E9, 4.E8, 2000\nRIGID\nEND\nOUTLINE, 4, 1\n0, 0, 10, 10\n0, 10, 10, 0\n"


def line(rng, angle, half=20.0):
    x, y = rng.uniform(0, SIZE), rng.uniform(0, SIZE)
    dx, dy = half * math.cos(math.radians(angle)), half * math.sin(math.radians(angle))
    return x - dx, y - dy, x + dx, y + dy


def two_sets(rng):
    """Joints of two sets that run through."""
    return [line(rng, rng.gauss(mean, 6)) for mean in (20, 110) for _ in range(10)]


def mapped(rng):
    """Traces of which every other one ends on another, to rounding, as mapped ones do."""
    found = [line(rng, rng.uniform(0, 180), rng.uniform(1, 6)) for _ in range(20)]
    for k in range(1, 20, 2):
        x1, y1, x2, y2 = found[k - 1]
        t = rng.random()
        found[k] = (*found[k][:2], x1 + t * (x2 - x1), y1 + t * (y2 - y1))
    return found


def bundles(rng):
    """Joints that coincide to rounding, and joints through one point."""
    found = []
    for _ in range(4):
        first = line(rng, rng.uniform(0, 180))
        found += [tuple(v + rng.choice((0, 1, -1)) * 10.0 ** rng.uniform(-16, -13) for v in first) for _ in range(3)]
    x, y = rng.uniform(3, 7), rng.uniform(3, 7)
    for _ in range(8):
        angle = rng.uniform(0, math.pi)
        dx, dy = 15 * math.cos(angle), 15 * math.sin(angle)
        found.append((x - dx, y - dy, x + dx, y + dy))
    return found


def scattered(rng):
    return [(rng.uniform(0, SIZE), rng.uniform(0, SIZE)) for _ in range(60)]


def nearly_a_grid(rng):
    """Points of a grid, off by a few rounding errors: four cells nearly meet at each point."""
    return [(1.3 * i + 0.9 + rng.choice((0, 1, -1)) * 1e-15, 1.3 * k + 0.7 + rng.choice((0, 1, -1)) * 1e-15)
            for i in range(7) for k in range(7)]


def by_program(program, card, rows):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        head = "x1,y1,x2,y2\n" if len(rows[0]) == 4 else "x,y\n"
        (folder / "rows.csv").write_text(head + "\n".join(",".join(map(repr, row)) for row in rows))
        (folder / "a.deck").write_text(f"{CARDS}{card}\nCUT\n")
        done = subprocess.run([program, "export", "-q", "a.deck", "-o", "a.geojson"], cwd=folder, check=False,
                              capture_output=True, text=True)
        return tiling.read(folder / "a.geojson") if done.returncode == 0 else None


def rings(polygons):
    return [[tiling.turned(tiling.ring(part.coords, "a cell"), k > 0)
             for k, part in enumerate((one.exterior, *one.interiors))] for one in polygons]


def by_geos(traces):
    lines = [LineString([row[:2], row[2:]]) for row in traces]
    outline = Polygon(OUTLINE)
    inside = [one.intersection(outline) for one in lines]
    return rings(polygonize(unary_union([outline.boundary, *(one for one in inside if not one.is_empty)])))


def by_qhull(points):
    # Far points make the cells of all others finite.
    cells = Voronoi(np.array([*points, (-90, -90), (-90, 99), (99, 99), (99, -90)]))
    found = []
    for k in range(len(points)):
        cell = Polygon(cells.vertices[cells.regions[cells.point_region[k]]]).intersection(Polygon(OUTLINE))
        if cell.geom_type == "Polygon" and not cell.is_empty:
            found.append(cell)
    return rings(found)


def main():
    program, number = str(Path(sys.argv[1]).resolve()), int(sys.argv[2]) if len(sys.argv) > 2 else 100
    around = [[tiling.turned(tiling.ring(OUTLINE, "outline"), False)]]
    generators = [("two sets", two_sets, "TRACES, rows.csv, 1", "GEOS", by_geos),
                  ("mapped traces", mapped, "TRACES, rows.csv, 1", "GEOS", by_geos),
                  ("bundles, one point", bundles, "TRACES, rows.csv, 1", "GEOS", by_geos),
                  ("Voronoi", scattered, "VORONOI, , , 1, rows.csv", "Qhull", by_qhull),
                  ("Voronoi, nearly a grid", nearly_a_grid, "VORONOI, , , 1, rows.csv", "Qhull", by_qhull)]
    print("| networks | generator | blocks | tiles | tiles up to rounding | overlaps | does not tile | not simple | refused |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, make, card, other, cut in generators:
        counts = {"BLOCKS": Counter(), other: Counter()}
        for seed in range(number):
            rows = make(random.Random(seed))
            for who, blocks in (("BLOCKS", by_program(program, card, rows)), (other, cut(rows))):
                verdict = "refused" if blocks is None else tiling.judge(blocks, around)[0]
                counts[who]["blocks"] += len(blocks or [])
                counts[who]["not simple" if verdict.endswith("simple") else verdict] += 1
        for who, found in counts.items():
            row = [str(found[verdict] or "") for verdict in ("tiles exactly", "tiles up to rounding", "overlaps",
                                                             "does not tile", "not simple", "refused")]
            print(f"| {name} | {who} | {found['blocks'] / number:.1f} | {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()
