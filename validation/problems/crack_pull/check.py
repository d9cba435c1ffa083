"""A block under slow tension splits at its strength, at right angles to the pull."""

from math import sqrt

import numpy as np
from suite import cracking
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
STRENGTH, E = 1e6, 1e10
SLOPE, FAST = 1e6, 1e8  # of the tension of deformable and rigid blocks [Pa/s]
FRAMES = ((0, (0.0, 0.0)), (90, (3.0, -2.0)), (30, (-2.0, 1.0)), (-100, (0.0, 4.0)))
# The largest principal stress of the octagon under P and sqrt(3) P, in units of P.
OCTAGON = (3 + sqrt(3)) / 4


def check_angle(case, where, crack, degrees, within=1e-12, because="round-off"):
    case.equal(f"{where}: angle of the cut, off by", 0, cracking.off(crack["angle"], degrees),
               within, because, "degrees", absolute=True)


def check_pieces(case, where, crack, area, within, because):
    for name, found in zip(("the block", "the new piece"), crack["areas"]):
        case.equal(f"{where}: area of {name}", area, found, within, because, "m2")


def check_square(case, kind, text, degrees, shift):
    """Returns the run."""
    where = f"{kind} square, turned by {degrees}"
    run = case.run("square", text=turned(text, degrees, shift))
    if not cracking.reached(case, where, run):
        return run
    crack, = run.cracks
    rigid = kind == "rigid"
    slope = FAST if rigid else SLOPE
    swing = 0 if rigid else SLOPE / 4000
    case.equal(f"{where}: tension when it splits", STRENGTH, slope * (crack["time"] - run.dt),
               (swing + slope * run.dt) / STRENGTH + (0 if rigid else 2 * STRENGTH / E),
               "a step" if rigid else "the swing left by the slow load; finite strain", "Pa")
    if rigid:
        check_angle(case, where, crack, degrees + 90)
        check_pieces(case, where, crack, 0.5, 1e-14, "round-off")
    else:
        check_angle(case, where, crack, degrees + 90, 1e-8, "round-off of thousands of steps")
        check_pieces(case, where, crack, 0.5 * (1 + STRENGTH / E), 1e-7, "the swing and the step")
    if not rigid:
        case.equal(f"{where}: energy released", 50, crack["released"], 1e-4,
                   "stress rises from step to step; finite strain", "J")
        case.equal(f"{where}: strain energy left", 0, crack["strain"][1], 1e-12,
                   "the cut is free of tension", "J", absolute=True)
    momentum = np.abs(run.momentum()[-1]).max()
    case.equal(f"{where}: momentum at the end", 0, momentum, 1e-7,
               "round-off of the loads, 1 MN for a second", "N s", absolute=True)
    return run


def check_octagon(case, text, degrees, shift):
    where = f"octagon, turned by {degrees}"
    run = case.run("octagon", text=turned(text, degrees, shift))
    if not cracking.reached(case, where, run):
        return
    crack, = run.cracks
    case.equal(f"{where}: P when it splits", STRENGTH / OCTAGON, FAST * (crack["time"] - run.dt),
               1.01 * FAST * run.dt * OCTAGON / STRENGTH, "a step", "Pa")
    check_angle(case, where, crack, degrees + 120)
    check_pieces(case, where, crack, sqrt(2) - 1, 1e-13, "round-off")


def check(case):
    square, octagon = case.text("square.deck"), case.text("octagon.deck")
    rigid = with_lines(square, MATERIAL="MATERIAL, 1, 1.E10, 5.E9, 2500\nRIGID",
                       FRACTION="FRACTION, 0.0002", MOTION="MOTION, 0.01002")
    rigid = rigid.replace("\n2, 2\n", "\n0.02, 2\n")
    for degrees, shift in FRAMES:
        run = check_square(case, "deformable", square, degrees, shift)
        check_square(case, "rigid", rigid, degrees, shift)
        check_octagon(case, octagon, degrees, shift)
        if degrees == 30:
            shown = run
    chart = Chart("A square pulled at 30 degrees", "time, s", "stress along the pull, MPa")
    tensor = shown.of("Stress", 1)
    c, s = np.cos(np.radians(30)), np.sin(np.radians(30))
    along = c * c * tensor[:, 0] + 2 * c * s * tensor[:, 1] + s * s * tensor[:, 3]
    chart.expected([0, 1, 1], [0, 1, 0], "tension until it splits")
    chart.ours(shown.times, along / 1e6)
    case.chart(chart)
