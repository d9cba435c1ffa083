"""Restitution of contacts without tension, and its convergence."""

import math

import numpy as np
from suite.chart import Chart
from suite.numbers import order

LENGTH = "quick"
KINDS = (("face", "flat", 2, (0.05, 0.2, 0.5)), ("corner", "on a corner", 1, (0.1, 0.3, 0.5)))


def restitution(z):
    q = math.sqrt(1 - z * z)
    return math.exp(-z / q * (math.pi - math.atan2(2 * z * q, 1 - 2 * z * z)))


def rebound(case, deck, *sets):
    options = [word for one in sets for word in ("--set", one)]
    return case.run(f"{deck}.deck", *options).of("Velocity", 2)[-1, 1]


def check(case):
    chart = Chart("Rebound of a square", "DAMPING", "speed after / before")
    for deck, how, n, damping in KINDS:
        zs = [k / 100 for k in range(0, 61)]
        chart.expected(zs, [restitution(b * math.sqrt(n)) for b in zs],
                       f"{how}, expected", None)
        ours = []
        for b in damping:
            ours.append(rebound(case, deck, f"DAMPING.beta={b}"))
            case.equal(f"rebound {how}, DAMPING {b}", restitution(b * math.sqrt(n)), ours[-1],
                       0.002, "first order: FRACTION 0.001, and the moment of first touch "
                       "falls within a step")
        chart.ours(damping, ours, how)
    case.chart(chart)

    # The error depends on where within a step a square first touches, so there are sixteen.
    fractions, exact = (0.08, 0.04, 0.02, 0.01, 0.005), restitution(0.2 * math.sqrt(2))
    errors = []
    for fraction in fractions:
        run = case.run("squares.deck", "--set", f"FRACTION.tfrac={fraction}")
        errors.append(np.sqrt(np.mean((run.all("Velocity")[-1, 1:, 1] - exact) ** 2)))
    case.equal("order of convergence in dt, flat, DAMPING 0.2", 1, order(fractions, errors), 0.1,
               "five steps, and sixteen moments of first touch")
    stiff = [rebound(case, "face", f"STIFF.stifn={k:g}", f"STIFF.stifs={k:g}")
             for k in (1e6, 1e7, 1e8)]
    case.equal("spread of the rebound for stiffness 1e6, 1e7, 1e8", 0, max(stiff) - min(stiff),
               0.001, "the moment of first touch", absolute=True)
    convergence = Chart("Convergence of the rebound, DAMPING 0.2", "FRACTION",
                        "error, root mean square", log="xy")
    convergence.expected(fractions, [errors[0] * f / fractions[0] for f in fractions],
                         "first order")
    convergence.ours(fractions, errors)
    case.chart(convergence)
