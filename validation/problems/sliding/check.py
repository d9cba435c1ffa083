"""Coulomb on a slope of 40 degrees."""

from math import cos, radians, sin, sqrt, tan

from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.numbers import slope

LENGTH = "quick"
PSI, G = radians(40), 10.0


def check(case):
    deck = case.text("sliding.deck")
    square = deck.replace("0, 5, 5, 0", "0, 10, 10, 0")
    # The block first settles with much friction. Otherwise it slides a little while it settles, and
    # at 40.1 degrees friction takes minutes to stop it.
    run = case.run("square", text=with_lines(
        square, FRICTN="FRICTN, 2",
        MOTION=f"MOTION, 5\nFRICTN, {tan(radians(40.1)):.15g}\nMOTION, 20"))
    x, t = run.of("Centroid", 2)[:, 0], run.times
    case.equal("friction 40.1 degrees: way in the last 5 of 20 s", 0, abs(x[-1] - x[t > 20][0]),
               1e-9, "what is left of the swing on its springs", "m", absolute=True)
    give = 2000 * 100 * G * sin(PSI) / (2 * 1e7)
    case.at_most("friction 40.1 degrees: way in the first 5 s, of the give of the shear springs",
                 1, (x[t > 10][0] - x[t > 5][0]) / give,
                 "the upper corner hands its shear to the lower one, which carries more weight")
    run = case.run("square", text=with_lines(
        square, FRICTN="FRICTN, 2",
        MOTION=f"MOTION, 5\nFRICTN, {tan(radians(39.9)):.15g}\nMOTION, 10"))
    x, t = run.of("Centroid", 2)[:, 0], run.times
    slow = G * (sin(PSI) - tan(radians(39.9)) * cos(PSI))
    case.equal("friction 39.9 degrees: acceleration", slow,
               slope(t[t > 6], run.of("Velocity", 2)[t > 6, 0]), 1e-3,
               "the block still swings on its springs", "m/s2")
    a = G * (sin(PSI) - tan(radians(20)) * cos(PSI))
    for way in (25.0, 250.0):
        time = sqrt(2 * way / a)
        run = case.run("sliding.deck", "--set", f"MOTION.dt={time:.15g}",
                       "--set", "PLOTS.dtplot=0.2")
        t, x = run.times, run.of("Centroid", 2)[:, 0] - 5
        late = t > 1
        case.equal(f"acceleration, run to {way:g} m", a,
                   slope(t[late], run.of("Velocity", 2)[late, 0]), 1e-4,
                   "the block still swings on its springs at 1 s", "m/s2")
        case.equal(f"way after {t[-1]:.3f} s, run to {way:g} m", 0.5 * a * t[-1] * (t[-1] + run.dt),
                   x[-1], 1e-3, "the swing of the normal force while it settles", "m")
    run = case.run("turned", text=turned(with_lines(deck, PLOTS="PLOTS, 0.2"), -40, (1e3, 2e3)))
    v = run.of("Velocity", 2)
    along = v[:, 0] * cos(PSI) - v[:, 1] * sin(PSI)
    late = run.times > 1
    case.equal("acceleration, scene turned by -40 degrees and shifted", a,
               slope(run.times[late], along[late]), 1e-4, "as above", "m/s2")
    boxes = case.run("decks/sliding/sliding.deck")
    late = boxes.times > 0.3
    for block in (2, 3):
        along = boxes.of("Velocity", block)[late, :2] @ [cos(radians(30)), -sin(radians(30))]
        case.equal(f"decks/sliding, 30 degrees, friction 0.3: acceleration of box {block - 1}",
                   10 * (sin(radians(30)) - 0.3 * cos(radians(30))),
                   slope(boxes.times[late], along), 1e-4, "the box swings on its springs", "m/s2")
    chart = Chart("Friction 20 degrees on a slope of 40", "time, s", "way, m")
    chart.expected(t, 0.5 * a * t ** 2, "a t^2 / 2")
    chart.ours(t, x)
    case.chart(chart)
