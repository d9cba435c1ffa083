"""Thrust of three-hinged arches by hand, and of arches with full joints by springs and by bounds."""

from itertools import combinations

import numpy as np
from suite.chart import Chart
from suite.frames import FRAMES, forces, outlines
from suite.spring_statics import Contact, Statics, section

LENGTH = "quick"
DENSITY, GRAVITY = 2500.0, 10.0
STIFFNESS, ELASTIC = (1e10, 5e9), (2e11, 8e10)
TOLERANCE = 2e-4
FIXED, RADIUS = 2, 5.0  # abutments 1 and 2; radius of the centre line [m]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


class Arch:
    """The blocks of a deck from the left abutment to the right one, and the contacts of their
    joints: {(corner block, corner, edge block): (point, direction of the edge)}."""

    def __init__(self, text):
        self.blocks = outlines(text)
        self.order = [1, *range(1 + FIXED, 1 + len(self.blocks)), 2]
        self.joints = [self._between(*pair) for pair in zip(self.order, self.order[1:])]
        sections = [section(self.blocks[b - 1]) for b in self.order[1:-1]]
        self.weights = np.array([DENSITY * GRAVITY * area for area, _ in sections])
        self.weight = self.weights.sum()
        # What the blocks left of each joint weigh, and its moment about the origin.
        moments = [weight * centre[0] for weight, (_, centre) in zip(self.weights, sections)]
        self.above = np.array([np.zeros(len(self.joints)), np.cumsum([0, *self.weights]),
                               np.cumsum([0, *moments])]).T

    def _between(self, left, right):
        """Returns the corners of two blocks that lie between the ends of an edge of the other."""
        found = {}
        for corner, edge in ((left, right), (right, left)):
            for c, point in enumerate(self.blocks[corner - 1]):
                ends = self.blocks[edge - 1]
                for start, end in zip(ends, np.roll(ends, -1, axis=0)):
                    length = np.linalg.norm(end - start)
                    along = (end - start) / length
                    if abs(cross(along, point - start)) < 1e-9 and \
                            1e-3 < (point - start) @ along < length - 1e-3:
                        found[corner, c + 1, edge] = (point, along)
        return found

    def thrust(self, found):
        """Returns horizontal force, vertical force and moment about the origin that the left side of
        each joint exerts on the right side, from the forces of its contacts."""
        total = np.zeros((len(self.joints), 3))
        for j, joint in enumerate(self.joints):
            for key, (point, along) in joint.items():
                normal, shear = found[key]
                force = normal * np.array([-along[1], along[0]]) - shear * along
                sign = 1 if key[0] == self.order[j + 1] else -1
                total[j] += sign * np.array([*force, cross(point, force)])
        return total

    def hinged(self):
        """Returns the same by the equilibrium of a three-hinged arch: three unknowns at the left
        springing, and no moment at the three joints with one contact."""
        rows, known = [], []
        for joint, above in zip(self.joints, self.above):
            if len(joint) == 1:
                (x, y), _ = next(iter(joint.values()))
                rows.append([y, -x, 1])  # moment about the hinge
                known.append(rows[-1] @ above)
        return np.linalg.solve(rows, known) - self.above

    def bounds(self):
        """Returns the thrusts with the least and the largest horizontal force with which the line of
        thrust lies inside every joint. They are corners of the polyhedron of (H, V, M) at the left
        springing."""
        rows = []
        for joint, above in zip(self.joints, self.above):
            inner, outer = sorted((point for point, _ in joint.values()), key=np.linalg.norm)
            for (x, y), sign in ((outer, 1), (inner, -1)):  # force at the other end, times the depth
                row = sign * np.array([y, -x, 1])
                rows.append([*row, row @ above])
        rows = np.array(rows)
        corners = []
        for three in combinations(rows, 3):
            a = np.array(three)
            if abs(np.linalg.det(a[:, :3])) > 1e-9:
                state = np.linalg.solve(a[:, :3], a[:, 3])
                if np.all(rows[:, :3] @ state >= rows[:, 3] - 1e-9 * self.weight):
                    corners.append(state)
        return [pick(corners, key=lambda state: state[0]) - self.above for pick in (min, max)]

    def line(self, thrust):
        """Returns x and y of the points where the force of each joint acts."""
        points = []
        for joint, (h, v, moment) in zip(self.joints, thrust):
            inner, outer = sorted((point for point, _ in joint.values()), key=np.linalg.norm)
            axis = (outer - inner) / np.linalg.norm(outer - inner)
            points.append(inner + axis * (moment - cross(inner, (h, v))) / cross(axis, (h, v)))
        return np.array(points).T

    def on_springs(self, elastic):
        """Returns the forces of the contacts by the linear statics of springs."""
        keys = {key: at for joint in self.joints for key, at in joint.items()}
        statics = Statics(self.blocks[FIXED:], elastic)
        statics.add_weight((0, -GRAVITY), DENSITY)
        for (corner, _, edge), at in keys.items():
            statics.add_contact(Contact(*at, max(corner - 1 - FIXED, -1),
                                        max(edge - 1 - FIXED, -1), STIFFNESS))
        return dict(zip(keys, statics.solve()[0]))


