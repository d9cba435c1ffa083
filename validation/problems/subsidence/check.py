"""Trough against profile functions, layerings and panels; what deformation costs."""

import numpy as np
from suite import trough
from suite.chart import Chart

LENGTH = "long"
DECK = "decks/subsidence/subsidence.deck"
PANELS = (10, 15, 20, 25, 30, 40)  # half widths, m
SEEDS = (1, 2, 3, 4, 5)


def with_panel(text, half):
    """Returns the deck with coal from x = half on, in blocks of about the same width."""
    blocks = round((100 - half) / 70 * 32)
    text = text.replace("OUTPUT, 2, 3, 100, 850", "OUTPUT, 2, 3")  # There may be fewer blocks.
    return text.replace("START, 850", "START, 900").replace(
        "LAYER, -32, 2, 30,0, 30,2,", f"LAYER, -{blocks}, 2, {half},0, {half},2,")


def measure(run):
    """Returns x, the subsidence minus that of the far field, and that of the far field."""
    x, s = trough.surface(run, 49.9)
    far = np.median(s[x > 70])
    return x, s - far, far


def spread(values, unit=""):
    return f"{np.mean(values):.3g} +- {np.std(values, ddof=1):.2g} {unit}".strip()


def check(case):
    text = case.text(DECK)
    options = ("--set", "PLOTS.dtplot=2")
    runs = case.run_all([(DECK, (*options, "--seed", seed), None) for seed in SEEDS])
    x_all, s_all, depths, halves, edges, far = [], [], [], [], [], []
    for run in runs:
        x, s, sunk = measure(run)
        x_all.append(x), s_all.append(s), far.append(sunk)
        depths.append(s.max())
        halves.append(trough.reach(x, s, 0.5 * s.max()))
        edges.append(trough.reach(x, s, 0.05 * s.max()))
    five = "five layerings, mean and standard deviation"
    case.at_most("deepest trough of five layerings", 2.0, max(depths),
                 "the seam was 2 m high", "m")
    case.at_most("subsidence beyond x = 60 m, largest of five", 0.05,
                 max(np.abs(s[x > 60]).max() for x, s in zip(x_all, s_all)),
                 "30 m beside the panel the rock has only settled: a fortieth of the seam", "m")
    case.measured("depth at the surface", spread(depths, "m"), five)
    case.measured("half width at half the depth", spread(halves, "m"), five)
    case.measured("half width at 5 % of the depth", spread(edges, "m"), five)
    case.measured("angle of draw, from the edge of the panel to 5 % of the depth",
              spread(np.degrees(np.arctan((np.array(edges) - 30) / 48)), "degrees"),
              "negative: the trough is narrower than the panel")
    case.measured("settlement of the far field", spread(far, "m"), "springs of 25 layers")
    case.measured("kinetic energy at 6 s", ", ".join(
        f"{run.summary['kinetic_energy']:.0f}" for run in runs) + " J", "2e7 J on the way")

    x, s = np.concatenate(x_all), np.concatenate(s_all)
    chart = Chart("Subsidence trough at 6 s, five layerings", "x, m", "subsidence, m")
    for seed, xs, ss in zip(SEEDS, x_all, s_all):
        chart.ours(xs[xs < 60], -ss[xs < 60], f"seed {seed}")
    fine = np.linspace(0, 60, 120)
    for name, colour in zip(trough.FUNCTIONS, ("#222222", "#999999")):
        (depth, half, length), left = trough.fit(name, x, s)
        case.measured(f"{name}, fitted to all five: s_max, i, r",
                  f"{depth:.2f} m, {half:.1f} m, {length:.1f} m",
                  f"depth at x = 0: {trough.profile(name, 0.0, depth, half, length):.2f} m")
        alone = [trough.fit(name, xs, ss)[1] / ss.max() for xs, ss in zip(x_all, s_all)]
        case.measured(f"{name}: left over, of the depth; each layering by itself",
                  f"{100 * np.mean(alone):.1f} +- {100 * np.std(alone, ddof=1):.1f} %",
                  f"one curve for all five leaves {100 * left / np.mean(depths):.1f} %")
        chart.expected(fine, -trough.profile(name, fine, depth, half, length), name, colour)
    case.chart(chart)

    runs = case.run_all([(f"panel_{half}", (*options,), with_panel(text, half))
                         for half in PANELS])
    depth, width = [], []
    for half, run in zip(PANELS, runs):
        x, s, _ = measure(run)
        depth.append(s.max())
        width.append(trough.reach(x, s, 0.5 * s.max()))
        case.measured(f"panel of {2 * half} m (width / depth {2 * half / 50:.1f}): depth, half width "
                  "at half the depth", f"{depth[-1]:.3f} m, {width[-1]:.1f} m", "seed of the deck")
    case.at_least("depth over the widest panel, of that over the narrowest", 1.0,
                  depth[-1] / depth[0], "a trough grows with its panel")
    case.at_most("deepest trough of all panels", 2.0, max(depth), "the seam was 2 m high", "m")
    chart = Chart("Trough over panels of different width", "half width of the panel, m", "m")
    chart.ours(PANELS, depth, "depth, m")
    measured = [(half, w / 10) for half, d, w in zip(PANELS, depth, width) if d > 0.2]
    chart.ours(*zip(*measured), "half width at half the depth, 10 m")
    chart.expected(PANELS, [2.0] * len(PANELS), "height of the seam")
    case.chart(chart)
    case.picture(runs[4], "-t", 6, "--mirror", 0, "--colour", "displacement")

    short = ("--set", "MOTION.dt=0.3")
    per_step = {"rigid": [], "deformable": []}
    for _ in range(3):  # In turn, so that a busy machine slows both.
        for kind, deck in (("rigid", text), ("deformable", text.replace("\nRIGID\n", "\n"))):
            run = case.run(kind, *short, text=deck)
            per_step[kind].append(run.processor_seconds / run.summary["steps"])
    case.measured("processor time of a step, deformable over RIGID, best of three of 0.3 s each",
              f"{min(per_step['deformable']) / min(per_step['rigid']):.2f}",
              "the report: RIGID saves about 10 %, 1.11")
