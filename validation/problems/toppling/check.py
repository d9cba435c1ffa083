"""Columns that stand and topple; the limit angle by bisection, and its convergence in stiffness."""

from math import atan, cos, degrees, radians, sin

from suite.chart import Chart
from suite.deck import with_lines
from suite.numbers import bisect, order

LENGTH = "long"
G, WEIGHT, WIDTH = 10.0, 2000 * 250 * 10.0, 10.0
LIMIT = degrees(atan(10 / 25))


def gravity(angle):
    return f"GRAVITY, {G * sin(radians(angle)):.15g}, {-G * cos(radians(angle)):.15g}\n"


def topples(case, angle, stiffness):
    way = "".join(gravity(19 + (angle - 19) * k / 100) + "MOTION, 0.3\n" for k in range(1, 101))
    text = with_lines(case.text("column.deck"), STIFF=f"STIFF, {stiffness:g}, {stiffness:g}",
                      PLOTS="PLOTS, 1", GRAVITY=gravity(19).strip(),
                      MOTION="MOTION, 5\n" + way + "MOTION, 20")
    return abs(case.run("column", text=text).of("Angle", 2)[-1]) > 0.3


def check(case):
    run = case.run("column.deck")
    case.at_least("slope of 30 degrees: the column has turned by, after 6 s", 80,
                  -degrees(run.of("Angle", 2)[-1]), "it lies on its side", "degrees")
    deck = case.run("decks/toppling/toppling.deck")
    turn = [abs(degrees(deck.of("Angle", b)[-1])) for b in (2, 3)]
    case.at_most("decks/toppling, b/h = 0.40 on 20 degrees: turned by", 0.2, turn[0],
                 "it stands: only its springs give", "degrees")
    case.equal("decks/toppling, b/h = 0.32: turned by", 90, turn[1], 0.001,
               "it lies on its side, on its springs", "degrees")
    stiff, limits = (1e8, 3e8, 1e9, 1e10), []
    for k in stiff:
        lean = degrees(WEIGHT * cos(radians(LIMIT)) / (k * WIDTH))
        limits.append(limit(case, k))
        case.equal(f"limit angle, stiffness {k:g}: atan(b/h) less the lean", LIMIT - lean,
                   limits[-1], 0.02, "bisection to 0.002; 20 s see growth by e^15",
                   "degrees", absolute=True)
    errors = [LIMIT - one for one in limits]
    case.equal("order of convergence in 1 / stiffness, 1e8 to 1e9", 1,
               order([1 / k for k in stiff[:3]], errors[:3]), 0.05,
               "bisection to 0.002 degrees, of 0.027 at 1e9")
    chart = Chart("Limit angle of a column", "stiffness, N/m per m", "limit angle, degrees",
                  log="x")
    chart.expected([7e7, 1.4e10], [LIMIT, LIMIT], "atan(b / h)")
    fine = [10 ** (7.85 + 0.05 * i) for i in range(47)]
    chart.expected(fine, [LIMIT - degrees(WEIGHT * cos(radians(LIMIT)) / (k * WIDTH))
                          for k in fine], "less the lean of its springs")
    chart.ours(stiff, limits)
    case.chart(chart)


def limit(case, stiffness):
    """Is the column stable below the limit and unstable above?"""
    return bisect(lambda angle: not topples(case, angle, stiffness), 21, 22, 0.002)
