#!/usr/bin/python3
"""Tests of validation/tiling/tiling.py: tiling_test.py SOURCE. Each verdict from shapes whose answer is known."""

import math
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
TILING = Path(sys.argv[1]) / "validation/tiling/tiling.py"
sys.path.insert(0, str(TILING.parent))
import tiling  # noqa: E402

SQUARE = [(0, 0), (0, 2), (2, 2), (2, 0)]
ULP = math.ulp(2.0)


def polygons(*shapes):
    return [[tiling.turned(tiling.ring(shape, "test"), False)] for shape in shapes]


def verdict(blocks, outline=SQUARE):
    return tiling.judge(polygons(*blocks), polygons(outline) if outline else None)[0]


def test_verdicts():
    left, right = [(0, 0), (0, 2), (1, 2), (1, 0)], [(1, 0), (1, 2), (2, 2), (2, 0)]
    low, high = [(1, 0), (1, 1), (2, 1), (2, 0)], [(1, 1), (1, 2), (2, 2), (2, 1)]
    assert verdict([left, right]) == "tiles exactly"
    assert verdict([left[::-1], right]) == "tiles exactly", "the direction of rings is not told"
    assert verdict([left, low, high]) == "tiles exactly", "a T-junction"
    assert verdict([left, low]) == "does not tile"
    assert verdict([left, right, [(3, 0), (3, 1), (4, 0)]]) == "does not tile", "beyond the outline"
    assert verdict([left, right, low]) == "overlaps"
    wide = [(0, 0), (0, 2), (1 + ULP, 2), (1, 0)]
    assert verdict([wide, right]) == "overlaps", "by one unit in the last place"
    assert verdict([[(0, 0), (0, 2), (1 - ULP, 2), (1, 0)], right]) == "tiles up to rounding"
    assert verdict([[(0, 0), (0, 2), (1 - 40 * ULP, 2), (1, 0)], right]) == "does not tile"
    assert verdict([left, right], None) == "no overlap" and verdict([left, left], None) == "overlaps"
    assert verdict([[(0, 0), (2, 2), (2, 0), (0, 2)]]) == "block 1 is not simple"
    assert verdict([[(0, 0), (0, 2), (2, 2), (2, 0), (3, 0), (2, 0)]]) == "block 1 is not simple", "a spike"


def test_cross_of_thin_slits():
    # A T-vertex off its side by a unit in the last place, in a turned frame.
    c, s = math.cos(0.3), math.sin(0.3)

    def at(x, y):
        return c * x - s * y, s * x + c * y
    middle = tuple((a + b) / 2 for a, b in zip(at(1, 0), at(1, 2)))
    left = [at(0, 0), at(0, 2), at(1, 2), at(1, 0)]
    low = [at(1, 0), middle, at(2, 1), at(2, 0)]
    high = [middle, at(1, 2), at(2, 2), at(2, 1)]
    outline = [at(0, 0), at(0, 2), at(1, 2), at(2, 2), at(2, 1), at(2, 0), at(1, 0)]
    found = verdict([left, low, high], outline)
    exact = tiling.cross(*(tiling.ring([at(1, 0), at(1, 2), middle], "test")))
    assert found == ("tiles exactly" if exact == 0 else "overlaps" if exact > 0 else "tiles up to rounding"), found


def test_areas_are_exact():
    blocks = polygons([(0, 0), (0, 2), (2, 2), (2, 0)], [(1, 1), (1, 3), (3, 3), (3, 1)])
    _, _, lines = tiling.judge(blocks, polygons([(0, 0), (0, 4), (4, 4), (4, 0)]))
    assert "area of overlaps: 1, 1 deep" in lines and "area without a block: 9, about 4 wide" in lines, lines


def test_holes():
    ring = [[(0, 0), (0, 3), (3, 3), (3, 0)], [(1, 1), (2, 1), (2, 2), (1, 2)]]
    block = [[tiling.turned(tiling.ring(part, "test"), k > 0) for k, part in enumerate(ring)]]
    whole = polygons([(0, 0), (0, 3), (3, 3), (3, 0)])
    assert tiling.judge(block, whole)[0] == "does not tile"
    assert tiling.judge(block + polygons([(1, 1), (1, 2), (2, 2), (2, 1)]), whole)[0] == "tiles exactly"


FILES = {
    "a.geojson": '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry": '
                 '{"type": "MultiPolygon", "coordinates": [[[[0,0],[0,2],[1,2],[1,0],[0,0]]], '
                 '[[[1,0],[1,2],[2,2],[2,0],[1,0]]]]}}]}',
    "a.wkt": "POLYGON M ((0 0 5, 0 2 1, 1 2 1, 1 0 0, 0 0 5))\nMULTIPOLYGON (((1 0, 1 2, 2 2, 2 0, 1 0)))\n",
    "a.dxf": "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n4\n70\n1\n10\n0\n20\n0\n10\n0\n20\n2\n10\n1\n20\n2\n10\n1\n20\n"
             "0\n0\nPOLYLINE\n70\n1\n10\n0\n20\n0\n0\nVERTEX\n10\n1\n20\n0\n0\nVERTEX\n10\n1\n20\n2\n0\nVERTEX\n10\n2\n20"
             "\n2\n0\nVERTEX\n10\n2\n20\n0\n0\nSEQEND\n0\nENDSEC\n0\nEOF\n"}
BAD = {"none.geojson": '{"type": "Point", "coordinates": [0, 0]}', "cut.geojson": '{"type": ', "nan.wkt":
       "POLYGON ((0 0, nan 1, 1 1))", "two.wkt": "POLYGON ((0 0, 1 1))", "words.wkt": "POLYGON ((a b, c d, e f))"}


def test_files():
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "o.wkt").write_text("POLYGON ((0 0, 0 2, 2 2, 2 0, 0 0))")

        def judged(name, text):
            (folder / name).write_text(text)
            return subprocess.run([sys.executable, TILING, folder / name, "--outline", folder / "o.wkt"], check=False,
                                  capture_output=True, text=True)
        for name, text in FILES.items():
            done = judged(name, text)
            assert done.returncode == 0 and done.stdout.endswith("tiles exactly\n"), (name, done)
        for name, text in BAD.items():
            done = judged(name, text)
            assert done.returncode == 2 and done.stderr.startswith("tiling.py: error: "), (name, done)


for name, test in list(globals().items()):
    if name.startswith("test_"):
        test()
        print(name)
