"""Fits and searches that several problems need."""

import numpy as np


def slope(x, y):
    """Slope of the least-squares line."""
    return np.polyfit(x, y, 1)[0]


def order(steps, errors):
    """Order of convergence: slope of log error over log step."""
    return slope(np.log(steps), np.log(np.abs(errors)))


def bisect(fails, low, high, width):
    """Returns where `fails` changes from true (at low) to false (at high), to +-width / 2. Returns
    NaN if it does not change between them, so such a limit misses."""
    if not fails(low) or fails(high):
        return float("nan")
    while high - low > width:
        middle = 0.5 * (low + high)
        if fails(middle):
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def first_time(times, values, level):
    """Returns the time when values first reach a level, linear between frames."""
    reached = np.nonzero(values >= level)[0]
    if len(reached) == 0:
        return float("nan")
    k = reached[0]
    if k == 0:
        return times[0]
    share = (level - values[k - 1]) / (values[k] - values[k - 1])
    return times[k - 1] + share * (times[k] - times[k - 1])
