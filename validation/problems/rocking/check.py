"""Time to the first impact and loss of spin in it."""

from math import acosh, atan, cos, hypot, sin, sqrt

import numpy as np
from suite.chart import Chart
from suite.deck import polygon, rectangle, with_lines
from suite.numbers import first_time

LENGTH = "long"
G = 9.81


def rock(case, b, stiffness=1e9, damping=0.9, time=1.2, fraction=0.01):
    """Times and angles of a column of half sizes b and 1."""
    start = atan(b) / 2
    c, s = cos(start), sin(start)
    text = case.text("rocking.deck")
    first, last = text.index("CREATE"), text.index("GRAVITY")
    corners = [(c * x - s * y, s * x + c * y) for x, y in ((0, 0), (0, 2), (2 * b, 2), (2 * b, 0))]
    text = text[:first] + rectangle(-5, -1, 5, 0, True) + polygon(corners) + text[last:]
    run = case.run("rocking", text=with_lines(
        text, STIFF=f"STIFF, {stiffness:g}, {stiffness:g}", DAMPING=f"DAMPING, {damping}",
        FRACTION=f"FRACTION, {fraction}", MOTION=f"MOTION, {time}"))
    return run, run.of("Angle", 2) + start


def quarter(b, start):
    """Time from th0 to 0 about the corner, by the middle rule in x: th = th0 (1 - x^2)."""
    a, p2 = atan(b), 0.75 * G / hypot(b, 1)
    x = (np.arange(100000) + 0.5) / 100000
    spin = np.sqrt(2 * p2 * (np.cos(a - start) - np.cos(a - start * (1 - x * x))))
    return np.mean(2 * start * x / spin)


def ratio(b, angle):
    a = atan(b)
    return sqrt((cos(a + angle.min()) - cos(a)) / (cos(a - angle[0]) - cos(a)))


def check(case):
    a = atan(0.2)
    p = sqrt(0.75 * G / hypot(0.2, 1))
    run, angle = rock(case, 0.2)
    first = first_time(run.times, -angle, 0.0)
    case.equal("four times the time to the first impact, finite angles", 4 * quarter(0.2, a / 2),
               4 * first, 1e-3, "the column sinks on its corner by 2e-5 m at the start", "s")
    linear = 4 / p * acosh(2)
    case.equal("the same, small angles", linear, 4 * first, 2e-3,
               f"finite angles make it {4 * quarter(0.2, a / 2) / linear - 1:.2%} longer", "s")
    for b in (0.1, 0.2, 0.25, 0.5):
        case.equal(f"spin after / before the impact, b/h = {b}", 1 - 1.5 * sin(atan(b)) ** 2,
                   ratio(b, rock(case, b, time=1.4)[1]), 0.01,
                   "an impact on springs takes time, and rebounds a little")
    chart = Chart("Rocking of a column, b/h = 0.2", "time, s", "angle, degrees")
    t = np.linspace(0, first, 60)
    chart.expected(t, np.degrees(a - a / 2 * np.cosh(p * t)), "Housner, small angles")
    speed = (1 - 1.5 * sin(a) ** 2) * p * a / 2 * sqrt(3)  # spin before: p (a/2) sinh(acosh 2)
    t = np.linspace(first, run.times[-1], 60)
    after = a - a * np.cosh(p * (t - first)) + speed / p * np.sinh(p * (t - first))
    chart.expected(t, -np.degrees(after), "")
    chart.ours(run.times[::12], np.degrees(angle[::12]))
    case.chart(chart)
    stiff = (1e7, 1e8, 1e9)
    errors = [abs(ratio(0.2, rock(case, 0.2, k)[1]) - (1 - 1.5 * sin(a) ** 2)) for k in stiff]
    case.at_most("error of the ratio, stiffness 1e9 over 1e7", 0.2, errors[2] / errors[0],
                 "it has to fall with stiffness")
    exact = ratio(0.2, angle)
    coarse = ratio(0.2, rock(case, 0.2, fraction=0.016)[1])
    fine = ratio(0.2, rock(case, 0.2, fraction=0.005)[1])
    case.equal("ratio at FRACTION 0.016, 0.01 and 0.005: spread", 0,
               max(coarse, exact, fine) - min(coarse, exact, fine), 1e-3,
               "the time step is not what limits the accuracy", absolute=True)
    chart = Chart("Spin ratio, b/h = 0.2", "stiffness, N/m per m", "error of the ratio", log="xy")
    chart.ours(stiff, errors, "DAMPING 0.9")
    chart.ours(stiff, [abs(ratio(0.2, rock(case, 0.2, k, 0.5)[1]) - (1 - 1.5 * sin(a) ** 2))
                       for k in stiff], "DAMPING 0.5")
    case.chart(chart)
    case.picture(run, "-t", "0,0.3,0.49,0.9", "--columns", 4, "--zoom", "-1.2,1.4,-0.3,2.3")
