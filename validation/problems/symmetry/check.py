"""Half model equals full model."""

import numpy as np
from suite.chart import Chart

LENGTH = "quick"


def check(case):
    full, half = case.run("full.deck"), case.run("half.deck")
    case.at_least("speed of the rebound, so that they have met", 0.3,
                  half.of("Velocity", 1)[-1, 0], "else nothing is tested", "m/s")
    rounding = "round-off: different sums of the same forces"
    case.equal("largest distance of right box and half model", 0,
               np.abs(full.of("Centroid", 2) - half.of("Centroid", 1)).max(), 1e-12, rounding, "m",
               absolute=True)
    case.equal("largest difference of their velocities", 0,
               np.abs(full.of("Velocity", 2) - half.of("Velocity", 1)).max(), 1e-11, rounding,
               "m/s", absolute=True)
    chart = Chart("Half model beside SPLANE", "time, s", "velocity in x, m/s")
    chart.expected(full.times, full.of("Velocity", 2)[:, 0], "right box of the full model")
    chart.ours(half.times, half.of("Velocity", 1)[:, 0], "half model")
    case.chart(chart)
