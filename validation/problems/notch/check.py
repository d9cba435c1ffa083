"""Stiffness of the three branches of a load cycle."""

from math import cos, radians, sin

import numpy as np
from suite.chart import Chart
from suite.numbers import slope

LENGTH = "long"
K, MU, TH = 1e8, 0.3, radians(30)
LOADING = 4 * K * sin(TH) * (sin(TH) + MU * cos(TH))
STUCK = 4 * K
RETURN = 4 * K * sin(TH) * (sin(TH) - MU * cos(TH))


# A joint that slips in part: contacts on treads, and on facets at 45 degrees.
TREADS, FACETS, FRICTION = 20, 12, 0.28674538575
# The published crack: GPa, m, GPa/m.
HEIGHT, WIDTH, MODULUS, JOINT, LENGTH_OF_JOINT = 2, 1, 88.9, 220, 2 ** 0.5


def part_slips(mu):
    """Stiffness in N/m: the block moves sideways by r of its displacement, against the treads."""
    r = FACETS * (1 - mu) / (2 * TREADS)
    return K * (TREADS + FACETS * (1 + mu) / (2 * (1 + r)))


def crack(case):
    run = case.run("crack.deck")
    t, u = run.times, run.of("Centroid", 1)[0, 1] - run.of("Centroid", 1)[:, 1]
    force = 1e6 * np.minimum(t, 4 - t) / 2
    whole = K * (TREADS + FACETS)
    slopes = {}
    for name, expected, first, last in (("unloading, stuck", whole, 2.45, 2.8),
                                        ("loading, slip", part_slips(FRICTION), 0.2, 1.95),
                                        ("unloading, slip", part_slips(-FRICTION), 3.1, 3.6)):
        part = (t > first) & (t < last)
        slopes[name] = slope(u[part], force[part])
        case.equal(f"a part slips: {name}", expected, slopes[name], 1e-4,
                   "swings of the block on its springs", "N/m")
    for (name, found), published in zip(slopes.items(), (38.89, 36.28, 34.42)):
        joint = JOINT * LENGTH_OF_JOINT * found / whole
        case.equal(f"the published crack: {name}", published,
                   1 / (HEIGHT / (WIDTH * MODULUS) + 1 / joint), 0.01,
                   "12 of 32 contacts slip, 0.375, there 0.382 of the length", "GN/m")


def check(case):
    run = case.run("notch.deck")
    t, u = run.times, 1e3 * (run.of("Centroid", 3)[0, 1] - run.of("Centroid", 3)[:, 1])
    force = 1e6 * np.minimum(t, 8 - t) / 4
    most = 1e6 / LOADING * 1e3
    # On unloading it sticks until the friction mu N is reversed, at the force F where
    # F = RETURN u and F = 1e6 - STUCK (most - u).
    turn = (STUCK * most / 1e3 - 1e6) / (STUCK - RETURN) * 1e3
    because = "swings of the wedge on its springs"
    up = (t > 0.4) & (t < 3.8)
    case.equal("loading, slip", LOADING, 1e3 * slope(u[up], force[up]), 1e-3, because, "N/m")
    back = (t > 4) & (u < most - 0.1 * (most - turn)) & (u > turn + 0.1 * (most - turn))
    case.equal("unloading, stuck", STUCK, 1e3 * slope(u[back], force[back]), 5e-3,
               because, "N/m")
    down = (t > 4) & (u < turn - 0.05 * most) & (u > 0.1 * most)
    case.equal("unloading, slip", RETURN, 1e3 * slope(u[down], force[down]), 1e-3, because, "N/m")
    case.equal("largest displacement", most, u.max(), 1e-3, because, "mm")
    crack(case)
    chart = Chart("A wedge in a notch under a load cycle", "displacement, mm", "force, kN")
    chart.expected([0, most, turn, 0], [0, 1e3, RETURN * turn / 1e6, 0])
    chart.ours(u[::40], force[::40] / 1e3)
    case.chart(chart)
