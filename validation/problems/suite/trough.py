"""Subsidence of a surface, and the profile functions for comparison."""

import math

import numpy as np

ERF = np.vectorize(math.erf)
FUNCTIONS = {"error integral": lambda u: ERF(math.sqrt(math.pi) * u), "hyperbolic tangent": np.tanh}


def surface(results, above, frame=-1):
    """Returns the initial x and the subsidence s of the upper corners of all blocks that started
    above this height, from the left."""
    places = []
    for block in range(1, results.blocks + 1):
        start = results.outline(block, 0)
        if start[:, 1].max() > above and not results.all("Fixed")[0][block - 1]:
            now = results.outline(block, frame)
            tops = np.argsort(start[:, 1])[-2:]
            places += [(start[k, 0], start[k, 1] - now[k, 1]) for k in tops]
    return np.array(sorted(places)).T


def profile(name, x, depth, half, length):
    """Returns the trough over a panel: depth / 2 (f((x + half) / length) - f((x - half) / length)).
    f is the error integral (Knothe, length = radius of influence) or the hyperbolic tangent."""
    f = FUNCTIONS[name]
    return 0.5 * depth * (f((x + half) / length) - f((x - half) / length))


def fit(name, x, s):
    """Fits by least squares. Returns (depth, half, length) and the root mean square of the
    residual. Depth is linear; the other two are searched on grids around the best values."""
    best = (math.inf, 0.0, 0.0, 0.0)
    halves, lengths = np.linspace(1, 60, 60), np.linspace(1, 60, 60)
    for _ in range(5):
        for half in halves:
            for length in lengths:
                shape = profile(name, x, 1.0, half, length)
                depth = shape @ s / (shape @ shape)
                left = math.sqrt(np.mean((s - depth * shape) ** 2))
                if left < best[0]:
                    best = (left, depth, half, length)
        step = halves[1] - halves[0], lengths[1] - lengths[0]
        halves = np.maximum(np.linspace(best[2] - step[0], best[2] + step[0], 9), 0.05)
        lengths = np.maximum(np.linspace(best[3] - step[1], best[3] + step[1], 9), 0.05)
    return best[1:], best[0]


def reach(x, s, level):
    """Returns the last x where the subsidence falls below this level, linear between places, or 0
    if it never reaches the level."""
    above = np.nonzero(s >= level)[0]
    if len(above) == 0:
        return 0.0
    last = above.max()
    if last + 1 == len(x):
        return x[last]
    part = (s[last] - level) / (s[last] - s[last + 1])
    return x[last] + part * (x[last + 1] - x[last])
