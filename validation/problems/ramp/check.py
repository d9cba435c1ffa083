"""Sudden gravity doubles the force of a spring and breaks what would hold; a ramp does not."""

import math

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "long"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
K, W = 2e7, 2e4  # N/m, N
PERIOD = 2 * math.pi / math.sqrt(K / 2000)
RAMPS = (0.0, 0.5, 1.0, 1.5, 2.5)  # periods


def highest(periods):
    """Largest force of the spring, of the weight."""
    phase = math.pi * periods
    return 1 + (abs(math.sin(phase)) / phase if phase else 1)


def depth(run, degrees):
    """How far block 2 has moved along gravity, of W / k."""
    down = np.array([math.sin(math.radians(degrees)), -math.cos(math.radians(degrees))])
    path = run.of("Centroid", 2)[:, :2]
    return (path - path[0]) @ down / (W / K)


def check(case):
    floor, hanging = case.text("floor.deck"), case.text("hanging.deck")
    chart = Chart("A block on a spring: force of the spring after a ramp of gravity",
                  "duration of the ramp, periods", "largest force / weight")
    every = np.linspace(0, 3, 121)
    chart.expected(every, [highest(n) for n in every], "1 + |sin(pi n)| / (pi n)")
    for kind in ("rigid", "deformable"):
        found = []
        for degrees, shift in FRAMES:
            where = f"{kind}, turned by {degrees}"
            for periods in RAMPS:
                gravity = f"GRAVITY, 0, -10, {periods * PERIOD:.15g}"
                text = floor if kind == "rigid" else with_lines(floor, RIGID="")
                run = case.run("floor", text=turned(with_lines(text, GRAVITY=gravity), degrees, shift))
                ours = depth(run, degrees).max()
                case.equal(f"{where}: largest force, ramp of {periods:g} periods, of the weight",
                           highest(periods), ours, 1e-3,
                           "(omega dt)^2 is 2e-4; the deformable block gives by W / E")
                if degrees == 0:
                    found.append(ours)
            for periods, holds in ((0.0, False), (2.5, True)):
                gravity = f"GRAVITY, 0, -10, {periods * PERIOD:.15g}"
                text = hanging if kind == "rigid" else with_lines(hanging, RIGID="")
                run = case.run("hanging",
                               text=turned(with_lines(text, GRAVITY=gravity), degrees, shift))
                case.same(f"{where}: joint for 1.5 W, ramp of {periods:g} periods",
                          "holds" if holds else "breaks",
                          "holds" if depth(run, degrees)[-1] < 2 else "breaks",
                          "2 W suddenly, 1.13 W after the ramp")
        chart.ours(RAMPS, found, kind)
    case.chart(chart)
