"""Peaks of a damped vibration of a block fall as those of a damped oscillator."""

from math import exp, pi, sqrt

import numpy as np
from suite import cracking
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
E, OMEGA, P = 1e10, 4000.0, 1e4
DAMPING = (0.1, 0.3)


def decay(z):
    """Ratio of two successive peaks with this damping ratio."""
    return exp(-2 * pi * z / sqrt(1 - z * z))


def within(z, dt):
    """Tolerance of a decay. Rates of the step before raise z by z^2 omega dt / 2."""
    return 1e-4 + 2 * pi / (1 - z * z) ** 1.5 * 1.2 * z * z * OMEGA * dt / 2


def along(run, degrees):
    """Stress along the direction that was x before the frame was turned."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    tensor = run.of("Stress", 1)
    return c * c * tensor[:, 0] + 2 * c * s * tensor[:, 1] + s * s * tensor[:, 3]


def peaks(values):
    """Maxima of a curve, by parabolas through three points."""
    a, b, c = values[:-2], values[1:-1], values[2:]
    top = (b > a) & (b >= c)
    return (b - (c - a) ** 2 / (8 * (a - 2 * b + c)))[top]


def ratio(run, degrees):
    """Second peak of the overshoot of the pressure over the first one."""
    first, second = peaks(-along(run, degrees) / P - 1)[:2]
    return second / first


def damped(text, z):
    return with_lines(text, MDAMP=f"MDAMP, 1, {z}")


def on_all_sides(text):
    more = "".join(f"PRESSBC, 1, {side}, 1.E4, 1.E4, 0\n" for side in (2, 4))
    return text.replace("MDAMP", f"{more}MDAMP")


def stretched(text):
    """The deck with a rectangle of 2 m x 1 m."""
    return text.replace("-0.5, -0.5, 0.5, 0.5", "-1, -1, 1, 1")


def check(case):
    text = case.text("square.deck")
    because = "rates of the step before, omega dt = 0.004"
    chart = Chart("Vibration of a square", "time, ms", "stress over pressure, without damping 1")
    for degrees, shift in cracking.FRAMES:
        for name, of in (("square", text), ("rectangle", stretched(text))):
            of = turned(of, degrees, shift)
            for z in DAMPING:
                run = case.run("square", text=damped(of, z))
                where = f"{name}, turned by {degrees}, MDAMP {z}"
                case.equal(f"{where}: next peak", decay(z), ratio(run, degrees),
                           within(z, run.dt), because)
                area = 1 if name == "square" else 2
                case.equal(f"{where}: energy taken", area * P * P / (2 * E),
                           run.history("energy:artificial")[1][-1], 1e-3,
                           "what is left of the swing", "J")
                if degrees == 0 and name == "square":
                    t, d = run.times, OMEGA * sqrt(1 - z * z)
                    swing = np.exp(-z * OMEGA * t) * (np.cos(d * t) +
                                                      z / sqrt(1 - z * z) * np.sin(d * t))
                    early = t < 0.0065
                    chart.expected(1e3 * t[early], 1 - swing[early], "")
                    few = np.nonzero(early)[0][::4]
                    chart.ours(1e3 * t[few], -along(run, 0)[few] / P, f"MDAMP {z}")
        run = case.run("square", text=damped(turned(text, degrees, shift), 0))
        case.equal(f"square, turned by {degrees}, MDAMP 0: next peak", 1, ratio(run, degrees), 1e-4,
                   because)
    for poisson in (0.0, 0.25):
        shear = 0.5 * E / (1 + poisson)
        material = f"MATERIAL, 1, 1.E10, {shear:.15g}, 2500"
        # Equal strains: the stiffness is C11 + C12, and the damping is that of C11.
        z = 0.1 * sqrt(1 - poisson)
        for degrees, shift in cracking.FRAMES:
            run = case.run("square", text=turned(with_lines(on_all_sides(text), MATERIAL=material),
                                                 degrees, shift))
            case.equal(f"pressure on all sides, nu {poisson}, turned by {degrees}: next peak",
                       decay(z), ratio(run, degrees), within(0.1, run.dt), because)
    case.chart(chart)
