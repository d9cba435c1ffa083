#!/usr/bin/python3
"""Maps in shapefiles and GeoPackages, converted by the command of docs/exchange.md: ogr_test.py PROGRAM SOURCE

A map in GeoJSON is converted to both forms, and back by the documented command; the blocks are the same,
byte for byte. The exit code is 77 (skipped) where ogr2ogr of GDAL (gdal-bin) is not installed.
"""

import json
import random
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

PROGRAM, SOURCE = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
PAGE = (SOURCE / "docs/exchange.md").read_text()
DECK = """START, 3000, 100
A MAP
XLIMITS, {0}, {1}
YLIMITS, {2}, {3}
BOXES, 10, 10, 0.001
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 2500
RIGID
END
OUTLINE, 4, 1
{4}, {4}, {5}, {5}
{6}, {7}, {7}, {6}
TRACES, map.geojson, 1, {8}
CUT
STOP
"""


def command(ending):
    """The line of the page that converts a file of this kind, and not its degrees."""
    lines = [line.strip() for line in PAGE.splitlines() if line.startswith("    ogr2ogr ")]
    return next(line.split() for line in lines if f"map.{ending}" in line and "-t_srs" not in line)


def execute(folder, *words, expected=0):
    done = subprocess.run(words, cwd=folder, check=False, capture_output=True, text=True)
    assert done.returncode == expected, (words, done)
    return done


def features(lines, crs):
    """GeoJSON of lines with joint ids; numbers are as given."""
    written = ",\n".join(
        f'{{"type": "Feature", "properties": {{"joint": {joint}}}, "geometry": {{"type": "LineString", "coordinates": ['
        + ", ".join(f"[{x}, {y}]" for x, y in points) + "]}}" for joint, points in lines)
    return (f'{{"type": "FeatureCollection", "crs": {{"type": "name", "properties": {{"name": "{crs}"}}}}, '
            f'"features": [\n{written}\n]}}\n')


def blocks(folder, outline, snap):
    """The blocks of the map in GeoJSON, and what the program said."""
    x0, y0, x1, y1 = outline
    (folder / "map.deck").write_text(DECK.format(2 * x0 - x1, 2 * x1 - x0, 2 * y0 - y1, 2 * y1 - y0, x0, x1, y0, y1, snap))
    done = execute(folder, PROGRAM, "export", "map.deck", "-o", "blocks.geojson")
    return (folder / "blocks.geojson").read_text(), done.stderr


def maps():
    """Names, GeoJSON, outlines and snaps: decimals of a national grid with ends on slanted traces, and doubles
    with 17 figures."""
    grid, x0, y0 = [], 412300, 6731800
    grid.append((3, [(x0, "6731812.4"), (x0 + 40, "6731819.6")]))
    for k in range(1, 14):  # y of the slanted trace is 0.18 x, exact in five decimals
        x, y = 3000 * k - 250 + 11 * (k % 5), 12400 * 100 + 18 * (3000 * k - 250 + 11 * (k % 5))
        end = f"{y0 + y // 100000}.{y % 100000:05d}"
        grid.append((4 + k, [(f"{x0 + x // 1000}.{x % 1000:03d}", end), (f"{x0 + x // 1000}.{x % 1000:03d}", y0 + 30 * (k % 2))]))
    yield "grid", features(grid, "urn:ogc:def:crs:EPSG::25832"), (x0, y0, x0 + 40, y0 + 30), "1E-6"
    rng = random.Random(1982)
    lines = [(k, [(f"{rng.uniform(0, 1):.17g}", f"{rng.uniform(0, 1):.17g}") for _ in range(2)]) for k in range(30)]
    yield "doubles", features(lines, "urn:ogc:def:crs:EPSG::25832"), (0.1, 0.1, 0.9, 0.9), "0"


def same_blocks(folder):
    for name, text, outline, snap in maps():
        (folder / "map.geojson").write_text(text)
        given, said = blocks(folder, outline, snap)
        count = len(json.loads(given)["features"])
        assert count > 12 and "degrees" not in said, (name, count, said)
        for ending in ("shp", "gpkg"):
            (folder / "map.geojson").write_text(text)
            execute(folder, "ogr2ogr", f"map.{ending}", "map.geojson", "-nln", "LAYER" if ending == "gpkg" else "map")
            (folder / "map.geojson").unlink()
            execute(folder, *command(ending))
            assert blocks(folder, outline, snap)[0] == given, (name, ending)
            # The file itself is refused, with the command.
            (folder / "wrong.deck").write_text((folder / "map.deck").read_text().replace("map.geojson", f"map.{ending}"))
            wrong = execute(folder, PROGRAM, "check", "wrong.deck", expected=3).stderr
            assert re.search(rf"error: TRACES: map\.{ending}: this is a \w+", wrong) and "ogr2ogr" in wrong, wrong
            execute(folder, "rm", *(path.name for path in folder.glob("map.*") if path.suffix != ".deck"))
        print(f"{name}: {count} blocks, the same from a shapefile and a GeoPackage")


def degrees(folder):
    """Degrees are warned of, and not after the documented projection."""
    map_of_degrees = SOURCE / "tests/corpus/known_failures/networkgt_29_degrees.geojson"
    outline = (5.32411, 60.38975, 5.32451, 60.39005)
    shutil.copy(map_of_degrees, folder / "map.geojson")
    execute(folder, "ogr2ogr", "map.gpkg", "map.geojson", "-nln", "LAYER")
    assert "the coordinates are degrees (crs CRS84)" in blocks(folder, outline, 0)[1]
    (folder / "map.geojson").unlink()
    execute(folder, *command("gpkg"), "-lco", "RFC7946=YES")
    assert "the coordinates look like degrees" in blocks(folder, outline, 0)[1]
    (folder / "map.geojson").unlink()
    execute(folder, *next(line.split() for line in PAGE.splitlines() if line.startswith("    ogr2ogr ") and "-t_srs" in line))
    said = blocks(folder, (297450, 6700465, 297480, 6700505), 0)[1]
    assert "degrees" not in said, said
    print("degrees: warned of, and projected")


def main():
    if shutil.which("ogr2ogr") is None:
        print("skipped: ogr2ogr of GDAL (package gdal-bin) is not installed")
        return 77
    for test in (same_blocks, degrees):
        with tempfile.TemporaryDirectory() as folder:
            test(Path(folder))
    return 0


sys.exit(main())
