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


def check(case):
    run = case.run("notch.deck")
    t, u = run.times, 1e3 * (run.of("Centroid", 3)[0, 1] - run.of("Centroid", 3)[:, 1])
    force = 1e6 * np.minimum(t, 8 - t) / 4
    most = 1e6 / LOADING * 1e3
    # unloading: stuck until the friction of mu N has turned round, at the force F where
    # F = RETURN u and F = 1e6 - STUCK (most - u)
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
    case.told("the published crack: 36.28, 38.89, 34.42 GN/m", "not posed", "a part of its joint slips "
              "and the rest never does; FRICTN is one number for all contacts")
    chart = Chart("A wedge in a notch under a load cycle", "displacement, mm", "force, kN")
    chart.expected([0, most, turn, 0], [0, 1e3, RETURN * turn / 1e6, 0])
    chart.ours(u[::40], force[::40] / 1e3)
    case.chart(chart)
