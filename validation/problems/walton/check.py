"""Walton's normal law: rebound, and what the law says of overlap, force and duration."""

from math import pi, sqrt

import numpy as np
from suite.chart import Chart
from suite.deck import polygon, turned, with_lines

LENGTH = "quick"
MASS, K1, SPEED, GAP = 2000.0, 2e8, 1.0, 1e-4
OVERLAP, FORCE = SPEED * sqrt(MASS / K1), SPEED * sqrt(MASS * K1)
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
SCHEME = "second order: about (omega dt)^2 = 8e-6"
LONG = "STIFF, 2.E8, 2.E8"


def per_area(text):
    """The same stiffness in all, but as kn of 1 m of face."""
    return with_lines(text, JOINT="JOINT, 1, 0.5, , , , , , , , 2.E8, 2.E8")


def on_equal_face(text):
    """The floor is as wide as the block, so that both ends have two contacts."""
    return per_area(text).replace("-5, -5, 5, 5", "-0.5, -0.5, 0.5, 0.5")


def on_blocks(text):
    """The floor is of three blocks, so that there are six contacts of different stiffness."""
    floor = "".join(polygon([(a, -1), (a, 0), (b, 0), (b, -1)], True)
                    for a, b in ((-5, -0.3), (-0.3, 0.1), (0.1, 5)))
    text = per_area(text).replace("CREATE, 4, 1, 1\n-5, -5, 5, 5\n-1, 0, 0, -1\n", floor)
    return with_lines(text, START="START, 4, 4", SETVEL="SETVEL, 4, 0, 0, -1, 0")


def on_corner(text):
    """The square falls on its corner: one contact."""
    half = sqrt(0.5)
    square = polygon([(0, GAP), (-half, GAP + half), (0, GAP + 2 * half), (half, GAP + half)])
    head, tail = text.split("CREATE, 4, 1\n")
    return with_lines(head + square + tail.split("\n", 2)[2], STIFF=LONG)


class Rebound:
    """A run: what acts on the block that hits the floor, over the frames."""

    def __init__(self, run, block=2):
        contacts = run.all_contacts()
        frames = contacts["Frame"]
        self.times, self.dt = run.times, run.dt
        self.force = np.bincount(frames, contacts["NormalForce"], len(run.times))
        self.overlap = np.zeros(len(run.times))
        np.maximum.at(self.overlap, frames, contacts["Overlap"])
        self.count = np.bincount(frames).max()
        self.speed = np.hypot(*run.of("Velocity", block)[-1, :2])
        self.spin = run.of("Spin", block)[-1]
        top = int(np.argmax(self.force))
        self.unloads = np.flatnonzero((self.force > 0) & (np.arange(len(self.force)) > top + 1))

    def plastic(self):
        """a0: where the line of unloading ends."""
        x, y = self.overlap[self.unloads], self.force[self.unloads]
        line = np.polyfit(x, y, 1)
        return -line[1] / line[0]

    def duration(self):
        """Time from the first touch until the force is 0, by the line through its last frames. The
        forces of a frame are those at the start of its step."""
        last = self.unloads[-3:]
        line = np.polyfit(self.force[last], self.times[last], 1)
        return line[1] - self.dt - GAP / SPEED


def cycles(case):
    """Overlaps in a row, each reached in a thousand steps, and the forces there."""
    e, overlaps = 0.6, (2e-3, 1.2e-3, 3.2e-3, 2.2e-3, 2.6e-3, 1e-3)
    text = case.text("cycles.deck")
    dt = case.run("cycles", text=with_lines(text, MOTION="CYCLE, 1")).dt
    head = text.split("PLOTS")[0]
    at, lines, ends = 0.0, [], []
    for overlap in overlaps:
        steps = 1000 if at else 1001  # A contact acts from its second step on.
        lines += [f"DRIVE, 2, 0, {-(overlap - at) / (1000 * dt):.17g}", f"CYCLE, {steps}"]
        ends.append(steps + (ends[-1] if ends else 0))
        at = overlap
    times = ", ".join(f"{end * dt:.15g}" for end in ends)
    text = head + "\n".join([f"PLOTS, {20 * dt:.15g}, {times}", *lines, "STOP", ""])
    forces, most = [], 0.0
    for overlap in overlaps:
        most = max(most, overlap)
        forces.append(max(0.0, min(K1 * overlap, K1 / e ** 2 * (overlap - (1 - e * e) * most))))
    for degrees, shift in FRAMES:
        run = Rebound(case.run("cycles", text=turned(text, degrees, shift)))
        for overlap, force, end in zip(overlaps, forces, ends):
            frame = np.argmin(np.abs(run.times - end * dt))
            case.equal(f"e 0.6, turned by {degrees}: force at the overlap {overlap * 1e3:g} mm",
                       force, run.force[frame], 1e-9 * K1 * overlaps[0],
                       "round-off, and of the first overlap", "N", absolute=True)
    chart = Chart("Walton's law in cycles: e = 0.6, K1 = 200 MN/m", "overlap, mm", "force, kN")
    chart.ours(1e3 * run.overlap, 1e-3 * run.force, "driven block", line=True)
    return chart


