#!/usr/bin/python3
"""Compares the pages of decks with runs: check_deck_pages.py SOURCE PROGRAM [DECK...].

The commands of each page run, and numbers that it quotes are measured again: they hold within one
unit of their last digit, whole numbers exactly, and within a quarter if the page says `about`."""

import math
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
SOURCE, PROGRAM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "validation/problems"))

from shown import NUMBER, is_about, value_of  # noqa: E402
from suite.numbers import first_time, slope as rate  # noqa: E402
from suite import trough  # noqa: E402
from suite.results import Results  # noqa: E402


def blocks(folder, *words):
    done = subprocess.run([PROGRAM, *map(str, words)], cwd=folder, text=True, capture_output=True)
    assert done.returncode == 0, f"blocks {' '.join(map(str, words))}: {done.returncode}\n{done.stderr}"


def run(folder, name, *options):
    """Returns the results of the deck. The options are those of `blocks run`."""
    stem = folder / f"{name}_again"
    blocks(folder, "run", "-q", "-j", 1, SOURCE / f"decks/{name}/{name}.deck", "-o", stem, *options)
    return Results(stem, 0)


def bounce(results, _):
    z = 0.2 * math.sqrt(2)
    yield r"= # *\n\nof its speed", math.exp(-z * (math.pi - 2 * math.asin(z)) / math.sqrt(1 - z * z))
    for block in (2, 3, 4):
        y, v = results.of("Centroid", block)[:, 1], results.of("Velocity", block)[:, 1]
        down = math.sqrt(v[0] ** 2 + 2 * 9.81 * (y[0] - 0.5))
        flight = np.flatnonzero((v > 0) & (y > 0.51))[0]  # This is the time after the first bounce.
        up = math.sqrt(v[flight] ** 2 + 2 * 9.81 * (y[flight] - 0.5))
        yield rf"{down:.3f} -> # m/s", up
        yield rf"{down:.3f} -> \S+ m/s \(#\)", up / down
    yield r"overlap is\s#\sm = M g / \(2 Kn\)", results.summary["worst_overlap"]["end"]


def sliding(results, _):
    late = results.times > 0.29
    for block in (2, 3):
        speed = np.hypot(*results.of("Velocity", block)[late, :2].T)
        yield r"4 s: # for both boxes", rate(results.times[late], speed)
    yield r"worst overlap is # m", results.summary["worst_overlap"]["ever"]


def stack(results, _):
    page = (SOURCE / "decks/stack/README.md").read_text()
    bricks = results.all("Centroid")[:, :, 1]
    aligned = [b for b in range(1, 13) if math.isclose(results.all("Centroid")[0, b, 0], 1.5)]
    assert len(aligned) == 6 and page.count("measured, mm") == 1
    for k, b in enumerate(sorted(aligned, key=lambda b: bricks[0, b])):
        yield r"measured, mm" + r" \| \S+" * k + r" \| #", 1e3 * (bricks[0, b] - bricks[-1, b])
    yield r"Measured: # mm, the worst overlap at the end", 1e3 * results.summary["worst_overlap"]["end"]
    yield r"leans by up to # *\ndegrees", math.degrees(np.abs(results.all("Angle")[-1]).max())


def toppling(results, _):
    turned = [abs(math.degrees(results.of("Angle", block)[-1])) for block in (2, 3)]
    yield r"first has turned by # degrees", turned[0]
    yield r"second has turned *\nby # degrees", turned[1]
    flat = first_time(results.times, np.abs(np.degrees(results.of("Angle", 3))), 89.5)
    yield r"since # s", flat
    assert results.summary["worst_overlap"]["ever"] < 0.05, "2 cm by the page, as it lands"


def wave(results, folder):
    fine = run(folder, "wave", "--set", "PLOTS.dtplot=5e-5")
    pressure = -fine.all("Stress")[:, :, 0]
    at = range(6, 37)
    times = [first_time(fine.times, pressure[:, b - 1], 0.5e6) for b in at]
    speed = rate(times, np.array(at, float))
    yield r"gives # m/s. Measured", math.sqrt(1 / (1 / 1.2e10 + 1 / (4 * 2e11)) / 2500)
    yield r"dtplot=5e-5`\): # m/s", speed
    yield r"overshoots to # MPa", pressure[:, 5:36].max() / 1e6
    yield r"Worst overlap: # m", results.summary["worst_overlap"]["ever"]


def tunnel(results, _):
    yield r"Of # blocks", results.blocks
    removed = [np.sum(results.all("Fixed")[results.times < until][-1] == 3) for until in (0.39, 0.59)]
    yield r"blocks, # are removed after 0.2 s", removed[0]
    yield r"after 0.2 s and # more after 0.4 s", removed[1] - removed[0]
    yield r"= # s, and would then\nhave", math.sqrt(2 * 3 / 9.81)
    yield r"have # m/s", math.sqrt(2 * 3 * 9.81)
    yield r"before it lands: # m/s", -results.of("Velocity", 72)[:, 1].min()
    roof = results.of("Centroid", 84)[:, 1]
    yield r"sink by another # mm", 1e3 * (roof[results.times < 0.59][-1] - roof[-1])


