"""Limit equilibrium of the toppling slope of Goodman and Bray (1976)."""

from math import cos, radians, sin, tan

import numpy as np

WIDTH, UNIT, STEP, DIP = 10.0, 25.0, 5.0, radians(30)
HEIGHT = {n: 4.0 * n if n <= 10 else 40.0 - 6 * (n - 10) for n in range(1, 17)}


def equilibrium(phi):
    """Returns the forces P_(n-1) below columns 16 ... 1, and how each column fails."""
    force, mode, above = {}, {}, 0.0
    for n in range(16, 0, -1):
        y, weight = HEIGHT[n], HEIGHT[n] * WIDTH * UNIT
        m, low = (y, y - STEP) if n < 10 else (y - STEP, y - STEP) if n == 10 else (y - STEP, y)
        t = tan(radians(phi))
        topple = slide = -1.0
        if low > 0:
            topple = (above * (m - WIDTH * t) +
                      weight / 2 * (y * sin(DIP) - WIDTH * cos(DIP))) / low
        slide = above - weight * (cos(DIP) * t - sin(DIP)) / (1 - t * t)
        # The lowest column has no lever arm L, so it slides. The others fail in the way that
        # needs more support.
        below = max(topple, slide) if n > 1 else slide
        mode[n] = "stands" if below <= 0 and n > 1 else "topples" if topple > slide else "slides"
        above = force[n] = below if n == 1 else max(below, 0.0)
    return force, mode


def between(run, frame):
    """Returns the normal force of column n on column n - 1 for all n."""
    contacts = run.contacts(frame)
    pair = np.sort([contacts["CornerBlock"], contacts["EdgeBlock"]], axis=0)
    return {n: contacts["NormalForce"][(pair[0] == n - 1) & (pair[1] == n)].sum()
            for n in range(2, 14)}
