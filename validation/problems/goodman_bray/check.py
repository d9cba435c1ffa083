"""Limit friction angle of the slope by bisection, and the forces between its columns."""

from math import cos, radians, sin, tan

import numpy as np
from suite.chart import Chart
from suite.deck import with_lines
from suite.numbers import bisect

LENGTH = "medium"
WIDTH, UNIT, STEP, DIP = 10.0, 25.0, 5.0, radians(30)
HEIGHT = {n: 4.0 * n if n <= 10 else 40.0 - 6 * (n - 10) for n in range(1, 17)}


def equilibrium(phi):
    """Forces P_(n-1) below columns 16 ... 1, and how each column gives way."""
    force, mode, above = {}, {}, 0.0
    for n in range(16, 0, -1):
        y, weight = HEIGHT[n], HEIGHT[n] * WIDTH * UNIT
        m, low = (y, y - STEP) if n < 10 else (y - STEP, y - STEP) if n == 10 else (y - STEP, y)
        t = tan(radians(phi))
        topple = slide = -1.0
        if low > 0:
            topple = (above * (m - WIDTH * t) +
                      weight / 2 * (y * sin(DIP) - WIDTH * cos(DIP))) / low
        slide = above - weight * (cos(DIP) * t - sin(DIP)) / (1 - t * t)
        # the lowest column lacks the lever L, so it slides; the others do what needs more support
        below = max(topple, slide) if n > 1 else slide
        mode[n] = "stands" if below <= 0 and n > 1 else "topples" if topple > slide else "slides"
        above = force[n] = below if n == 1 else max(below, 0.0)
    return force, mode


def check(case):
    deck = case.text("goodman_bray.deck")

    def run(phi, **lines):
        return case.run("goodman_bray", text=with_lines(deck.replace(
            "FRICTN, 0.8", f"FRICTN, {tan(radians(phi)):.15g}"), **lines))

    def fails(phi):
        x = run(phi).all("Centroid")
        return np.linalg.norm(x[-1] - x[16], axis=1).max() > 1.0

    expected = bisect(lambda phi: equilibrium(phi)[0][1] > 0, 35, 42, 1e-4)
    case.equal("limit friction angle of the recursion, against the published one", 38.15, expected,
               0.01, "published to two digits", "degrees", absolute=True)
    ours = bisect(fails, 37, 39, 0.02)
    case.equal("limit friction angle, bisection", expected, ours, 0.2,
               "limit equilibrium has each column at its limit at once; ours are on springs that "
               "settled before", "degrees", absolute=True)
    def between(run, frame):
        contacts = run.contacts(frame)
        pair = np.sort([contacts["CornerBlock"], contacts["EdgeBlock"]], axis=0)
        return {n: contacts["NormalForce"][(pair[0] == n - 1) & (pair[1] == n)].sum()
                for n in range(2, 14)}

    force, mode = equilibrium(expected)
    yields = run(ours - 0.02, PLOTS="PLOTS, 0.05")
    turn = yields.of("Angle", 13)
    settled = np.searchsorted(yields.times, 8.0)
    normal = between(yields, np.argmax(turn - turn[settled] > 0.004))
    for n in (13, 10, 7, 4, 2):
        case.equal(f"force between columns {n} and {n - 1} as the slope gives way", force[n],
                   normal[n], 0.05, "the columns move already, column 13 has turned by 0.004 rad",
                   "kN/m")
    held = between(run(ours + 0.02), -1)
    case.told("the same forces while it still holds, of the expected", " ".join(
        f"{held[n] / force[n]:.2f}" for n in (13, 10, 7, 4, 2)),
        "not at the limit everywhere: they depend on how the columns settled")
    failed = run(ours - 1)
    turn = failed.of("Angle", 13)[-1], failed.of("Angle", 14)[-1]
    case.at_least("1 degree below the limit: column 13 has turned by", 0.05, turn[0],
                  f"the recursion says column 13 {mode[13]}", "rad")
    case.at_most("1 degree below the limit: column 14 has turned by", 0.01, turn[1],
                 f"the recursion says column 14 {mode[14]}", "rad")
    numbers = list(range(2, 14))
    chart = Chart("Forces between columns at the limit", "column n", "force on column n - 1, kN/m")
    chart.expected(numbers, [force[n] for n in numbers], "limit equilibrium")
    chart.ours(numbers, [normal[n] for n in numbers], "ours, as the slope gives way")
    case.chart(chart)
    case.picture(failed, "-t", "8,12,14,17", "--columns", 2, "--zoom", "-60,165,-25,65")
