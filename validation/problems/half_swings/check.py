"""Under local damping, each half swing is smaller than the last one by the same factor."""

import math

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
ALPHAS = (0.2, 0.5, 0.8)
RHO, G = 2000.0, 4e7


def resting(run, degrees):
    """Depth of the block below its start, of that under its weight."""
    up = np.array([-math.sin(math.radians(degrees)), math.cos(math.radians(degrees))])
    path = run.of("Centroid", 2)[:, :2]
    return (path[0] - path) @ up / (RHO * 10 / 2e7)


def turning(run, _):
    return run.of("Angle", 3)


def strain(run, degrees):
    """Shear stress along the sides that are compressed, of the pressure."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    s11, s12, _, s22 = run.of("Stress", 1).T
    along = c * c * s11 + 2 * c * s * s12 + s * s * s22
    across = s * s * s11 - 2 * c * s * s12 + c * c * s22
    return (across - along) / 200


CASES = (  # deck, what, its coordinate, undamped frequency [1/s]
    ("resting", "rigid block on a floor", resting, math.sqrt(2e7 / RHO)),
    ("turning", "rigid block that turns", turning, math.sqrt(4 * 5e6 * 0.5 / (RHO / 6))),
    ("strain", "deformable block", strain, math.sqrt(2 * G / (RHO / 4))))


def turning_points(times, x):
    """Times and values of the extremes. The start is one if the block begins at rest, at 0, and
    does not come back there."""
    turns = np.flatnonzero(np.diff(np.sign(np.diff(x)))) + 1
    if x.min() >= 0:
        turns = np.concatenate(([0], turns))
    return times[turns], x[turns]


def check(case):
    chart = Chart("Depth of a block whose weight begins to act", "time, s", "of the depth at rest")
    for name, what, coordinate, frequency in CASES:
        text = case.text(name + ".deck")
        for degrees, shift in FRAMES:
            for alpha in ALPHAS:
                deck = with_lines(turned(text, degrees, shift), LOCDAMP=f"LOCDAMP, {alpha}")
                run = case.run(name, text=deck)
                x = coordinate(run, degrees)
                times, values = turning_points(run.times, x)
                swings = np.abs(np.diff(values[:3]))  # from one side to the other
                where = f"{what}, alpha {alpha:g}, turned by {degrees}"
                case.equal(f"{where}: ratio of successive half swings",
                           math.sqrt((1 - alpha) / (1 + alpha)),
                           swings[1] / swings[0], 1e-3,
                           "errors of the second order in the phase of a step, 0.006")
                half = math.pi / frequency * \
                    (1 / math.sqrt(1 - alpha) + 1 / math.sqrt(1 + alpha)) / 2
                case.equal(f"{where}: half a period", half,
                           (times[2] - times[0]) / 2, 1e-2,
                           "errors of the order of the phase of a step, 0.006", "s")
                if name == "resting" and degrees == 0:
                    chart.ours(run.times[::4], x[::4], f"alpha = {alpha:g}", line=True)
    case.chart(chart)
