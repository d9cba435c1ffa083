"""What several problems of cracks need: frames, angles and outlines."""

import numpy as np

# Degrees and shift of frames.
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))


def off(angle, expected):
    """Returns the angle between two lines [degrees], given by their directions."""
    return (angle - expected + 90) % 180 - 90


def area(corners):
    """Area of an outline, positive clockwise [L^2]."""
    x, y = (corners - corners[0]).T
    return 0.5 * (np.dot(np.roll(x, -1), y) - np.dot(x, np.roll(y, -1)))


def reached(case, where, run, cracks=1):
    """Adds a row: so many blocks have split. Returns whether it holds."""
    case.equal(f"{where}: cracks", cracks, len(run.cracks), 0, "exact", absolute=True)
    return len(run.cracks) == cracks
