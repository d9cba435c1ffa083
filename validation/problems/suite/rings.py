"""Jointed ground around a circular opening, in rings of blocks. Joints are the softer the larger the
blocks beside them, so that the ground has the same stiffness everywhere and in all directions."""

import math

import numpy as np

from .deck import polygon
from .spring_statics import Contact, Statics


class Rings:
    """Rings of `sectors` blocks, about as wide as high, from the radius `inner` to `outer`, around
    one block, the core, and inside of a fixed ring. The stiffness of a joint, in both directions, is
    `joints` [F/L^2] divided by the spacing of joints. The corners lie a little outside of the radii,
    so that areas are those of circles."""

    def __init__(self, sectors, inner, outer, joints):
        self.sectors, self.joints = sectors, joints
        self.inner, self.outer = inner, outer
        self.count = round(math.log(outer / inner) * sectors / (2 * math.pi))
        angle = 2 * math.pi / sectors
        self.radii = (inner * (outer / inner) ** (np.arange(self.count + 1) / self.count) *
                      math.sqrt(angle / math.sin(angle)))
        self.heights = np.diff(self.radii)

    def corner(self, radius, k):
        angle = 2 * math.pi * k / self.sectors
        return np.array([radius * math.cos(angle), radius * math.sin(angle)])

    def outline(self, low, high, k):
        """Returns the corners of a block between two radii, clockwise."""
        return [self.corner(low, k + 1), self.corner(high, k + 1), self.corner(high, k),
                self.corner(low, k)]

    def first_ring(self):
        """Returns the numbers of the blocks of the innermost ring, in the deck that cards() makes.
        The core is block 1, and the fixed blocks follow it."""
        return np.arange(self.sectors) + 2 + self.sectors

    def joint_inside(self, ring):
        """Stiffness per area of the joints between the blocks of a ring."""
        middle = self.radii[ring:ring + 2].mean()
        return self.joints / (2 * middle * math.sin(math.pi / self.sectors))

    def joint_outside(self, ring):
        """Stiffness per area of the joint around a ring."""
        if ring + 1 == self.count:  # The fixed ring has no half of a block.
            return 2 * self.joints / self.heights[ring]
        return 2 * self.joints / (self.heights[ring] + self.heights[ring + 1])

    def cards(self, constants):
        """Returns the MATERIAL cards, the CREATE cards, and the JOINT and JPAIR cards. The constants
        are those of MATERIAL. Ring k has material k + 1, and every pair of rings a joint."""
        n, sectors = self.count, range(self.sectors)
        core, fixed = n + 1, n + 2
        materials = "".join(f"MATERIAL, {k}, {constants}\n" for k in range(1, n + 3))
        blocks = polygon([self.corner(self.radii[0], -k) for k in sectors], False, core)
        edge = self.radii[-1]
        blocks += "".join(polygon(self.outline(edge, edge + self.heights[-1], k), True, fixed)
                          for k in sectors)
        blocks += "".join(polygon(self.outline(*self.radii[ring:ring + 2], k), False, ring + 1)
                          for ring in range(n) for k in sectors)
        joints = [(ring + 1, ring + 1, self.joint_inside(ring)) for ring in range(n)]
        joints += [(ring + 1, ring + 2 if ring + 1 < n else fixed, self.joint_outside(ring))
                   for ring in range(n)]
        joints.append((1, core, self.joints / self.heights[0]))
        return materials, blocks, "".join(
            f"JOINT, {k}, {FRICTION}, , , , , , , , {kn:.15g}\nJPAIR, {a}, {b}, {k}\n"
            for k, (a, b, kn) in enumerate(joints, 1))

    def closure(self, pressure, elastic, radius):
        """Returns how far the ground at a radius moves towards the centre when a pressure is removed
        from the inside, if it is a continuum that is fixed at the outer radius."""
        young, shear = elastic or (math.inf, math.inf)
        nu = young / (2 * shear) - 1 if elastic else 0.0
        along = (1 - nu**2) / young + 1 / self.joints
        across = -nu * (1 + nu) / young
        ratio = (along - across) / (along + across)
        b = pressure * self.inner**2 / (1 + ratio * (self.inner / self.outer)**2)
        return (along - across) * b * (1 / radius - radius / self.outer**2)

    def statics(self, stress, elastic):
        """Returns by how much the centroids of the first ring move when the core is removed, shape
        (sectors, 2), by the linear statics of springs. The stress is that in the ground, 2 by 2."""
        statics = Statics([self.outline(*self.radii[ring:ring + 2], k)
                           for ring in range(self.count) for k in range(self.sectors)], elastic)

        def add_face(block, other, start, end, stiffness):
            length = np.linalg.norm(end - start)
            stiff = stiffness * length / 2
            for point in (start, end):
                statics.add_contact(Contact(point, (end - start) / length, block, other,
                                            (stiff, stiff)))

        for ring in range(self.count):
            low, high = self.radii[ring:ring + 2]
            for k in range(self.sectors):
                block = ring * self.sectors + k
                beside = ring * self.sectors + (k + 1) % self.sectors
                outside = block + self.sectors if ring + 1 < self.count else -1
                # The edges belong to the other block and run clockwise about it.
                add_face(block, beside, self.corner(high, k + 1), self.corner(low, k + 1),
                         self.joint_inside(ring))
                add_face(block, outside, self.corner(high, k), self.corner(high, k + 1),
                         self.joint_outside(ring))
        for k in range(self.sectors):
            start, end = self.corner(self.radii[0], k), self.corner(self.radii[0], k + 1)
            outward = np.array([(end - start)[1], -(end - start)[0]])
            for point in (start, end):
                statics.add_force(k, point, np.asarray(stress) @ outward / 2)
        return statics.solve()[1][:self.sectors, :2]


FRICTION = 10  # so large that no joint slips
