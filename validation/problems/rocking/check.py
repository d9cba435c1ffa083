"""Times between impacts and their loss of spin, against rigid-body theory for any angle."""

from math import acos, acosh, atan, cos, hypot, sin, sqrt

import numpy as np
from suite.chart import Chart
from suite.deck import polygon, rectangle, with_lines
from suite.numbers import first_time, order

LENGTH = "long"
G = 9.81
STIFF = (1e8, 1e9, 1e10)
DEAD = 4.0  # DAMPING of an impact that does not rebound


def rock(case, b, stiffness=1e9, damping=DEAD, time=1.2, fraction=0.00125, tilt=0.5):
    """Runs a column of half sizes b and 1, released at this part of its angle of stability. Returns
    the run and the angles."""
    start = tilt * atan(b)
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
    """Exact time from rest at this angle to 0, by the midpoint rule in x: th = start (1 - x^2)."""
    a, p2 = atan(b), 0.75 * G / hypot(b, 1)
    x = (np.arange(100000) + 0.5) / 100000
    spin = np.sqrt(2 * p2 * (np.cos(a - start) - np.cos(a - start * (1 - x * x))))
    return np.mean(2 * start * x / spin)


def kept(b):
    """Exact spin after / before an impact without slip and rebound."""
    return 1 - 1.5 * sin(atan(b)) ** 2


def ratio(b, angle):
    """The measured ratio, from the largest angles before and after the impact."""
    a = atan(b)
    return sqrt((cos(a + angle.min()) - cos(a)) / (cos(a - angle[0]) - cos(a)))


def times(case):
    """Adds rows and figures of the times. Returns the run of the slender column."""
    a = atan(0.2)
    run, angle = rock(case, 0.2, 1e10, time=1.5)
    first = first_time(run.times, -angle, 0.0)
    later = run.times > first + 0.2
    second = first_time(run.times[later], angle[later], 0.0)
    case.equal("four times the time to the first impact, exact", 4 * quarter(0.2, a / 2), 4 * first,
               2e-4, "frames of 2 ms, straight between them; the column sinks on its corner", "s")
    case.compared("the same, Housner's small angles", 4 / sqrt(0.75 * G / hypot(0.2, 1)) * acosh(2),
                  4 * first, "finite angles make it longer", "s")
    after = a - acos(cos(a) + kept(0.2) ** 2 * (cos(a / 2) - cos(a)))
    case.equal("from the first impact to the second, exact", 2 * quarter(0.2, after), second - first,
               1e-3, "as above; and it leaves with what the impact leaves it", "s")
    chart = Chart("Rocking of a column, b/h = 0.2", "time, s", "angle, degrees")
    p = sqrt(0.75 * G / hypot(0.2, 1))
    t = np.linspace(0, first, 60)
    chart.expected(t, np.degrees(a - a / 2 * np.cosh(p * t)), "Housner, small angles")
    speed = kept(0.2) * p * a / 2 * sqrt(3)  # spin before: p (a/2) sinh(acosh 2)
    t = np.linspace(first, run.times[-1], 60)
    swung = a - a * np.cosh(p * (t - first)) + speed / p * np.sinh(p * (t - first))
    chart.expected(t[swung > 0], -np.degrees(swung[swung > 0]), "")
    chart.ours(run.times[::12], np.degrees(angle[::12]))
    case.chart(chart)
    slender = run

    tilts, ours = np.array([0.1, 0.25, 0.5, 0.75, 0.9]), []
    for tilt in tilts:
        run, angle = rock(case, 0.5, 1e10, time=2.0, tilt=tilt)
        ours.append(4 * first_time(run.times, -angle, 0.0))
        if tilt in (0.25, 0.9):
            case.equal(f"stocky, b/h = 0.5, let go at {tilt} of its angle of stability: four times the "
                       "time to the first impact, exact", 4 * quarter(0.5, tilt * atan(0.5)), ours[-1],
                       5e-4, "frames of 2 ms, straight between them", "s")
    chart = Chart("Time to the first impact over Housner's of small angles, b/h = 0.5",
                  "angle at the start, of that of stability", "ratio")

    def small(tilt):
        return 4 / sqrt(0.75 * G / hypot(0.5, 1)) * np.arccosh(1 / (1 - tilt))

    every = np.linspace(0.05, 0.95, 60)
    chart.expected(every, [4 * quarter(0.5, k * atan(0.5)) / small(k) for k in every], "exact")
    chart.ours(tilts, ours / small(tilts))
    case.chart(chart)
    return slender


def impacts(case):
    """Adds rows and the figure of the loss of spin."""
    chart = Chart("Spin after / before the impact: distance from 1 - 1.5 sin^2 a",
                  "stiffness, N/m per m", "distance", log="xy")
    for b in (0.1, 0.2, 0.25, 0.5):
        ours = np.array([ratio(b, rock(case, b, k)[1]) for k in STIFF])
        off = np.abs(ours - kept(b))
        chart.ours(STIFF, off, f"b/h = {b}")
        case.equal(f"spin after / before the impact, b/h = {b}, K 1e10", kept(b), ours[2], 3e-4,
                   "1e-4 of it is the stiffness, which goes with 1/K; frames of 2 ms")
        if b < 0.5:
            case.equal(f"b/h = {b}: order of convergence in 1/K", 1, order(1 / np.array(STIFF), off),
                       0.06, "three stiffnesses; the next order is small")
            case.equal(f"b/h = {b}: the ratio, K to infinity", kept(b), ours[2] + (ours[2] - ours[1]) / 9,
                       1e-4, "Richardson, of order 1, from K 1e9 and 1e10")
    case.chart(chart)
    first = np.array([ratio(0.2, rock(case, 0.2, fraction=f)[1]) for f in (0.005, 0.0025, 0.00125)])
    case.equal("b/h = 0.2, K 1e9: ratio at FRACTION 0.005, 0.0025 and 0.00125: spread", 0,
               np.ptp(first), 1e-4, "a dashpot this strong wants small steps; stiffness costs 5e-4 here",
               absolute=True)
    for damping in (0.5, 0.9, 2.0):
        case.compared(f"b/h = 0.5, DAMPING {damping}, K 1e10: spin after / before", kept(0.5),
                      ratio(0.5, rock(case, 0.5, 1e10, damping)[1]),
                      "it rebounds: another impact than the one of the answer")


def check(case):
    slender = times(case)
    impacts(case)
    case.picture(slender, "-t", "0,0.3,0.49,0.9", "--columns", 4, "--zoom", "-1.2,1.4,-0.3,2.3")
