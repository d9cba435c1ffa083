"""Kinetic damping brings blocks to rest where the forces are balanced."""

import math

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
SWINGS = "validation/problems/half_swings/"


def depth(run, degrees):
    up = np.array([-math.sin(math.radians(degrees)), math.cos(math.radians(degrees))])
    path = run.of("Centroid", 2)[:, :2]
    return (path[0] - path) @ up / 1e-3


def stress(run, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    s11, s12, _, s22 = run.of("Stress", 1).T
    along = c * c * s11 + 2 * c * s * s12 + s * s * s22
    across = s * s * s11 - 2 * c * s * s12 + c * c * s22
    return (across - along) / 200


def check(case):
    chart = Chart("A block whose weight begins to act", "time, s", "depth, of that at rest")
    for name, what, coordinate, quarter in (
            ("resting", "rigid block on a floor", depth, math.pi / 200),
            ("strain", "deformable block", stress, math.pi / 800 * 1.4)):
        for degrees, shift in FRAMES:
            deck = with_lines(case.text(SWINGS + name + ".deck"), LOCDAMP="KINDAMP")
            run = case.run(name, text=turned(deck, degrees, shift))
            x = coordinate(run, degrees)
            case.equal(f"{what}, turned by {degrees}: farthest from rest after a quarter period", 0,
                       np.abs(x[run.times > 1.02 * quarter] - 1).max(), 0.015,
                       "the way of two steps, omega dt = 0.006", absolute=True)
            if name == "resting" and degrees == 0:
                chart.ours(run.times, x, "KINDAMP", line=True)
                free = case.run(name, text=with_lines(deck, KINDAMP="KINDAMP, 0"))
                chart.ours(free.times, depth(free, 0), "without damping", line=True)
    for degrees, shift in FRAMES:
        text = with_lines(case.text("decks/stack/stack.deck"), DAMPING="KINDAMP")
        stack = case.run("stack", text=turned(text, degrees, shift))
        up = np.array([-math.sin(math.radians(degrees)), math.cos(math.radians(degrees))])
        path = stack.all("Centroid")[:, 1:7, :2]
        sunk = (path[0] - path[-1]) @ up
        expected = np.cumsum([30, 12.5, 10, 7.5, 5, 2.5]) * 1e3 / 1e8
        for b in (0, 5):
            case.equal(f"stack of six, turned by {degrees}: brick {b + 1} from below has sunk",
                       expected[b], sunk[b], 1e-3, "what is left of the swings", "m")
    case.chart(chart)
