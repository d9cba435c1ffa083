"""Transmission of a pulse through one soft joint, by frequency."""

import re
from math import sqrt

import numpy as np
from suite.chart import Chart
from suite.deck import polygon, with_lines

LENGTH = "long"
K, MASS, RATIO = 1e8, 2000.0, 4.0  # number of contacts of a joint relative to the soft one
POINTS, LIGHT, WIDE = 4, 0.01, 0.25  # more points in series: number, relative mass, width


def softer(text):
    """Returns the deck with light pointed blocks in front of the pointed one."""
    away = POINTS * WIDE
    outline = [(x, y) for x, y in ((0, 0.5), (0.05, 1), (WIDE, 1), (WIDE, 0), (0.05, 0))]
    density = LIGHT * 2000 / (WIDE - 0.025)  # Their area is that of the box minus two triangles.
    head, tail = text.split("$ block 101")
    rest, squares = tail.split("CLOOP, 99, 1, 0")
    links = "".join(polygon([(100 + k * WIDE + x, y) for x, y in outline], material=2)
                    for k in range(POINTS))

    def shifted(line):
        return ", ".join(f"{float(word) + away:.15g}" for word in line.split(","))

    lines = rest.splitlines()  # comment, CREATE, its x, its y
    lines[2] = shifted(lines[2])
    squares = squares.splitlines()
    squares[2] = shifted(squares[2])
    text = (head + links + "$ block 101" + "\n".join(lines) + "\nCLOOP, 99, 1, 0" +
            "\n".join(squares) + "\n")
    text = re.sub(r"^SETVEL, 1, 200,", f"SETVEL, 1, {200 + POINTS},", text, flags=re.M)
    text = text.replace("SPLANE, 200.125, 0, 200.125, 1",
                        f"SPLANE, {200.125 + away}, 0, {200.125 + away}, 1")
    return with_lines(text, START=f"START, {200 + POINTS}, 5", MATERIAL="MATERIAL, 1, 1.E9, 4.E8, 2000\n"
                      f"MATERIAL, 2, 1.E9, 4.E8, {density:.15g}")


def transmission(q, springs, masses):
    """|T| of a wave of phase q per block through a joint of springs and masses between two halves of
    the chain, exactly: reflected, the masses, transmitted are the unknowns of the equations of
    motion of both last blocks and the masses."""
    chain = RATIO * K
    count = len(masses)
    w2 = 4 * chain / MASS * np.sin(q / 2) ** 2
    forward = np.exp(1j * q)
    matrix = np.zeros((count + 2, count + 2), complex)
    right = np.zeros(count + 2, complex)
    # incoming: exp(iqn), reflected: r exp(-iqn), n <= 0; transmitted: t exp(iqn), n >= 0
    matrix[0, 0] = -MASS * w2 + chain * (1 - forward) + springs[0]
    right[0] = -(-MASS * w2 + chain * (1 - 1 / forward) + springs[0])
    matrix[0, 1] = -springs[0]
    for j in range(count):
        matrix[j + 1, j] = -springs[j]
        matrix[j + 1, j + 1] = -masses[j] * w2 + springs[j] + springs[j + 1]
        matrix[j + 1, j + 2] = -springs[j + 1]
    right[1] += springs[0]
    matrix[-1, -2] -= springs[-1]
    matrix[-1, -1] += -MASS * w2 + chain * (1 - forward) + springs[-1]
    return abs(np.linalg.solve(matrix, right)[-1])


def passing(case, deck, block=115, text=None):
    """Returns times and velocity after the pulse starts, minus the velocity of a run without the
    pulse, in which the chain still oscillates as a whole."""
    text = text or case.text(deck)
    before, after = text.split("$ a pulse")
    still = before + "$" + "".join(line for line in after.splitlines(True) if "SETVEL" not in line)
    runs = [case.run(deck, text=one) for one in (text, still)]
    late = runs[0].times > 10.0
    v = runs[0].of("Velocity", block)[:, 0] - runs[1].of("Velocity", block)[:, 0]
    return runs[0].times[late] - runs[0].times[late][0], v[late]


def spectrum(t, v, w):
    """Spectrum at the frequencies w over the window, which begins and ends at rest."""
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
    q = 2 * np.arcsin(5 / (RATIO * (POINTS + 1) - 1))  # z w / 2 k = 5
    w = np.array([2 * sqrt(RATIO * K / MASS) * np.sin(q / 2)])
    tl, vl = passing(case, "joint.deck", 115 + POINTS, softer(case.text("joint.deck")))
    weak = (spectrum(tl, vl, w) / spectrum(t, v, w))[0]
    lattice = transmission(q, [K] * (POINTS + 1), [LIGHT * MASS] * POINTS)
    case.equal(f"|T| at z w / k = 10, {POINTS + 1} points in series, chain", lattice, weak, 0.02,
               "a window of 0.36 s, and most of the pulse is turned back")
    case.equal("|T| at z w / k = 10, the same, elastic bar", 1 / sqrt(26), weak, 0.05,
               f"the links' masses and the lattice make it {abs(lattice * sqrt(26) - 1):.1%} "
               f"{'more' if lattice * sqrt(26) > 1 else 'less'}")
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
