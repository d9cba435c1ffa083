"""Deceleration is mu g, joints or not."""

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.numbers import order, slope

LENGTH = "long"
MU, G, SPEED = 0.4, 10.0, 10.0
# deck, angle of the frame, stiffness, direction
SCENES = (("fixed", 0, 1e7, 1), ("fixed", 33, 1e7, 1), ("fixed", 0, 1e7, -1),
          ("free", 0, 1e9, 1), ("free", 0, 1e9, -1), ("free", 0, 1e8, 1), ("free", 0, 1e8, -1),
          ("free", 33, 1e8, 1), ("free", 33, 1e8, -1), ("free", 0, 1e7, 1), ("free", 0, 1e7, -1))


def scene(text, stiffness, way, beside=0.0):
    """Returns the deck with this stiffness. A box that moves to the left starts 10 m farther to the
    right. It starts flush with a joint, or this far beside it."""
    text = text.replace("1.E7", f"{stiffness:g}")
    assert "0, 0, 1, 1\n0, 1, 1, 0" in text and "SETVEL, 1, 0, 10, 0, 0" in text
    left = beside + (0 if way > 0 else 10)
    return text.replace("0, 0, 1, 1\n0, 1, 1, 0", f"{left}, {left}, {left + 1}, {left + 1}\n0, 1, 1, 0").replace(
        "SETVEL, 1, 0, 10, 0, 0", f"SETVEL, 1, 0, {10 * way}, 0, 0")


def with_law(text, stiffness):
    """Returns the deck with a law that has this stiffness K at each end of a face of 1 m."""
    per_area = 2 * stiffness
    law = f"JOINT, 1, {MU}, , , , , , , , {per_area:g}, {per_area:g}\nJPAIR, 1, 1, 1\n"
    assert "FRICTN, 0.4\n" in text
    return text.replace("FRICTN, 0.4\n", "FRICTN, 0.4\n" + law)


def losses(case, stiffness, beside, fraction=0.02, law=False):
    """Returns the speed that the box has lost 0.02 s after its start, beyond mu g t, in frames
    turned by six angles and in both directions [m/s]. law: contacts have a law with kn."""
    frames = [(7 + 60.37 * k, way) for k in range(6) for way in (1, -1)]
    decks = [turned(with_lines(scene(case.text("free.deck"), stiffness, way, beside), PLOTS="PLOTS, 0.02",
                               FRACTION=f"FRACTION, {fraction}").replace("MOTION, 1\nSTOP", "MOTION, 0.1\nSTOP"),
                    angle) for angle, way in frames]
    if law:
        decks = [with_law(deck, stiffness) for deck in decks]
    lost = []
    for run, (angle, way) in zip(case.run_all([("free.deck", (), deck) for deck in decks]), frames):
        at = np.searchsorted(run.times, 1.0195)
        right = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        speed = run.of("Velocity", 1)[at, :2] @ right * way
        lost.append(SPEED - MU * G * (run.times[at] - 1) - speed)
    return np.array(lost)


def starts(case):
    """Adds rows for a box that starts flush with a joint and one that starts beside it."""
    for stiffness in (1e8, 1e9):
        for beside, where in ((0.3, "0.3 m beside a joint"), (0.0, "flush with a joint")):
            lost = losses(case, stiffness, beside)
            case.at_most(f"free boxes, K {stiffness:g}, begun {where}, six frames and both ways: runs that "
                         "lose 0.05 m/s or more at the start", 0, int((lost >= 0.05).sum()),
                         "friction takes 0.08 m/s, and nothing else does")
    fractions = (0.01, 0.005, 0.0025)
    largest = [losses(case, 1e8, 0.0, f).max() for f in fractions]
    case.equal("begun flush, K 1e+08: order in FRACTION of the largest loss", 1, order(fractions, largest),
               0.1, f"{', '.join(f'{v:.3f}' for v in largest)} m/s at FRACTION 0.01, 0.005, 0.0025: what "
               "one step does goes with dt")


def laws(case, chart):
    """Adds rows for contacts with a law that has a stiffness per area."""
    hops, decelerations = {}, []
    runs = case.run_all([(deck + ".deck", (), with_law(turned(scene(case.text(deck + ".deck"),
                                                                    stiffness, way), angle), stiffness))
                         for deck, angle, stiffness, way in SCENES])
    for run, (deck, angle, stiffness, way) in zip(runs, SCENES):
        moving = run.times > 1.001
        x, v = run.of("Centroid", 1)[moving, :2], run.of("Velocity", 1)[moving, :2]
        right = np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
        height = x @ np.array([-right[1], right[0]]) / (2000 * G / (2 * stiffness))
        hops.setdefault((deck, stiffness), []).append(np.ptp(height))
        decelerations.append(-slope(run.times[moving], v @ right * way))
        if angle == 0 and way > 0:
            chart.ours((x - x[0]) @ right, height - height[0],
                       f"{deck} boxes, K {stiffness:g}, kn", line=True)
    for (deck, stiffness), some in hops.items():
        case.at_most(f"law with kn = 2 K, {deck} boxes, K {stiffness:g}: it rises or falls by, of its "
                     "overlap W / (2 K), largest of all", 1 if deck == "fixed" else 2, max(some),
                     "as without the law")
    case.measured("law with kn = 2 K: largest error of the deceleration", max(
        abs(a / (MU * G) - 1) for a in decelerations) * 100, "of all runs; it sinks meanwhile", "%")
    for stiffness in (1e8, 1e9):
        lost = losses(case, stiffness, 0.0, law=True)
        case.at_most(f"law with kn = 2 K, free boxes, K {stiffness:g}, begun flush with a joint, six "
                     "frames and both ways: runs that lose 0.05 m/s or more at the start", 0,
                     int((lost >= 0.05).sum()), f"largest {abs(lost).max():.4f} m/s; the dashpot goes "
                     "with sqrt(kn L), so it is weak where a face begins")


def check(case):
    chart = Chart("A box on a floor of boxes", "time, s", "speed, m/s")
    hops = {}  # hops of free boxes by stiffness
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
    starts(case)
    with_kn = Chart("Its height less that at the start, of W / (2 K), law with kn = 2 K", "way, m", "height")
    laws(case, with_kn)
    chart.expected([1, 2], [SPEED, SPEED - MU * G], "v0 - mu g t")
    case.chart(chart)
    case.chart(heights)
    case.chart(with_kn)
