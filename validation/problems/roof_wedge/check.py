"""Limit friction of a wedge under thrust."""

from math import atan, degrees, radians, tan

import numpy as np
from suite.numbers import bisect

LENGTH = "long"
ALPHA, THRUST = 20.0, 2e5


def check(case):
    deck = case.text("roof_wedge.deck")

    def run(angle):
        return case.run("roof_wedge", text=deck.replace(
            "FRICTN, 0.6", f"FRICTN, {tan(radians(angle)):.15g}"))

    def falls(angle):
        fell = run(angle).of("Centroid", 3)[:, 1]
        return fell[0] - fell[-1] > 0.05

    held = run(45)
    weight = held.all("Mass")[0][2] * 10
    limit = ALPHA + degrees(atan(weight / (2 * THRUST)))
    contacts = held.contacts(-1)
    on_wedge = (contacts["CornerBlock"] == 3) | (contacts["EdgeBlock"] == 3)
    normal = contacts["NormalForce"][on_wedge].sum()
    shear = np.abs(contacts["ShearForce"][on_wedge]).sum()
    case.equal("friction that is used while it holds", limit, degrees(atan(shear / normal)), 1e-4,
               "faces turn by their overlaps, 1e-4 m on 2 m", "degrees")
    case.equal("limit friction angle", limit, bisect(falls, limit - 2, limit + 2, 0.004), 0.01,
               "bisection to 0.004; seen is a fall of 0.05 m in 8 s", "degrees", absolute=True)
    case.picture(run(limit - 1), "-t", "2,4,6", "--columns", 3, "--zoom", "-5,5,-0.5,5",
                 "--original")
