"""Limit friction angle of the slope by bisection, and the forces between its columns."""

from math import radians, tan

import numpy as np
from suite.chart import Chart
from suite.deck import with_lines
from suite.numbers import bisect
from suite.toppling import between, equilibrium

LENGTH = "long"
PUBLISHED = (292.5, 825.7, 1556.0, 2826.7, 3922.1, 4594.8, 4837.0, 4637.4, 3978.0, 2825.5, 1413.3,
             471.9)  # at 38.15 degrees, between columns 13 and 12 ... 2 and 1, kN/m


def slips(run, frame, friction):
    """Is friction between all columns fully mobilised, to 1/1000?"""
    contacts = run.contacts(frame)
    free = np.maximum(contacts["CornerBlock"], contacts["EdgeBlock"]) <= 13
    return np.all(np.abs(contacts["ShearForce"][free]) >=
                  0.999 * friction * contacts["NormalForce"][free])


def at_no_rotation(run, turn, low, high):
    """Extrapolates the forces to no rotation by a line through those at rotations low to high."""
    frames = np.nonzero((turn >= low) & (turn <= high))[0]
    forces = [between(run, k) for k in frames]
    return {n: np.polyfit(turn[frames], [one[n] for one in forces], 1)[1] for n in range(2, 14)}


def observed(run):
    """Returns how each column fails when column 13 has turned by 0.02 rad."""
    start = np.searchsorted(run.times, 8.0)
    turn = np.abs(run.all("Angle") - run.all("Angle")[start])
    now = np.argmax(turn[:, 12] > 0.02)
    way = np.linalg.norm(run.all("Centroid")[now] - run.all("Centroid")[start], axis=1)

    def mode(n):
        if turn[now, n - 1] > 0.01:
            return "topples"
        return "slides" if way[n - 1] > 0.05 else "stands" if way[n - 1] < 0.005 else "creeps"
    return {n: mode(n) for n in range(1, 17)}


def classes(mode):
    """Returns one letter per column from the toe: s slides, t topples, - is stable."""
    short = {"slides": "s", "topples": "t", "stands": "-", "creeps": "?"}
    return " ".join(f"{short[mode[n]]}{n}" for n in range(1, 17))


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
    there = equilibrium(38.15)[0]
    case.equal("forces of the recursion at 38.15 degrees, against the twelve published, largest error",
               0, max(abs(there[n] - f) for n, f in zip(range(13, 1, -1), PUBLISHED)), 0.1,
               "published to one digit", "kN/m", absolute=True)
    ours = bisect(fails, 37, 39, 0.02)
    case.equal("limit friction angle, bisection", expected, ours, 0.2,
               "limit equilibrium has each column at its limit at once; ours are on springs that "
               "settled before", "degrees", absolute=True)

    force, mode = equilibrium(expected)
    columns = range(2, 14)
    yields = run(ours - 0.02, PLOTS="PLOTS, 0.05")
    turn = yields.of("Angle", 13) - yields.of("Angle", 13)[np.searchsorted(yields.times, 8.0)]
    friction = tan(radians(ours - 0.02))
    begun = np.searchsorted(turn, 0.001)
    low = next(turn[k] for k in range(begun, len(turn)) if slips(yields, k, friction))
    at_rest = at_no_rotation(yields, turn, low, low + 0.012)
    for n in reversed(columns):
        case.equal(f"force between columns {n} and {n - 1}", force[n], at_rest[n], 0.01,
                   f"a line through forces while column 13 turns by 0.012 rad from {low:.3f} rad on",
                   "kN/m")
    later = at_no_rotation(yields, turn, low + 0.004, low + 0.016)
    case.at_most("largest change of these forces if the line is taken 0.004 rad later",
                 0.02, max(abs(later[n] / at_rest[n] - 1) for n in columns),
                 "the answer must not hang on the moment of comparison")
    for moment in (0.001, 0.004, 0.016):
        now = between(yields, np.argmax(turn > moment))
        case.measured(f"the same forces at the moment of {moment} rad, of the expected, column 13 to 2",
                  " ".join(f"{now[n] / force[n]:.2f}" for n in reversed(columns)),
                  "first friction comes into play everywhere, then the slope changes its shape")
    held = between(run(ours + 0.02), -1)
    case.measured("the same forces while it still holds", " ".join(
        f"{held[n] / force[n]:.2f}" for n in reversed(columns)),
        "not at the limit everywhere: they depend on how the columns settled")

    failed = run(ours - 1, PLOTS="PLOTS, 0.1")
    case.same("how the columns give way, 1 degree below the limit", classes(mode),
              classes(observed(failed)), "when column 13 has turned by 0.02 rad")
    chart = Chart("Forces between columns at the limit", "column n", "force on column n - 1, kN/m")
    chart.expected(columns, [force[n] for n in columns], "limit equilibrium")
    chart.ours(columns, [at_rest[n] for n in columns], "ours, led back to no rotation")
    case.chart(chart)
    chart = Chart("Force between columns as the slope gives way", "rotation of column 13, rad",
                  "force, of the expected")
    frames = [k for k in np.nonzero((turn > 0.0005) & (turn < 0.03))[0]]
    for n in (13, 10, 4):
        chart.ours(turn[frames], [between(yields, k)[n] / force[n] for k in frames],
                   f"columns {n} and {n - 1}", line=True)
    chart.expected([0, 0.03], [1, 1], "limit equilibrium")
    case.chart(chart)
    case.picture(failed, "-t", "8,10,12,14", "--columns", 2, "--zoom", "-60,165,-25,65")