def check(case):
    text = case.text("square.deck")
    for degrees, shift in FRAMES:
        ours = Rebound(case.run("square", text=turned(text, degrees, shift)))
        where = f"e 0.5, turned by {degrees}"
        case.equal(f"{where}: rebound", 0.5 * SPEED, ours.speed, 1e-5, SCHEME, "m/s")
        case.equal(f"{where}: largest overlap", OVERLAP, ours.overlap.max(), 1e-5, SCHEME, "m")
        case.equal(f"{where}: largest force", FORCE, ours.force.max(), 1e-5, SCHEME, "N")
        case.equal(f"{where}: time in contact", pi / 2 * sqrt(MASS / K1) * 1.5, ours.duration(),
                   1e-5, SCHEME, "s")
        case.equal(f"{where}: overlap a0 without force", 0.75 * OVERLAP, ours.plastic(), 1e-5, SCHEME,
                   "m")
    chart = Chart("Walton's law: a square of 2000 kg hits a floor with 1 m/s", "overlap, mm",
                  "force, kN")
    for e in (1.0, 0.8, 0.5, 0.2):
        own = with_lines(text, WALTON=f"WALTON, 1, {e}", MOTION="MOTION, 0.012")
        ours = Rebound(case.run("square", text=own))
        if e != 0.5:
            case.equal(f"e {e:g}: rebound", e * SPEED, ours.speed, 1e-5, SCHEME, "m/s")
            case.equal(f"e {e:g}: overlap a0 without force", (1 - e * e) * OVERLAP, ours.plastic(),
                       1e-5 * OVERLAP, SCHEME, "m", absolute=True)
        chart.ours(1e3 * ours.overlap[ours.force > 0][::9], 1e-3 * ours.force[ours.force > 0][::9],
                   f"e = {e:g}")
        lines = np.array([0, OVERLAP, (1 - e * e) * OVERLAP])
        chart.expected(1e3 * lines, [0, 1e-3 * FORCE, 0], "")
    for name, deck, block, contacts in (("kn of the face", per_area(text), 2, 2),
                                        ("floor as wide as the block", on_equal_face(text), 2, 4),
                                        ("floor of three blocks", on_blocks(text), 4, 6),
                                        ("on a corner", on_corner(text), 2, 1)):
        ours = Rebound(case.run("square", text=deck), block)
        case.same(f"{name}: number of contacts", str(contacts), str(ours.count), "as the problem is posed")
        case.equal(f"{name}: rebound", 0.5 * SPEED, ours.speed, 1e-5, SCHEME, "m/s")
        case.equal(f"{name}: spin after the rebound", 0, ours.spin, 1e-9, "round-off", "1/s",
                   absolute=True)
    for modulus in (1e12, 1e13):
        stiff = with_lines(text, RIGID="", MATERIAL=f"MATERIAL, 1, {modulus:g}, {modulus / 2:g}, 2000")
        ours = Rebound(case.run("square", text=turned(stiff, *FRAMES[1])))
        case.equal(f"deformable, E = {modulus:g}: rebound", 0.5 * SPEED, ours.speed,
                   K1 / modulus, "the block strains and swings: at most K1 / C11 of the speed", "m/s")
    case.chart(chart)
    case.chart(cycles(case))
