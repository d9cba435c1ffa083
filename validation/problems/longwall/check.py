"""Deflection of the roof before it caves, against a published continuum answer."""

import numpy as np
from suite.chart import Chart

LENGTH = "long"
PUBLISHED = {1: 0.57, 10: 0.23, 100: 0.19}  # ks, GPa/m: m
MIDDLE = 15  # the block of the lowest bed at x = 0


def deflection(run):
    """Returns the times after the roof is released and the deflection of its middle."""
    begin = np.searchsorted(run.times, 8.0)
    y = run.of("Centroid", MIDDLE)[:, 1]
    return run.times[begin:] - run.times[begin], y[begin] - y[begin:]


def caving(t, w):
    """Returns the deflection when the speed is three times that of the first second."""
    speed = np.gradient(w, t)
    first = w[np.searchsorted(t, 1.0)] / 1.0
    fast = np.nonzero((speed > 3 * first) & (t > 1))[0]
    return w[fast[0]] if len(fast) else w.max()


def check(case):
    deck = case.text("longwall.deck")
    runs = case.run_all([("longwall", (), deck.replace("5.E8", f"{5e8 * ks:g}"))
                         for ks in PUBLISHED])
    chart = Chart("Middle of the roof while its support is taken away (0 to 4 s)", "time, s",
                  "deflection, m")
    ours = []
    for (ks, published), run in zip(PUBLISHED.items(), runs):
        t, w = deflection(run)
        ours.append(caving(t, w))
        case.equal(f"ks = {ks} GPa/m: deflection where caving begins", published, ours[-1],
                   0.1, "two digits, read from a figure", "m")
        shown = w < 3.2
        chart.ours(t[shown], w[shown], f"ks = {ks} GPa/m", line=True)
    case.at_most("deflection for ks = 10 GPa/m over that for 1 GPa/m", 1.0, ours[1] / ours[0],
                 "stiffer bedding deflects less; continuum 0.40")
    case.at_most("deflection for ks = 100 GPa/m over that for 1 GPa/m", 1.0, ours[2] / ours[0],
                 "stiffer bedding deflects less; continuum 0.33")
    case.at_most("lowest bed sinks at most by", 3.2, max(deflection(run)[1].max() for run in runs),
                 "the seam is 3 m high, blocks deform by centimetres", "m")
    case.chart(chart)
    case.picture(runs[0], "-t", "8,11,13", "--columns", 3, "--mirror", 0, "--colour",
                 "displacement")