def check(case):
    for name in ("hinged_3", "hinged_7", "keystone_3", "keystone_7"):
        arch = Arch(case.text(name + ".deck"))
        for kind in ("rigid", "deformable"):
            compare(case, name, kind, arch)
    case.picture(case.run("hinged_7.deck"), "--forces", "--zoom", "-6,6,1,6")


def compare(case, name, kind, arch):
    """Runs one arch in three frames and adds its rows."""
    text, what = case.text(name + ".deck"), f"{name}, {kind}"
    deck = text if kind == "rigid" else text.replace("\nRIGID\n", "\n")
    found = [forces(case.run(name, text=move(deck)), frame) for frame, move in FRAMES.items()]
    ours = [arch.thrust(one) for one in found]
    hinged = name.startswith("hinged")
    springs = None if hinged else arch.on_springs(None if kind == "rigid" else ELASTIC)
    expected = arch.hinged() if hinged else arch.thrust(springs)
    thrust = max((lines[0, 0] for lines in ours), key=lambda h: abs(h - expected[0, 0]))
    case.equal(f"{what}: horizontal thrust, of the weight, worst of three frames",
               expected[0, 0] / arch.weight, thrust / arch.weight, TOLERANCE,
               "the crown sinks by 1e-5 to 1e-4 m as springs shorten")
    scale = arch.weight * np.array([1, 1, RADIUS])
    case.at_most(f"{what}: largest error of (H, V, M) of all joints, of the weight and 5 m, three "
                 "frames", TOLERANCE,
                 max(np.abs((lines - expected) / scale).max() for lines in ours), "the same")
    if hinged:
        return
    case.at_most(f"{what}: largest error of a force of a contact, of the weight, three frames",
                 2 * TOLERANCE, max(np.abs(np.subtract(one[key], springs[key])).max()
                                    for one in found for key in springs) / arch.weight, "the same")
    low, high = arch.bounds()
    case.at_least(f"{what}: horizontal thrust, over the least possible", 1,
                  thrust / low[0, 0], "no tension in the joints")
    case.at_most(f"{what}: horizontal thrust, over the largest possible", 1, thrust / high[0, 0],
                 "no tension in the joints")
    if what == "keystone_7, rigid":
        chart = Chart("Line of thrust of seven voussoirs", "x, m", "y, m", same_scale=True)
        angle = np.radians(np.linspace(30, 150, 60))
        for radius in (4.5, 5.5):
            chart.expected(radius * np.cos(angle), radius * np.sin(angle), "", "#cccccc")
        chart.expected(*arch.line(low), f"least thrust, {low[0, 0] / arch.weight:.3f} W", "#d1603d")
        chart.expected(*arch.line(high), f"largest thrust, {high[0, 0] / arch.weight:.3f} W",
                       "#3a8a4f")
        chart.ours(*arch.line(ours[0]), f"ours, {ours[0][0, 0] / arch.weight:.3f} W")
        case.chart(chart)
