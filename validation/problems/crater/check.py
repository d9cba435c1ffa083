"""Width and depth of the crater over five layerings."""

import re

import numpy as np
from suite.chart import Chart

LENGTH = "long"
SEEDS = (1, 2, 3, 4, 5)
SURFACE = 6.0
CHARGE = 3.0  # depth of the bottom of the charge, m


def crater(run):
    """Returns, for blocks that have risen by more than 0.25 m: half width, depth, height of the
    highest block, number of blocks, and largest x of a corner by level."""
    way = (run.all("Centroid")[-1] - run.all("Centroid")[0])[:, 1]
    width, depth, rim = 0.0, 0.0, {}
    for block in run.free():
        start = run.outline(block, 0)
        low, high = start[:, 1].min(), start[:, 1].max()
        if way[block - 1] <= 0.25:
            continue
        level = round(low + high, 1) / 2
        rim[level] = max(rim.get(level, 0.0), start[:, 0].max())
        if high > SURFACE - 0.01:
            width = max(width, start[:, 0].max())
        if start[:, 0].min() < 1.0:
            depth = max(depth, SURFACE - low)
    return width, depth, run.all("Centroid")[-1, :, 1].max(), int((way > 0.25).sum()), rim


def spread(values, unit):
    return f"{np.mean(values):.3g} +- {np.std(values, ddof=1):.2g} {unit}"


def with_charge(text, factor):
    """Returns the deck with pressures and initial velocities multiplied by this factor."""
    def scaled(match):
        words = match[0].split(",")
        return ",".join(words[:3] + [f" {factor * float(word):g}" for word in words[3:]])

    text, count = re.subn(r"^(SETVEL|PRESSBC),.*$", scaled, text, flags=re.M)
    assert count == 6, count
    return text


def check(case):
    text = case.text("decks/crater/crater.deck")
    runs = case.run_all([("decks/crater/crater.deck", ("--seed", seed), None) for seed in SEEDS])
    width, depth, height, moved, rims = zip(*(crater(run) for run in runs))
    weak, none = (case.run_all([(f"crater_{factor:g}", ("--seed", seed), with_charge(text, factor))
                                for seed in SEEDS]) for factor in (0.5, 0.0))
    case.at_most("risen blocks without the explosion, most of five layerings", 0,
                 max(crater(run)[3] for run in none), "the hole alone lifts nothing")
    case.at_most("risen blocks with half the pressure and half the velocities, of those with all",
                 1.0, sum(crater(run)[3] for run in weak) / sum(moved),
                 "a quarter of the energy lifts fewer blocks")
    case.at_most("deepest crater of five layerings", CHARGE, max(depth),
                 "nothing drives up what lies below the charge", "m")
    case.at_least("width at the surface over width at the roof of the charge, least of five", 1.0,
                  min(width[k] / rims[k][4.25] for k in range(len(SEEDS))),
                  "a crater opens upwards")
    case.at_most("largest move of a corner at the fixed sides, x > 7.9 m and y < 5 m", 0.25, max(
        np.linalg.norm(run.outline(b, -1) - run.outline(b, 0), axis=1).max()
        for run in runs for b in run.free()
        if run.outline(b, 0)[:, 0].max() > 7.9 and run.outline(b, 0)[:, 1].max() < 5),
        "the crater ends within the model", "m")
    five = "five layerings, mean and standard deviation"
    case.measured("half width of the crater", spread(width, "m"), five)
    case.measured("depth of the crater", spread(depth, "m"), five)
    case.measured("width over depth", spread(2 * np.array(width) / np.array(depth), ""), five)
    case.measured("height of the highest block above the surface at 0.5 s",
              spread(np.array(height) - SURFACE, "m"), five)
    case.measured("blocks that have risen by more than 0.25 m", spread(moved, ""), five)
    case.measured("worst overlap on the way", spread(
        [1e3 * run.summary["worst_overlap"]["ever"] for run in runs], "mm"), five)
    chart = Chart("Rim of the crater by level: blocks that have risen by more than 0.25 m", "x, m",
                  "y, m (surface 6, charge 3 to 4)")
    for seed, rim in zip(SEEDS, rims):
        levels = sorted(rim)
        chart.ours([rim[y] for y in levels], levels, f"seed {seed}")
    case.chart(chart)
    case.picture(runs[0], "-t", "0.02,0.1,0.5", "--columns", 3, "--mirror", 0, "--colour", "speed")
