"""A block under sudden tension splits when its stress overshoots its strength."""

from math import acos, sin

import numpy as np
from suite import cracking
from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.numbers import bisect

LENGTH = "quick"
STRENGTH, E, DENSITY, OMEGA, P = 1e6, 1e10, 2500.0, 4000.0, 0.6e6
PHASE = acos(1 - STRENGTH / P)
FRAMES = ((0, (0.0, 0.0)), (90, (100.0, 200.0)), (30, (-50.0, 7.0)), (45, (3.0, -2.0)))


def under(text, pressure):
    """The deck with another tension."""
    for side in (1, 3):
        text = text.replace(f"PRESSBC, 1, {side}, -0.6E6, -0.6E6",
                            f"PRESSBC, 1, {side}, {-pressure:.15g}, {-pressure:.15g}")
    return text


def energies():
    """The kinetic energy before and after it splits, of the strain rate along the pull."""
    rate = P * OMEGA * sin(PHASE) / E
    # The halves fly apart at rate / 4 and keep the rate. They are as long as they were wide.
    return DENSITY * rate ** 2 / 8, DENSITY * rate ** 2 / 16


def overshoot(case, text, degrees, shift):
    """Returns the run under 0.6 MPa."""
    where = f"turned by {degrees}"
    run = case.run("square", text=turned(text, degrees, shift))
    if not cracking.reached(case, where, run):
        return run
    crack, = run.cracks
    expected = PHASE / OMEGA
    case.equal(f"{where}: time", 1e3 * expected, 1e3 * crack["time"],
               1e3 * run.dt + 1e-4 * 1e3 * expected, "a step; strain of 1e-4", "ms", absolute=True)
    case.equal(f"{where}: angle of the cut, off by", 0, cracking.off(crack["angle"], degrees + 90),
               1e-11, "round-off of coordinates up to 200 m", "degrees", absolute=True)
    before, after = energies()
    because = "a step; strain of 1e-4"
    case.equal(f"{where}: kinetic energy before", before, crack["kinetic"][0], 1e-3, because, "J")
    case.equal(f"{where}: kinetic energy of the halves", after, crack["kinetic"][1], 1e-3, because,
               "J")
    case.equal(f"{where}: strain energy before", 50, crack["strain"][0], 1e-3, because, "J")
    case.equal(f"{where}: energy released", 50 + before - after, crack["released"], 1e-3, because,
               "J")
    return run


def slower(text):
    """The deck with dt = 1e-6 for twelve periods and more."""
    return with_lines(text, FRACTION="FRACTION, 5.7735026919E-4", PLOTS="PLOTS, 0.01",
                      MOTION="MOTION, 0.03")


def check(case):
    text = case.text("square.deck")
    runs = [overshoot(case, text, degrees, shift) for degrees, shift in FRAMES]
    for degrees, shift in FRAMES:
        longer = turned(slower(text), degrees, shift)
        least = bisect(lambda p, of=longer: not case.run("square", text=under(of, p)).cracks,
                       0.49e6, 0.51e6, 20)
        case.equal(f"turned by {degrees}: least sudden tension that splits it", 0.5e6, least, 2e-4,
                   "strain of 1e-4", "Pa")
    for degrees, shift in FRAMES:
        rigid = turned(with_lines(slower(text), MATERIAL="MATERIAL, 1, 1.E10, 5.E9, 2500\nRIGID"),
                       degrees, shift)
        below, above = (case.run("square", text=under(rigid, p)) for p in (0.99999e6, 1.00001e6))
        case.equal(f"rigid, turned by {degrees}: cracks under 0.99999 MPa", 0, len(below.cracks), 0,
                   "a rigid block has no overshoot", absolute=True)
        case.same(f"rigid, turned by {degrees}: steps until it splits under 1.00001 MPa", "1",
                  ", ".join(str(crack["step"]) for crack in above.cracks), "the same")
    chart = Chart("Sudden tension", "time, ms", "stress along the pull, MPa")
    t = np.linspace(0, PHASE / OMEGA, 200)
    chart.expected(1e3 * t, P / 1e6 * (1 - np.cos(OMEGA * t)), "p (1 - cos 4000 t)")
    t = np.linspace(0, 0.0009, 200)
    chart.expected(1e3 * t, 0.4999 * (1 - np.cos(OMEGA * t)), "")
    chart.ours(1e3 * runs[0].times, runs[0].of("Stress", 1)[:, 0] / 1e6, "0.6 MPa")
    run = case.run("square", text=under(text, 0.4999e6))
    chart.ours(1e3 * run.times, run.of("Stress", 1)[:, 0] / 1e6, "0.4999 MPa")
    case.chart(chart)
