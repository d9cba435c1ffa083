"""Deceleration is mu g, joints or not."""

import numpy as np
from suite.chart import Chart
from suite.deck import turned
from suite.numbers import slope

LENGTH = "long"
MU, G, SPEED = 0.4, 10.0, 10.0
# deck, turned by, stiffness, way
SCENES = (("fixed", 0, 1e7, 1), ("fixed", 33, 1e7, 1), ("fixed", 0, 1e7, -1),
          ("free", 0, 1e9, 1), ("free", 0, 1e9, -1), ("free", 0, 1e8, 1), ("free", 0, 1e8, -1),
          ("free", 33, 1e8, 1), ("free", 33, 1e8, -1), ("free", 0, 1e7, 1), ("free", 0, 1e7, -1))


def scene(text, stiffness, way):
    """The deck with this stiffness; to the left the box starts 10 m farther to the right."""
    text = text.replace("1.E7", f"{stiffness:g}")
    if way > 0:
        return text
    assert "0, 0, 1, 1\n0, 1, 1, 0" in text and "SETVEL, 1, 0, 10, 0, 0" in text
    return text.replace("0, 0, 1, 1\n0, 1, 1, 0", "10, 10, 11, 11\n0, 1, 1, 0").replace(
        "SETVEL, 1, 0, 10, 0, 0", "SETVEL, 1, 0, -10, 0, 0")


def check(case):
    chart = Chart("A box on a floor of boxes", "time, s", "speed, m/s")
    hops = {}  # of free boxes, by stiffness
    heights = Chart("Its height less that at the start, of W / (2 K)", "way, m", "height")
    for deck, angle, stiffness, way in SCENES:
        run = case.run(deck, text=turned(scene(case.text(deck + ".deck"), stiffness, way), angle))
        moving = run.times > 1.001
        t = run.times[moving]
        x, v = run.of("Centroid", 1)[moving, :2], run.of("Velocity", 1)[moving, :2]
        right = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        what = (f"{deck} boxes, K {stiffness:g}" + (f", turned by {angle} degrees" if angle else "") +
                (", to the left" if way < 0 else ""))
        case.equal(f"{what}: deceleration", MU * G, -slope(t, v @ right * way), 1e-3,
                   f"over {(x[-1] - x[0]) @ right * way:.1f} m; the box swings on its springs at the "
                   "joints", "m/s2")
        if angle == 0 and way > 0:
            chart.ours(t[::3], (v @ right)[::3], what)
        height = x @ np.array([-right[1], right[0]]) / (2000 * G / (2 * stiffness))
        hop = np.ptp(height)
        if way > 0 and angle == 0:
            heights.ours((x - x[0]) @ right, height - height[0], what, line=True)
        if deck == "fixed":
            case.at_most(f"{what}: it rises or falls by, of its overlap W / (2 K)", 1, hop,
                         "no hop: springs on both sides of a joint are handed over")
        else:
            hops.setdefault(stiffness, []).append(hop)
    for stiffness, some in hops.items():
        case.at_most(f"free boxes, K {stiffness:g}: it rises or falls by, of its overlap W / (2 K), "
                     "largest of all", 2, max(some),
                     "box and floor give by up to W / (2 K) more when one box carries all than when "
                     "two do; twice that if suddenly")
    chart.expected([1, 2], [SPEED, SPEED - MU * G], "v0 - mu g t")
    case.chart(chart)
    case.chart(heights)
