"""Deceleration is mu g, joints or not."""

import numpy as np
from suite.chart import Chart
from suite.deck import turned
from suite.numbers import slope

LENGTH = "medium"  # it has a known miss
MU, G = 0.4, 10.0
SOFT = ("the box under the slider sinks by a thousandth of its height, so the slider runs against "
        "the side of the next one by as much and hops; stiffer contacts lose nothing.")


def check(case):
    chart = Chart("A box on a floor of boxes", "time, s", "speed, m/s")
    for deck, angle, stiffness in (("fixed", 0, 1e7), ("fixed", 33, 1e7), ("free", 0, 1e9),
                                   ("free", 0, 1e8), ("free", 33, 1e8), ("free", 0, 1e7)):
        text = case.text(deck + ".deck").replace("1.E7", f"{stiffness:g}")
        run = case.run(deck, text=turned(text, angle))
        moving = run.times > 1.001
        t = run.times[moving]
        x, v = run.of("Centroid", 1)[moving, :2], run.of("Velocity", 1)[moving, :2]
        along = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        what = f"{deck} boxes, K {stiffness:g}" + (f", turned by {angle} degrees" if angle else "")
        case.equal(f"{what}: deceleration over {(x[-1] - x[0]) @ along:.1f} m", MU * G,
                   -slope(t, v @ along), 1e-3, "the box swings on its springs at the joints",
                   "m/s2", note=SOFT)
        if angle == 0:
            chart.ours(t[::3], (v @ along)[::3], what)
        hop = np.ptp(x @ np.array([-along[1], along[0]])) / (2000 * G / (2 * stiffness))
        if deck == "fixed":
            case.at_most(f"{what}: it rises or falls by, of its overlap W / (2 K)", 1, hop,
                         "no hop: springs on both sides of a joint are handed over")
        else:
            case.told(f"{what}: it rises or falls by, of its overlap W / (2 K)", hop,
                      "the boxes spring up behind it")
    chart.expected([1, 2], [10, 10 - MU * G], "v0 - mu g t")
    case.chart(chart)
