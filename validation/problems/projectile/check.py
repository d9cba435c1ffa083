"""The exact sum of the integrator, and its distance from the parabola."""

import numpy as np
from suite.chart import Chart
from suite.numbers import order

LENGTH = "quick"
G, VX, VY = -9.81, 5.0, 10.0


def check(case):
    steps, deviations = [], []
    for fraction in (0.08, 0.04, 0.02, 0.01):
        run = case.run("projectile.deck", "--set", f"FRACTION.tfrac={fraction}")
        t, x = run.times, run.of("Centroid", 1)
        steps.append(run.dt)
        deviations.append(x[-1, 1] - (0.5 + VY * t[-1] + 0.5 * G * t[-1] ** 2))
        if fraction == 0.02:
            shown, n = run, np.round(t / run.dt)
    t, x = shown.times, shown.of("Centroid", 1)
    summed = 0.5 + VY * t + 0.5 * G * shown.dt ** 2 * n * (n + 1)
    rounding = "round-off of some thousand additions"
    case.equal("largest distance of y from the exact sum", 0, np.abs(x[:, 1] - summed).max(),
               1e-11, rounding, "m", absolute=True)
    case.equal("largest distance of x from 0.5 + 5 t", 0,
               np.abs(x[:, 0] - 0.5 - VX * t).max(), 1e-11, rounding, "m", absolute=True)
    case.equal(f"y below the parabola at t = 2 s, dt {steps[2]:.3g} s",
               0.5 * G * t[-1] * steps[2], deviations[2], 1e-7,
               "round-off over the small difference", "m")
    case.equal("order of convergence in dt", 1, order(steps, deviations), 1e-3,
               "the times of the last steps differ a little")
    fine = np.linspace(0, t[-1], 100)
    chart = Chart("A projectile", "x, m", "y, m")
    chart.expected(0.5 + VX * fine, 0.5 + VY * fine + 0.5 * G * fine ** 2, "parabola")
    chart.ours(x[:, 0], x[:, 1])
    case.chart(chart)