def slope(results, _):
    yield r"was cut: # blocks", results.summary["cuts"][0]["blocks"]
    assert results.summary["cuts"][0]["contractions"] == 4 and results.summary["cuts"][0]["joints"][0]["pruned"] == 0
    yield r"cos 35\)` = # m/s2", 9.81 * (math.sin(math.radians(35)) - 0.4 * math.cos(math.radians(35)))
    during = (results.times > 0.35) & (results.times < 1.05)
    for block, form in ((22, r"block 22 at the crest: # m/s2"), (20, r"before it: # m/s2 for block 20")):
        speed = np.hypot(*results.of("Velocity", block)[during, :2].T)
        yield form, rate(results.times[during], speed)


def footing(results, folder):
    def sunk(run, time):
        y = run.of("Centroid", 3)[:, 1]
        return y[0] - np.interp(time, run.times, y)

    fine = run(folder, "footing", "--set", "PLOTS.dtplot=.01")
    yield r"sunk by # m at 0.46", sunk(fine, 0.46)
    yield r"and by # m at 0.66", sunk(fine, 0.66)
    yield r"and sinks by # m", sunk(run(folder, "footing", "--set", "FRICTN.fric=.4"), 0.7)


def opening(results, folder):
    deck = SOURCE / "decks/opening/opening.deck"
    told = subprocess.run([PROGRAM, "check", deck], text=True, capture_output=True).stdout
    yield r"reports # loose ends", float(re.search(r"(\d+) loose ends prolonged", told)[1])
    told = subprocess.run([PROGRAM, "check", deck, "--set", "TRACES.snap=0"], text=True, capture_output=True).stdout
    yield r"only # blocks", float(re.search(r"blocks 4 to (\d+)", told)[1]) - 3
    yield r"takes the # blocks", np.sum(results.all("Fixed")[-1] == 3)
    y = results.of("Centroid", 38)[:, 1]
    yield r"fallen by # m", y[0] - y[-1]


def every_card(results, _):
    yield r"\n# steps", results.summary["steps"]
    yield r"steps to\st\s=\s# s", results.summary["time"]


def crater(results, _):
    yield r"\(# steps", results.summary["steps"]
    yield r"of # blocks have", results.blocks
    risen = (results.all("Centroid")[-1] - results.all("Centroid")[0])[:, 1] > 0.5
    assert 10 <= risen.sum() <= 60, f"{risen.sum()} blocks have risen: no crater"


def subsidence(results, _):
    yield r"# blocks\.", results.blocks
    yield r"\(# steps", math.ceil(6 / results.dt - 1e-9)


def subsidence_solve(results, _):
    yield r"takes\s#\ssteps", results.summary["steps"]
    yield r"steps to\st\s=\s# s", results.summary["time"]
    x, s = trough.surface(results, 49.9)
    yield r"trough is # m deep", s.max() - np.median(s[x > 70])


def circular_opening(results, _):
    yield r"There are # blocks", results.blocks
    yield r"rest after # steps", results.summary["steps"]
    crown = results.of("Centroid", 329)[:, 1]
    yield r"has sunk by\s#\smm", 1e3 * (crown[0] - crown[-1])


def direct_shear(results, _):
    yield r"every 1 ms \| # MPa", np.abs(results.of("Force", 1)[:, 0]).max() / 1e6
    height = results.of("Centroid", 2)[results.times > 0.049, 1]
    yield r"\| measured \| # mm", 1e3 * (height.max() - height[0])


def biaxial(results, _):
    slides = results.times > 1
    yield r"mean from 1 s to 5 s \| # MN", results.of("Force", 4)[slides, 1].mean() / 1e6
    yield r"largest error \| # kN", np.abs(results.of("Force", 3)[slides, 0] - 2e6).max() / 1e3
    yield r"\| measured \| # mm/s", 1e3 * rate(results.times[slides], results.of("Centroid", 3)[slides, 0])


def cohesive_slope(results, _):
    yield r"cohesion of # MPa", 1.0
    assert results.blocks > 10


def overhang(results, _):
    yield r"cut into # blocks", results.blocks - 2


def quiet_column(results, _):
    energy = results.summary["energy"]
    yield r"layers reaches # m/s", results.of("Velocity", 36)[:, 0].max()
    yield r"# J are left", energy["kinetic"] + energy["elastic"] + energy["strain"]
    yield r"left of the # J", energy["loads"]


