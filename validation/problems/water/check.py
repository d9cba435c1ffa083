"""Water in joints: limit equilibrium with uplift and thrust, and buoyancy."""

from math import cos, radians, sin, tan

import numpy as np
from suite.deck import polygon, turned
from suite.frames import outlines
from suite.spring_statics import section

LENGTH = "long"
GAMMA, GRAVITY, PHI = 9810.0, 9.81, radians(35)
FRAMES = ((0, (0.0, 0.0)), (17.2, (100.0, 200.0)), (45, (-50.0, 7.0)))


def table(points, ramp=0.2):
    """Returns the WATER card of these points."""
    return f"WATER, {GAMMA:g}, {len(points)}, {ramp:g}\n" + \
        "\n".join(f"{x:.12g}, {y:.12g}" for x, y in points)


def pressed(corners, pressure, parts=20000):
    """Returns the force of a pressure on a clockwise outline, by the midpoint rule."""
    force = np.zeros(2)
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        t = (np.arange(parts) + 0.5) / parts
        at = a + t[:, None] * (b - a)
        inward = np.array([b[1] - a[1], a[0] - b[0]]) / parts
        force += np.maximum(pressure(at[:, 0], at[:, 1]), 0).sum() * inward
    return force


def sliding(force, dip, cohesion):
    """F of a body that slides to the left on a plane, from the resultant force on it without that
    of the plane; cohesion is a force."""
    along, inward = np.array([-cos(dip), -sin(dip)]), np.array([sin(dip), -cos(dip)])
    return (cohesion + force @ inward * tan(PHI)) / (force @ along)


def brackets(case, what, text, water, known, within=0.01):
    """Adds rows: the bracket of FOS contains the known factor, in three frames."""
    deck = text.replace("$ WATER", water)
    runs = case.run_all([("fos", (), turned(deck, *frame)) for frame in FRAMES])
    found = [run.summary["factor_of_safety"] for run in runs]
    case.at_most(f"{what}: distance of {known:.5g} from the bracket, worst of three frames", within,
                 max(max(one["lower"] - known, known - one["upper"], 0) / known for one in found),
                 "blocks settle on springs, and slip a little before the limit")
    case.measured(f"{what}: brackets", "; ".join(
        f"{one['lower']} to {one['upper']}" for one in found), "three frames")
    return runs[0]


def plane(case):
    text, psi = case.text("plane.deck"), radians(35)
    block = np.array(outlines(text)[1])
    area, _ = section(block)
    crack, foot = block[3][0], block[3][1]
    depth, length = block[2][1] - foot, crack / cos(psi)
    weight = 2600 * GRAVITY * area
    shown = None
    for share in (0, 0.25, 0.5, 0.75, 1):
        level = share * depth
        uplift, thrust = GAMMA * level * length / 2, GAMMA * level ** 2 / 2
        known = (3e4 * length + (weight * cos(psi) - uplift - thrust * sin(psi)) * tan(PHI)) \
            / (weight * sin(psi) + thrust * cos(psi))
        water = table([(0, 0), (crack, foot + level)]) if share else "WATER, , 0"
        shown = brackets(case, f"plane slide, crack filled to {100 * share:g} %", text, water, known)
    # A reservoir in front of the face, and its drawdown while the joints stay wet.
    shore = 6 / tan(radians(60))
    full = [(shore, 6), (crack, foot + depth / 2)]
    wet = [(0, 0), (shore, 6), (crack, foot + depth / 2)]
    factors = []
    for points in (full, wet):
        xs, ys = np.array(points).T
        load = pressed(block, lambda x, y: GAMMA * (np.interp(x, xs, ys) - y))
        factors.append(sliding(load + [0, -weight], psi, 3e4 * length))
    brackets(case, "plane slide, reservoir of 6 m", text, table(full), factors[0])
    brackets(case, "plane slide, after its drawdown", text,
             table(full) + "\nSOLVE\n" + table(wet, 0.5), factors[1])
    case.at_most("drawdown: factor after it, of that before", 1, factors[1] / factors[0],
                 "a drawdown lowers the factor of safety")
    case.picture(shown, "--colour", "water_pressure")


