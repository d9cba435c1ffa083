"""Linear statics of blocks on contact springs: the reference for models that are statically
indeterminate. Blocks are rigid, or have one uniform strain each, in plane strain. Displacements are
small, so contacts act in the initial geometry."""

from dataclasses import dataclass

import numpy as np


def section(corners):
    """Returns the area and the centroid of a polygon."""
    x, y = np.asarray(corners, float).T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    area = cross.sum() / 2
    centroid = np.array([((x + np.roll(x, -1)) * cross).sum(),
                         ((y + np.roll(y, -1)) * cross).sum()]) / (6 * area)
    return abs(area), centroid


@dataclass
class Contact:
    """A corner of block `corner` at `point` on an edge of block `edge`; -1 is a fixed block. The
    edge runs in the direction `along`, with its outward normal on the left. If `slides` is not
    None, the shear force is `slides` times the normal force."""
    point: np.ndarray
    along: np.ndarray
    corner: int
    edge: int
    stiffness: tuple  # normal and shear
    slides: float | None = None


class Statics:
    """Blocks with these corners. `elastic` is (E, G), or None for rigid blocks."""

    def __init__(self, outlines, elastic=None):
        self.each = 6 if elastic else 3  # u, v, rotation; strains xx, yy, xy
        self.sections = [section(corners) for corners in outlines]
        size = self.each * len(outlines)
        self._stiff, self._load = np.zeros((size, size)), np.zeros(size)
        self._laws = []
        if elastic:
            for b, (area, _) in enumerate(self.sections):
                own = slice(self.each * b + 3, self.each * b + 6)
                self._stiff[own, own] = area * plane_strain(*elastic)

    def add_weight(self, gravity, density):
        for b, (area, _) in enumerate(self.sections):
            self._load[self.each * b:self.each * b + 2] += density * area * np.asarray(gravity)

    def add_force(self, block, point, force):
        """Adds a force at a point of a block."""
        own = slice(self.each * block, self.each * (block + 1))
        self._load[own] += np.asarray(force) @ self._unit(block, point)

    def add_contact(self, contact):
        along = np.asarray(contact.along, float)
        sides = [(block, sign) for block, sign in ((contact.corner, 1), (contact.edge, -1))
                 if block >= 0]
        at = np.concatenate([np.arange(self.each) + self.each * block for block, _ in sides])
        gap = np.hstack([sign * self._unit(block, contact.point) for block, sign in sides])
        closing, sliding = -np.array([-along[1], along[0]]) @ gap, along @ gap
        normal = contact.stiffness[0] * closing
        shear = contact.stiffness[1] * sliding if contact.slides is None else \
            contact.slides * normal
        self._stiff[np.ix_(at, at)] += np.outer(closing, normal) + np.outer(sliding, shear)
        self._laws.append((at, normal, shear))

    def solve(self):
        """Returns the normal and the shear forces of the contacts, in the order in which they were
        added, shape (n, 2), and the unknowns of the blocks. Compression is positive; the shear force
        is positive if the corner has moved in the direction of the edge."""
        moved = np.linalg.solve(self._stiff, self._load)
        forces = np.array([(normal @ moved[at], shear @ moved[at])
                           for at, normal, shear in self._laws])
        return forces, moved.reshape(-1, self.each)

    def displacement(self, moved, block, point):
        """Returns the displacement of a point of a block; `moved` is from solve()."""
        return self._unit(block, point) @ moved[block]

    def _unit(self, block, point):
        """Displacement of a point of a block by its unknowns, shape (2, each)."""
        x, y = np.asarray(point) - self.sections[block][1]
        return np.array([[1, 0, -y, x, 0, y], [0, 1, x, 0, y, x]])[:, :self.each]


def plane_strain(young, shear):
    """Returns twice the strain energy per area as a matrix of the strains xx, yy and xy."""
    c11 = shear * (4 * shear - young) / (3 * shear - young)
    c12 = shear * (young - 2 * shear) / (3 * shear - young)
    return np.array([[c11, c12, 0], [c12, c11, 0], [0, 0, 4 * shear]])
