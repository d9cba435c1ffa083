"""Strain is stress over modulus."""

import numpy as np
from suite.chart import Chart

LENGTH = "quick"
E, G, P = 1e10, 4e9, 1e6
NU = E / (2 * G) - 1


def check(case):
    run = case.run("uniaxial.deck")
    t = run.times
    size = np.array([np.ptp(run.outline(1, k), axis=0) for k in range(len(t))])
    strain = size / size[0] - 1
    late = t > 0.2
    plane = E / (1 - NU ** 2)
    because = "what is left of the swing in a mean over 0.1 s; strains are finite (1e-4)"
    case.equal("strain along the load", -P / plane, strain[late, 0].mean(), 1e-3, because)
    case.equal("strain across", NU / (1 - NU) * P / plane, strain[late, 1].mean(), 1e-3, because)
    stress = run.of("Stress", 1)[late].mean(axis=0)
    case.equal("stress along the load", -P, stress[0], 1e-3, because, "Pa")
    case.equal("stress across, of the load", 0, stress[3] / P, 1e-3, because, absolute=True)
    chart = Chart("Uniaxial compression, plane strain", "time, s", "strain")
    chart.ours(t, strain[:, 0], "along the load", line=True)
    chart.ours(t, strain[:, 1], "across", line=True)
    ramp = np.minimum(t / 0.2, 1)
    chart.expected(t, -P / plane * ramp, "p / E'")
    chart.expected(t, NU / (1 - NU) * P / plane * ramp, "")
    case.chart(chart)

    run = case.run("shear.deck")
    angle = []
    for k in np.nonzero(run.times > 0.2)[0]:
        corner = run.outline(1, k)
        flat, upright = corner[2] - corner[0], corner[1] - corner[3]
        angle.append(np.arccos(flat @ upright / np.linalg.norm(flat) / np.linalg.norm(upright)))
    stress = run.of("Stress", 1)[run.times > 0.2].mean(axis=0)
    # Sides 1 and 3 face the upper left and the lower right. Pressure on them gives sigma12 > 0.
    case.equal("pure shear: angle between the diagonals, less than a right angle by", P / G,
               np.pi / 2 - np.mean(angle), 1e-3, because, "rad")
    case.equal("pure shear: sigma12", P, stress[1], 1e-3, because, "Pa")
    case.equal("pure shear: sigma11 of the load", 0, stress[0] / P, 1e-3, because, absolute=True)
