"""Block 1 falls along block 2 in every frame."""

import random

import numpy as np
from suite.chart import Chart
from suite.deck import turned

LENGTH = "quick"


def check(case):
    deck, draw = case.text("figure4b.deck"), random.Random(4)
    angles, errors = [], []
    for k in range(12):
        angle, way = draw.uniform(0, 360), draw.uniform(0, 2 * np.pi)
        far = (0, 1, 1e3, 1e6)[k % 4]
        run = case.run("figure4b", text=turned(deck, angle, (far * np.cos(way), far * np.sin(way))))
        n = run.summary["steps"]
        fall = run.of("Centroid", 1)[-1] - run.of("Centroid", 1)[0]
        free = 10 * run.dt ** 2 * n * (n + 1) / 2
        down = np.array([np.sin(np.radians(angle)), -np.cos(np.radians(angle))])
        angles.append(angle)
        errors.append(np.linalg.norm(fall[:2] - free * down))
    case.equal(f"largest distance from the free fall of {free:.3f} m, 12 frames up to 1e6 m away",
               0, max(errors), 1e-6, "corners are rounded to 1e-10 m there, and rub by that much",
               "m", absolute=True)
    near = [e for k, e in enumerate(errors) if k % 4 < 2]
    case.equal("the same, frames within 1 m of the origin", 0, max(near), 1e-10,
               "corners are rounded to 1e-16 m", "m", absolute=True)
    chart = Chart("Figure 4b in random frames", "angle of the frame, degrees",
                  "distance from the free fall, m", log="y")
    for k, far in enumerate(("at the origin", "1 m away", "1 km away", "1000 km away")):
        chart.ours(angles[k::4], [max(e, 1e-17) for e in errors[k::4]], far)
    case.chart(chart)
