"""Pieces of spinning blocks keep the momenta, and the halves of a rectangle its energy."""

import numpy as np
from suite import cracking
from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.frames import outlines
from suite.pressures import Pressures

LENGTH = "quick"
DENSITY = 2500.0


def deformable(text):
    return with_lines(text, RIGID="")


def rectangle(case, kind, text, degrees, shift):
    """Returns the run."""
    where = f"{kind} rectangle, turned by {degrees}"
    run = case.run("rectangle", text=turned(text, degrees, shift))
    if not cracking.reached(case, where, run):
        return run
    crack, = run.cracks
    # The stress of a rigid block is that of the start of the step, in which it turns.
    turn = 10 * run.dt
    within, because = (turn ** 2, "cut at the angle of the step before") if kind == "rigid" else \
        (1e-8, "strain of the pull")
    case.equal(f"{where}: kinetic energy before", 104166 + 2 / 3, crack["kinetic"][0], 1e-9,
               "strain energy of the pull", "J")
    case.equal(f"{where}: kinetic energy of the halves", 104166 + 2 / 3, crack["kinetic"][1], 1e-9,
               "the same", "J")
    split = run.counts == 2
    mass, v = run.all("Mass")[split], run.all("Velocity")[split][:, :, :2]
    inertia, spin = run.all("Inertia")[split], run.all("Spin")[split]
    case.equal(f"{where}: speed of the halves", 5, np.linalg.norm(v[0], axis=1)[0], within,
               because, "m/s")
    for name, energy, expected in (
            ("the centroids", (mass * (v ** 2).sum(axis=2)).sum(axis=1) / 2, 62500),
            ("the spins", (inertia * spin ** 2).sum(axis=1) / 2, 41666 + 2 / 3)):
        worst = energy[np.abs(energy - expected).argmax()]
        case.equal(f"{where}: energy of {name}, in all frames with halves", expected, worst,
                   within, because, "J")
    check_momenta(case, where, run, np.zeros(2), 5000 / 12 * 5 * 10)
    return run


def check_momenta(case, where, run, momentum, angular):
    """Momenta of the last frame. The angular one is about the origin."""
    scale = (run.all("Mass")[-1] * np.linalg.norm(run.all("Velocity")[-1], axis=1)).sum()
    lever = np.linalg.norm(run.all("Centroid")[-1], axis=1).max()
    off = np.abs(run.momentum()[-1] - momentum).max() / scale
    case.equal(f"{where}: momentum at the end, off by, of the sum of m v", 0, off, 1e-12,
               "round-off", absolute=True)
    off = abs(run.angular_momentum()[-1] - angular) / (scale * max(lever, 1))
    case.equal(f"{where}: angular momentum about the origin, off by, of the sum of m v r", 0, off,
               1e-12, "round-off", absolute=True)


class Kicked:
    """The clamp after the first step, with the impulse of its loads."""

    def __init__(self, text, dt):
        corners, = outlines(text)
        loads = Pressures(text, corners)
        line, = (line for line in text.splitlines() if line.startswith("SETVEL"))
        u, v, spin = (float(word) for word in line.split(",")[3:])
        mass = DENSITY * loads.area
        inertia = DENSITY * loads.second_moment
        self.velocity = np.array([u, v]) + dt * loads.force / mass
        self.spin = spin + dt * loads.moment / inertia
        h = 0.5 * dt * self.spin
        c, s = (1 - h * h) / (1 + h * h), 2 * h / (1 + h * h)
        self.centroid = loads.centroid + dt * self.velocity
        self.corners = self.centroid + (corners - loads.centroid) @ np.array([[c, s], [-s, c]])
        self.momentum = mass * self.velocity
        x, y = loads.centroid
        self.angular = inertia * self.spin + mass * (x * self.velocity[1] - y * self.velocity[0])
        symmetric = (loads.stress + loads.stress.T) / 2
        values, axes = np.linalg.eigh(symmetric)
        self.stress, self.axis = values[-1], axes[:, -1]

    def chord(self):
        """Returns the ends of the chord nearest to the centroid, at right angles to the axis."""
        along = np.array([-self.axis[1], self.axis[0]])
        crossings = []
        for a, b in zip(self.corners, np.roll(self.corners, -1, axis=0)):
            da, db = ((p - self.centroid) @ self.axis for p in (a, b))
            if (da < 0) != (db < 0):
                crossings.append((a + (b - a) * da / (da - db) - self.centroid) @ along)
        crossings.sort()
        chords = list(zip(crossings[::2], crossings[1::2]))
        near = min(chords, key=lambda ends: max(ends[0], -ends[1], 0))
        return len(chords), [self.centroid + t * along for t in near]


