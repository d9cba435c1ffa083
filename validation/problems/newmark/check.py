"""Yield acceleration and displacement of a block on a moving base."""

from math import cos, radians, sin, tan

import numpy as np
from suite.chart import Chart
from suite.numbers import slope

LENGTH = "quick"
G, PHI, PSI = 9.81, radians(30), radians(20)
YIELD, FACTOR = G * tan(PHI - PSI), cos(PHI - PSI) / cos(PHI)
DOWN = np.array([cos(PSI), -sin(PSI)])


def relative(run, field):
    return (run.of(field, 2) - run.of(field, 1))[:, :2] @ DOWN


def check(case):
    run = case.run("ramp.deck")
    t, speed = run.times, relative(run, "Velocity")
    base = -run.of("Velocity", 1)[:, 0]
    rate = 2 * slope((t[t > 1] - 1) ** 2, base[t > 1])
    sliding = speed > 0.2
    line = np.polyfit(t[sliding] - 1, np.sqrt(speed[sliding]), 1)
    case.equal("yield acceleration, of g", YIELD / G, -line[1] / line[0] * rate / G, 2e-3,
               "the base gets a little less than its force while the block holds")
    case.equal("growth of the relative speed, of the base's rate", FACTOR / 2, line[0] ** 2 / rate,
               5e-3, "as above")
    chart = Chart("Block on a base with rising acceleration", "acceleration of the base, of g",
                  "relative speed, m/s")
    a = rate * (t - 1) / G
    shown = t >= 1
    chart.expected(a[shown], FACTOR * np.maximum(a[shown] * G - YIELD, 0) ** 2 / rate / 2)
    chart.ours(a[shown][::5], speed[shown][::5])
    case.chart(chart)

    run = case.run("pulse.deck")
    t, way = run.times, relative(run, "Centroid")
    push = (t > 1.02) & (t < 1.29)
    a = slope(t[push], -run.of("Velocity", 1)[push, 0])
    case.equal("pulse: way of the block on its base", a * (a / YIELD - 1) * 0.3 ** 2 / 2 * FACTOR,
               way[-1] - way[t < 1.001][-1], 5e-3,
               "the block swings on its springs as it starts and stops", "m")
    case.equal("pulse: relative speed at the end", 0, abs(relative(run, "Velocity")[-1]), 1e-6,
               "it has stopped", "m/s", absolute=True)
    chart = Chart("Block on a base pushed with 0.5 g for 0.3 s", "time, s", "m/s and m")
    chart.ours(t - 1, relative(run, "Velocity"), "relative speed", line=True)
    chart.ours(t - 1, way - way[0], "relative way", line=True)
    case.chart(chart)
