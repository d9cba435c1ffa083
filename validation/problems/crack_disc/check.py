"""A disc between two plates splits along its load, although its mean stress has no tension."""

from math import pi

import numpy as np
from suite import cracking
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
STRENGTH, E, STIFFNESS, SPEED, FRAME = 1e6, 1e10, 1e9, 0.01, 0.001
AREA = 16 * 0.25 * np.sin(pi / 16)  # of the polygon
PLATE, DISC = 1, 3


def force_of(run, degrees):
    """Force of the disc on the lower plate over the frames, downwards [N]."""
    x, y = np.cos(np.radians(degrees + 90)), np.sin(np.radians(degrees + 90))
    force = run.of("Force", PLATE)
    return -(force[:, 0] * x + force[:, 1] * y)


def split(case, kind, text, degrees, shift):
    """Returns the run."""
    where = f"{kind}, turned by {degrees}"
    run = case.run("disc", text=turned(text, degrees, shift))
    if not cracking.reached(case, where, run):
        return run
    crack, = run.cracks
    case.same(f"{where}: rule", "point loads", crack["cause"], "the same")
    # A deformable disc is F D / (A E) shorter.
    shorter = 0 if kind == "rigid" else 0.5 * pi * STRENGTH / (AREA * E)
    expected = 0.5 * pi * STRENGTH * (1 - shorter)
    force, before = force_of(run, degrees), run.times < crack["time"] - 1e-9
    last = np.nonzero(before)[0][-3:]
    rate = (force[last[2]] - force[last[0]]) / (run.times[last[2]] - run.times[last[0]])
    reached = force[last[2]] + rate * (crack["time"] - run.times[last[2]])
    case.equal(f"{where}: load when it splits", expected, reached, 1e-3 if shorter else 2e-4,
               "a step; swing of the disc" if shorter else "a step", "N")
    case.equal(f"{where}: length of the cut", 1 - shorter,
               np.linalg.norm(np.subtract(crack["to"], crack["from"])[:2]),
               2e-5 if shorter else 1e-12,
               "swing of the disc" if shorter else "round-off of coordinates up to 200 m", "m")
    case.equal(f"{where}: angle of the cut, off by", 0, cracking.off(crack["angle"], degrees + 90),
               1e-6, "round-off that contacts amplify", "degrees", absolute=True)
    case.equal(f"{where}: areas of the pieces, larger over smaller", 1,
               crack["areas"][0] / crack["areas"][1], 1e-9, "the same")
    return run


def check(case):
    text = case.text("disc.deck")
    chart = Chart("A disc between two plates", "displacement of the upper plate, mm", "load, MN")
    chart.expected([0, 3.6], [pi / 2, pi / 2], "pi D / 2 times 1 MPa")
    for kind, of in (("rigid", text), ("deformable", with_lines(text, RIGID=""))):
        for degrees, shift in cracking.FRAMES:
            run = split(case, kind, of, degrees, shift)
            if degrees == 0:
                until = run.times <= (run.cracks[0]["time"] if run.cracks else np.inf)
                few = np.nonzero(until)[0][::12]
                chart.ours(1e3 * SPEED * run.times[few], force_of(run, degrees)[few] / 1e6, kind)
                shown = run
            without = case.run("disc", text=turned(with_lines(of, CRACK="CRACK, 2, 1.E6, 0.1"),
                                                   degrees, shift))
            case.equal(f"{kind}, turned by {degrees}, no tenp, strength 1 MPa: cracks", 0,
                       len(without.cracks), 0, "the mean stress has no tension", absolute=True)
            case.at_least(f"{kind}, turned by {degrees}, no tenp: load at the end", 1.6e6,
                          force_of(without, degrees)[-1], "it is driven on", "N")
    case.chart(chart)
    case.picture(shown)