def wedge(case):
    text, psi = case.text("wedge.deck"), radians(35)
    block = np.array(outlines(text)[1])
    area, _ = section(block)
    top = block[2]
    length, weight = np.hypot(*top), 2600 * GRAVITY * area
    for height in (0, 25, 50):
        most = GAMMA * height / 2
        wet = height / top[1]  # the part of the plane with water
        middle, end = wet * top / 2, wet * top
        water = "\n".join(f"JWATER, 0, {a[0]:.12g}, {a[1]:.12g}, {p:g}, {b[0]:.12g}, {b[1]:.12g}, {q:g}, .02, .2"
                          for a, b, p, q in (((0, 0), middle, 0, most), (middle, end, most, 0)))
        uplift = most * wet * length / 2
        known = (1e5 * length + (weight * cos(psi) - uplift) * tan(PHI)) / (weight * sin(psi))
        brackets(case, f"wedge, water up to {height} m", text, water if height else "WATER, , 0", known)


def dam(case):
    text = case.text("dam.deck")
    weight, reservoir, base = 2400 * GRAVITY * 120, 11.0, 10.0
    heel = 0.2  # the table falls from here on, so a dam that slips is still in the reservoir
    for what, points in (("full uplift", [(heel, reservoir), (base, 0)]),
                         ("drained", [(heel, reservoir), (2, reservoir / 3), (base, 0)])):
        xs, ys = np.array([(0, reservoir), *points]).T
        uplift = GAMMA * ((ys[1:] + ys[:-1]) / 2 * np.diff(xs)).sum()
        known = (2e4 * base + (weight - uplift) * tan(PHI)) / (GAMMA * reservoir ** 2 / 2)
        brackets(case, f"dam, {what}", text, table(points), known)


def clipped_area(corners, level):
    """The area of an outline below a level. Seams of no area join what falls apart."""
    kept = []
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        if a[1] <= level:
            kept.append(a)
        if (a[1] <= level) != (b[1] <= level):
            kept.append(a + (level - a[1]) / (b[1] - a[1]) * (b - a))
    x, y = np.array(kept).T if kept else (np.zeros(1), np.zeros(1))
    return abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2


def buoyancy(case):
    angle = radians(23)
    shapes = {"triangle": [(0, 0), (1, 2), (3, 0)],
              "rectangle half under water": [(5, 3), (5, 5), (7, 5), (7, 3)],
              "L": [(10, 0), (10, 3), (11, 3), (11, 1), (13, 1), (13, 0)],
              "turned rectangle": [(16 + x * cos(angle) - y * sin(angle), 2 + x * sin(angle) + y * cos(angle))
                                   for x, y in ((0, 0), (0, 2), (3, 2), (3, 0))]}
    level, head = 4.0, "START, 9, 9\nBUOYANCY\nXLIMITS, -50, 50\nYLIMITS, -50, 50\nBOXES, 20, 20, .05\n" \
        "STIFF, 1.E8, 1.E8\nFRACTION, .01\nMATERIAL, 1, 2.E10, 8.E9, 2600\nRIGID\nEND\n"
    text = head + "".join(polygon(corners) for corners in shapes.values()) + \
        f"GRAVITY, 0, {-GRAVITY}\nWATER, {GAMMA:g}, 1\n0, {level}\nCYCLE, 1\nSTOP\n"
    worst = dict.fromkeys(shapes, 0.0)
    for degrees, shift in FRAMES:
        c, s = cos(radians(degrees)), sin(radians(degrees))
        run = case.run("buoyancy", text=turned(text, degrees, shift))
        forces = run.all("WaterForce")[0][:, :2]
        for force, (name, corners) in zip(forces, shapes.items()):
            wanted = GAMMA * clipped_area(np.array(corners), level) * np.array([-s, c])
            worst[name] = max(worst[name], np.linalg.norm(force - wanted) / np.linalg.norm(wanted))
    for name, error in worst.items():
        case.at_most(f"buoyancy of a {name}: error, worst of three frames", 1e-13, error,
                     "round-off of coordinates of 200 m")


def check(case):
    buoyancy(case)
    plane(case)
    wedge(case)
    dam(case)