def clamp(case, kind, text, degrees, shift):
    """Returns the run."""
    where = f"{kind} clamp, turned by {degrees}"
    text = turned(text, degrees, shift)
    run = case.run("clamp", text=text)
    kicked = Kicked(text, run.dt)
    check_momenta(case, where, run, kicked.momentum, kicked.angular)
    case.equal(f"{where}: mass at the end", DENSITY * cracking.area(outlines(text)[0]),
               run.all("Mass")[-1].sum(), 1e-14, "round-off", "kg")
    if kind == "rigid":
        if not cracking.reached(case, where, run):
            return run
        crack, = run.cracks
        chords, ends = kicked.chord()
        case.equal(f"{where}: chords across the clamp", 2, chords, 0, "exact", absolute=True)
        case.equal(f"{where}: stress", kicked.stress, crack["stress"], 1e-12, "round-off", "Pa")
        found = [np.array(crack[name][:2]) for name in ("from", "to")]
        off = min(max(np.linalg.norm(a - b) for a, b in zip(ends, order))
                  for order in (found, found[::-1]))
        case.equal(f"{where}: ends of the cut, off by", 0, off, 1e-11,
                   "round-off of coordinates up to 200 m", "m", absolute=True)
        case.equal(f"{where}: energy that the crack releases, of the energy", 0,
                   crack["released"] / crack["kinetic"][0], 1e-13,
                   "the pieces move as the clamp did", absolute=True)
    else:
        case.at_least(f"{where}: cracks", 3, len(run.cracks), "pieces crack again")
        for name, of in (("kinetic", 0), ("strain", 0)):
            rises = max(crack[name][1] / max(crack[name][of], 1e-300) for crack in run.cracks)
            case.at_most(f"{where}: {name} energy after a crack, of that before", 1 + 1e-12, rises,
                         "a crack adds no energy")
        released = sum(crack["released"] for crack in run.cracks)
        case.equal(f"{where}: energy:cracks", released, run.summary["energy"]["cracks"], 1e-9,
                   "the sum over the record", "J")
    areas = [cracking.area(run.outline(block, -1)) for block in range(1, run.blocks + 1)]
    case.at_least(f"{where}: least area of a piece, over amin", 1, min(areas) / 0.02,
                  "amin" if kind == "rigid" else "amin; strains of 1e-4 before later cracks")
    return run


def check(case):
    text = case.text("rectangle.deck")
    for degrees, shift in cracking.FRAMES:
        rectangle(case, "rigid", text, degrees, shift)
    for degrees, shift in cracking.FRAMES:
        run = rectangle(case, "deformable", deformable(text), degrees, shift)
        if degrees == 0:
            shown = run
    for kind, free in (("rigid", text), ("deformable", deformable(text))):
        free = "".join(line for line in free.splitlines(True) if not line.startswith("PRESSBC"))
        free = with_lines(free, SETVEL="SETVEL, 1, 0, 0, 0, 1000")
        for degrees, shift in cracking.FRAMES:
            run = case.run("rectangle", text=turned(free, degrees, shift))
            case.equal(f"{kind} rectangle, turned by {degrees}, 1000 rad/s without a pull: cracks",
                       0, len(run.cracks), 0, "(9) knows no inertia", absolute=True)
    chart = Chart("Halves of a spinning rectangle", "x, m", "y, m", same_scale=True)
    chart.expected([0.5, 0.5], [0, 2], "5 m/s")
    chart.expected([-0.5, -0.5], [0, -2], "")
    centroids = shown.all("Centroid")[shown.counts == 2]
    for block in (0, 1):
        chart.ours(centroids[:, block, 0], centroids[:, block, 1],
                   f"piece {block + 1}")
    case.chart(chart)

    text = case.text("clamp.deck")
    for kind, of in (("rigid", text), ("deformable", deformable(text))):
        for degrees, shift in cracking.FRAMES:
            run = clamp(case, kind, of, degrees, shift)
            if degrees == 0:
                shown = run
    case.picture(shown)
