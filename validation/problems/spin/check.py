"""Shape, size and angle of a spinning block."""

import numpy as np
from suite.chart import Chart

LENGTH = "quick"
SPIN = 50.0


def area(corners):
    x, y = corners.T
    return 0.5 * abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))


def check(case):
    run = case.run("spin.deck")
    t = run.times
    outlines = [run.outline(1, k) for k in range(len(t))]
    areas = np.array([area(outline) for outline in outlines])
    sides = np.array([np.linalg.norm(o - np.roll(o, 1, axis=0), axis=1) for o in outlines])
    rounding = "round-off of some thousand rotations"
    case.equal("largest change of area", 0, np.abs(areas / 2.0 - 1).max(), 1e-12, rounding,
               absolute=True)
    case.equal("largest change of a side", 0, np.abs(sides - sides[0]).max(), 1e-12, rounding,
               "m", absolute=True)
    case.equal("angle after 2 s", SPIN * t[-1], run.of("Angle", 1)[-1], 1e-12, rounding, "rad")
    turned = np.unwrap([np.arctan2(*(o[1] - o.mean(axis=0))[::-1]) for o in outlines])
    turned -= turned[0]
    h = 0.5 * SPIN * run.dt
    case.equal("angle of the corners after 2 s", 2 * np.arctan(h) / run.dt * t[-1], turned[-1],
               1e-10, "round-off; 2 atan(spin dt / 2) a step", "rad")
    steps = run.summary["steps"]
    case.measured("area by the printed, linear update, for comparison",
              f"{(1 + (SPIN * run.dt) ** 2) ** steps:.3g} times as large",
              "(1 + (spin dt)^2)^steps")
    chart = Chart("Area of a spinning block", "angle, rad", "area / first area", log="y")
    n = t / run.dt
    chart.expected(SPIN * t, (1 + (SPIN * run.dt) ** 2) ** n, "linear update, as printed")
    chart.ours(SPIN * t, areas / areas[0])
    case.chart(chart)
