"""Transmission of a pulse through one soft joint, by frequency."""

from math import sqrt

import numpy as np
from suite.chart import Chart

LENGTH = "long"
K, MASS, RATIO = 1e8, 2000.0, 4.0  # contacts of a joint over those of the soft one


def passing(case, deck, block=115):
    """Times and velocity after the pulse was given, less those of a run without the pulse, in which
    the chain still swings as a whole."""
    text = case.text(deck)
    before, after = text.split("$ a pulse")
    still = before + "$" + "".join(line for line in after.splitlines(True) if "SETVEL" not in line)
    runs = [case.run(deck, text=one) for one in (text, still)]
    late = runs[0].times > 10.0
    v = runs[0].of("Velocity", block)[:, 0] - runs[1].of("Velocity", block)[:, 0]
    return runs[0].times[late] - runs[0].times[late][0], v[late]


def spectrum(t, v, w):
    """Of frequencies w, over the window; it begins and ends with rest."""
    window = t < 0.36
    return np.abs(np.exp(-1j * np.outer(w, t[window])) @ v[window])


def check(case):
    t, v = passing(case, "reference.deck")
    ts, vs = passing(case, "joint.deck")
    ratios = np.array([0.5, 1.0, 2.0, 3.0])  # z w / k
    every = np.linspace(0.1, 5, 76)

    def transmitted(zwk):
        q = 2 * np.arcsin(zwk / 2 / (RATIO - 1))
        w = 2 * sqrt(RATIO * K / MASS) * np.sin(q / 2)
        return (spectrum(ts, vs, w) / spectrum(t, v, w),
                1 / np.sqrt(1 + ((RATIO - 1) * np.tan(q / 2)) ** 2))

    ours, lattice = transmitted(ratios)
    for zwk, a, b in zip(ratios, lattice, ours):
        case.equal(f"|T| at z w / k = {zwk:g}, chain", a, b, 0.01,
                   "a window of 0.36 s")
    for zwk, b in zip(ratios[:3], ours):
        case.equal(f"|T| at z w / k = {zwk:g}, elastic bar", 1 / sqrt(1 + (zwk / 2) ** 2), b, 0.05,
                   "chain against bar: tan(q/2) for sin(q/2), 3 % of T at z w / k = 2")
    case.told("|T| at z w / k = 10, elastic bar: 0.196", "not posed", "this chain carries no waves "
              f"beyond z w / k = {2 * (RATIO - 1):.3g}; a softer joint, of several points in series, could")
    chart = Chart("A wave across one joint", "z w / k", "|T|")
    ours, lattice = transmitted(every)
    chart.expected(every, lattice, "chain")
    chart.expected(every, 1 / np.sqrt(1 + (every / 2) ** 2), "elastic bar", "#bbbbbb")
    chart.ours(every[::3], ours[::3])
    case.chart(chart)
    chart = Chart("What passes block 115", "time after the pulse was given, s", "velocity, mm/s")
    chart.ours(t, 1e3 * v, "all joints alike", line=True)
    chart.ours(ts, 1e3 * vs, "soft joint before it", line=True)
    case.chart(chart)
