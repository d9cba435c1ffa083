"""Critical cohesion of a block on a slope."""

from math import cos, radians, sin, tan

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.numbers import bisect, slope

LENGTH = "long"
PSI, PHI, WEIGHT, BASE, G = radians(40), radians(30), 1.25e6, 10.0, 10.0
CRITICAL = WEIGHT / BASE * (sin(PSI) - cos(PSI) * tan(PHI))
NO_MOTION = 1e-5  # m/s; a block at rest has less than 1e-8 here, a sliding one more than 1e-3


def with_cohesion(text, cohesion):
    """Returns the deck with the second JOINT card changed."""
    head, tail = text.rsplit("25.07E3", 2)[0], text.rsplit("25.07E3", 1)[1]
    return f"{head}{cohesion:.15g}, 0, {tan(PHI):.15g}, {cohesion:.15g}{tail}"


def downhill(case, text, degrees, cohesion):
    """Times and velocities downhill from 0.1 s after the fall of the cohesion on."""
    run = case.run("block", text=turned(with_cohesion(text, cohesion), degrees, SHIFT[degrees]))
    along = run.of("Velocity", 2)[:, :2] @ [cos(radians(degrees)), sin(radians(degrees))]
    late = run.times > 1.08
    return run.times[late], along[late]


def slides(case, text, degrees, cohesion):
    """Whether the block has not stopped and is getting faster."""
    _, v = downhill(case, text, degrees, cohesion)
    return v[-1] > max(v[0], NO_MOTION)


def acceleration(case, text, degrees, cohesion):
    return slope(*downhill(case, text, degrees, cohesion))


SHIFT = {0: (0.0, 0.0), -40: (1e3, 2e3), 115: (-300.0, 50.0)}


def check(case):
    chart = Chart("A block on a slope of 40 degrees, friction 30 degrees", "cohesion, kPa",
                  "acceleration downhill after the fall of the cohesion, m/s2")
    cohesions = np.array([5.0, 10.0, 15.0, 20.0, 24.0])
    chart.expected([5, CRITICAL / 1e3, 30], [BASE * (CRITICAL - 5e3) / (WEIGHT / G), 0, 0],
                   "(T - S) / m")
    for kind in ("rigid", "deformable"):
        text = case.text("block.deck")
        if kind == "deformable":
            text = with_lines(text, RIGID="")
        for degrees in SHIFT:
            width = 1e-3 if kind == "rigid" else 0.2
            ours = bisect(lambda c: slides(case, text, degrees, c), 24e3, 26e3, width)
            case.equal(f"critical cohesion, {kind}, scene turned by {degrees} degrees", CRITICAL,
                       ours, 1e-7 if kind == "rigid" else 1e-4,
                       "bisected to 1 mPa" if kind == "rigid" else
                       "the block still swings as it slides, and its face is 1e-5 longer", "Pa")
        slow = acceleration(case, text, -40, 20e3)
        case.equal(f"acceleration with 20 kPa, {kind}, turned by -40 degrees",
                   BASE * (CRITICAL - 20e3) / (WEIGHT / G), slow, 1e-7 if kind == "rigid" else 2e-4,
                       "round-off" if kind == "rigid" else "the block still swings as it slides",
                       "m/s2")
        chart.ours(cohesions, [acceleration(case, text, 0, 1e3 * c) for c in cohesions], kind)
    case.chart(chart)

    for cohesion, expected in ((23.7e3, "slides"), (23.85e3, "rests")):
        run = case.run("decks/cohesive_slope/cohesive_slope.deck", "--set", "MOTION[2].dt=3",
                       "--set", f"JOINT[3].coh={cohesion}", "--set", f"JOINT[3].cohr={cohesion}")
        speed = np.hypot(*np.moveaxis(run.all("Velocity")[:, :, :2], 2, 0)).max(axis=1)
        case.same(f"decks/cohesive_slope, limit 23.78 kPa, with {cohesion / 1e3:g} kPa", expected,
                  "slides" if speed[-1] > max(speed[run.times > 2.5][0], NO_MOTION) else "rests",
                  "the page of the deck derives the limit")
