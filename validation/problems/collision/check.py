"""Momentum, angular momentum and energy of free blocks."""

import numpy as np
from suite.chart import Chart

LENGTH = "quick"


def check(case):
    run = case.run("pair.deck")
    mass = run.all("Mass")[0].sum()
    energy = run.kinetic_energy()
    touched = max(len(run.contacts(k)["Overlap"]) for k in range(len(run.times)))
    case.at_least("contacts while they touch", 1, touched, "else nothing is tested")
    rounding = "round-off of some thousand steps"
    drift = np.abs(run.momentum() - run.momentum()[0]).max() / (3 * mass)
    case.equal("drift of momentum, of mass x 3 m/s", 0, drift, 1e-13, rounding, absolute=True)
    turn = run.angular_momentum()
    case.equal("drift of angular momentum, of mass x 3 m2/s", 0,
               np.abs(turn - turn[0]).max() / (3 * mass), 1e-12, rounding, absolute=True)
    case.at_most("kinetic energy at the end, of the start", 1, energy[-1] / energy[0],
                 "friction and dashpots only take")
    case.at_most("largest kinetic energy, of the start", 1 + 1e-12, energy.max() / energy[0],
                 "springs give back at most what they took; round-off")
    chart = Chart("Two free blocks collide", "time, s", "of the start")
    chart.ours(run.times, energy / energy[0], "kinetic energy", line=True)
    chart.ours(run.times, turn / turn[0], "angular momentum", line=True)
    case.chart(chart)

    run = case.run("cradle.deck")
    speed = run.all("Velocity")[:, :, 0]
    case.equal("cradle: speed of the last square", 1, speed[-1, 4], 0.005,
               "first order in dt: four collisions", "m/s")
    case.equal("cradle: largest speed left in the others", 0, np.abs(speed[-1, :4]).max(), 0.005,
               "as above", "m/s", absolute=True)
    case.equal("cradle: drift of momentum", 0, np.abs(run.momentum()[:, 0] / run.momentum()[0, 0]
                                                      - 1).max(), 1e-12, rounding, absolute=True)
    case.equal("cradle: energy at the end, of the start", 1,
               run.kinetic_energy()[-1] / run.kinetic_energy()[0], 0.01, "first order in dt")
    chart = Chart("A cradle of five squares", "time, s", "speed, m/s")
    for k in range(5):
        chart.ours(run.times, speed[:, k], f"square {k + 1}", line=True)
    case.chart(chart)