def beam(results, _):
    cracks = results.summary["cracks"]
    assert [crack["parent"] for crack in cracks[:3]] == [12, 29, 46], cracks[:3]
    yield r"splits first, at # s", cracks[0]["time"]
    yield r"four\srows\sin # ms", 1e3 * (cracks[2]["time"] - cracks[0]["time"])
    yield r"there are # cracks", len(cracks)
    moment = 2500 * 9.81 * (4**2 / 8 - 0.125**2 / 2 - 0.25**2 / 24)
    stress = 12 * moment * 0.375
    yield r"gives # kPa", 1e-3 * stress
    yield r"expected at # s", 1.2e5 / stress
    yield r"comes # % later", 100 * (cracks[0]["time"] * stress / 1.2e5 - 1)


def disc(results, _):
    stress = {crack["parent"]: crack["stress"] for crack in results.summary["cracks"]}
    assert {crack["cause"] for crack in results.summary["cracks"]} == {"point loads"}
    yield r"tenp / 2 \| # MN/m", math.pi / 2
    yield r"between plates splits \| # MPa", 1e-6 * stress[5]
    yield r"between wedges splits \| # MPa", 1e-6 * stress[6]


def roof(results, _):
    cracks = results.summary["cracks"]
    assert 25 <= len(cracks) <= 110, len(cracks)
    to_5_m = results.summary["time"] - 2.0
    assert cracks[0]["time"] > to_5_m, cracks[0]
    lowest_bed = [crack for crack in cracks if 12 <= crack["parent"] < 52]
    assert len(lowest_bed) >= len(cracks) / 3, cracks
    return ()  # the numbers of the page are ranges


def crater_cracks(results, _):
    cracks = results.summary["cracks"]
    yield r"There are # cracks", len(cracks)
    yield r"first after # ms", 1e3 * cracks[0]["time"]
    yield r"blocks \| 162 \| #", results.blocks
    yield r"15.3 m \| y = # m", results.all("Centroid")[-1][:, 1].max()
    yield r"24,613 \| #", results.summary["steps"]


def cut_slope(results, folder):
    blocks(folder, "fos", "-q", SOURCE / "decks/cut_slope/cut_slope.deck", "--width", ".02", "-o", folder / "cut_slope")
    found = Results(folder / "cut_slope", 0).summary["factor_of_safety"]
    yield r"between # and", found["lower"]
    yield r"between 1.53125 and #\.", found["upper"]
    yield r"the # trials", len(found["trials"])
    yield r"after # steps of SOLVE", results.summary["solves"][0]["steps"]


def wet_slope(results, folder):
    blocks(folder, "fos", "-q", SOURCE / "decks/wet_slope/wet_slope.deck", "--width", ".02", "-o", folder / "wet_slope")
    found = Results(folder / "wet_slope", 0).summary["factor_of_safety"]
    yield r"to between # and", found["lower"]
    yield r"between 1.328125 and #\.", found["upper"]
    yield r"after # steps, and", results.summary["solves"][0]["steps"]
    yield r"# steps when the table", results.summary["solves"][1]["steps"]


# Long runs. What the pages of these decks say is checked without them.
SHORT = {"subsidence": ["MOTION.dt=0.001"],
         "cohesive_slope": ["MOTION[1].dt=0.01", "MOTION[2].dt=0.01"],
         "overhang": ["MOTION[1].dt=0.001", "MOTION[2].dt=0.001"]}


def unlike(name, page, form, value):
    """Returns the fault of the number at # of the form, or nothing."""
    found = re.search(form.replace("#", rf"(about\s+)?{NUMBER}"), page)
    if not found:
        return [f"{name}: the page does not say {form}"]
    about, shown = found.groups()
    digits = re.fullmatch(r"-?[\d,]+(?:\.(\d+))?(?:e(-?\d+))?", shown)
    unit = 10.0 ** (int(digits[2] or 0) - len(digits[1] or ""))
    last_digit = abs(value_of(shown) - value) <= (1.01 * unit if unit < 1 else 0.5)
    if is_about(value_of(shown), value) if about else last_digit:
        return []
    return [f"{name}: the page says {about or ''}{shown}, the run {value:.6g}: {form}"]


def check(name, folder):
    page = (SOURCE / f"decks/{name}/README.md").read_text()
    if name in SHORT:
        results = run(folder, name, *(word for one in SHORT[name] for word in ("--set", one)))
    else:
        results = run(folder, name)
        (folder / f"{name}.vtkhdf").hardlink_to(folder / f"{name}_again.vtkhdf")
        for line in re.findall(r"^    blocks (plot .*)$", page, re.M):
            if ".failing." not in line:  # those of blocks fos
                blocks(folder, *shlex.split(line))
    faults = [fault for form, value in globals()[name](results, folder)
              for fault in unlike(name, page, form, value)]
    return faults


def main():
    names = sys.argv[3:] or sorted(path.parent.name for path in SOURCE.glob("decks/*/README.md"))
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            faults += check(name, Path(folder))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
