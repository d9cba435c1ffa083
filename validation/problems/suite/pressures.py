"""Loads by PRESSBC: their resultants and the stress (9) that they apply, from the deck."""

import re

import numpy as np


class Pressures:
    """Forces of the PRESSBC cards on one outline when FUNCTION is 1, about its centroid."""

    def __init__(self, text, corners):
        self.corners = corners
        x, y = (corners - corners[0]).T
        cross = np.roll(x, -1) * y - x * np.roll(y, -1)  # positive clockwise
        self.area = 0.5 * cross.sum()
        middle = [(cross * (v + np.roll(v, -1))).sum() / (6 * self.area) for v in (x, y)]
        self.centroid = corners[0] + middle
        u, w = (corners - self.centroid).T
        cross = np.roll(u, -1) * w - u * np.roll(w, -1)
        second = [(cross * (v * v + v * np.roll(v, -1) + np.roll(v, -1) ** 2)).sum() / 12
                  for v in (u, w)]
        self.second_moment = sum(second)  # polar, [L^4]
        self.force, self.moment, self.stress = np.zeros(2), 0.0, np.zeros((2, 2))
        for side, first, last in re.findall(r"^PRESSBC, 1, (\d+), ([^,]+), ([^,]+),", text, re.M):
            ends = corners[int(side) - 1], corners[int(side) % len(corners)]
            along = ends[1] - ends[0]
            inwards = np.array([along[1], -along[0]])
            p, q = float(first), float(last)
            for end, share in zip(ends, ((2 * p + q) / 6, (p + 2 * q) / 6)):
                force, arm = share * inwards, end - self.centroid
                self.force += force
                self.moment += arm[0] * force[1] - arm[1] * force[0]
                self.stress += np.outer(force, arm) / self.area
