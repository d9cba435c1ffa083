"""Direct shear of joints with the laws of Mohr-Coulomb and of Barton and Bandis."""

from math import atan, cos, log10, pi, radians, sin, tan

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "long"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
KS, COH, FRIC, RESIDUAL = 1e10, 5e5, 0.70020753820971, 3 ** -0.5
PEAK, PEAK_SLIP, RISE = COH + FRIC * 1e6, (COH + FRIC * 1e6) / KS, 0.005 * tan(radians(10))
JRC, JCS, PHIR, UPEAK = 10.0, 1e8, 30.0, 0.00427593


class Sheared:
    """The joint between block 1, below, and block 2 over the frames of a run."""

    def __init__(self, run, degrees=0):
        self.times, self.dt, self.summary = run.times, run.dt, run.summary
        c, s = cos(radians(degrees)), sin(radians(degrees))
        way = run.all("Centroid")[:, :, :2] - run.all("Centroid")[0, :, :2]
        below, above = way[:, 0], way[:, 1]
        self.slip = (below - above) @ [c, s]   # [L] of the blocks, the springs included
        self.rise = (above - below) @ [-s, c]  # [L]
        contacts = run.all_contacts()
        joint = contacts["EdgeBlock"] > 0  # otherwise a plane

        def total(name):
            return np.bincount(contacts["Frame"][joint], contacts[name][joint], len(run.times))

        self.normal, self.shear = total("NormalForce"), -total("ShearForce")

    def at(self, time):
        """Index of the last frame until a time."""
        return int(np.searchsorted(self.times, time + 1e-4)) - 1


def dilatant(case, kind, degrees, shift):
    """The whole loop: to the right, back, to the left."""
    text = case.text("box.deck")
    is_rigid = kind == "rigid"
    box = Sheared(case.run("box", text=turned(
        text if is_rigid else with_lines(text, RIGID=""), degrees, shift)), degrees)
    where = f"{kind}, turned by {degrees}"
    pressed, right, back, left = (box.at(t) for t in (0.05, 1.3, 2.573, 3.823))
    case.equal(f"{where}: shear stress after 6 mm", RESIDUAL * box.normal[right], box.shear[right],
               1e-9, "round-off", "Pa")
    risen = box.rise - box.rise[pressed]
    rounds = box.summary["steps"] * np.spacing(np.abs([*shift, 1.0]).max()) / 2 / RISE
    for name, frame in (("6 mm to the right", right), ("6 mm to the left", left)):
        case.equal(f"{where}: rise after {name}", RISE, risen[frame], rounds if is_rigid else 1e-5,
                   "every step of a driven block may round its coordinates in the same direction"
                   if is_rigid else "the loaded side is 2e-5 longer under stress, and so the load",
                   "m")
    plastic = box.slip - box.shear / KS
    case.equal(f"{where}: rise after sliding back to the start",
               tan(radians(10)) * abs(plastic[back]), risen[back],
               1e-9 if is_rigid else tan(radians(10)) * 3e-5,
               "of a slip that ends within a step of 0" if is_rigid else
               "under stress both ends do not slide by the same amount: strain 3e-5 in 1 m", "m",
               absolute=True)
    return box, risen, pressed


def peak(case, degrees, shift):
    """Shear force and slip at the peak, reached more and more slowly. The springs of the plane and
    of the joint are in series, so the driven block moves twice as far as the joint slips."""
    text = case.text("box.deck").split("$ 6 mm to the right")[0]
    rest = "DRIVE, 1, 0, 0\nMOTION, 0.02\n"
    text += (f"DRIVE, 1, 0.005, 0\nMOTION, 0.0432\n{rest}DRIVE, 1, 2E-4, 0\nMOTION, 0.1176\n{rest}"
             "PLOTS, 5E-5\nDRIVE, 1, 2E-6, 0\nMOTION, 0.3\nSTOP\n")
    box = Sheared(case.run("peak", text=turned(text, degrees, shift)), degrees)
    top = int(np.argmax(box.shear))
    because = "the dashpot carries 4 N, and the drive moves 0.1 nm from frame to frame"
    for what, exact, ours, unit in (("peak of the shear stress", PEAK, box.shear[top], "Pa"),
                                    ("slip at the peak", PEAK_SLIP, box.slip[top], "m")):
        case.equal(f"turned by {degrees}: {what}", exact, ours, 1e-5, because, unit)


class Held:
    """Runs of a joint between a fixed and a driven block: motions of the blocks and what then acts
    on the joint, exactly."""

    def __init__(self, case, text, degrees, shift):
        self.case, self.degrees, self.shift = case, degrees, shift
        self.head = text.split("$ 0.1 mm in 0.01 s")[0]
        self.dt = case.run("held", text=self.head + "CYCLE, 1\nSTOP\n").dt

    def after(self, *motions, more=0):
        """Each motion is (closing, slip) [L], made in a thousand steps; the first has `more`."""
        count, lines = 1000, []
        for closing, slip in motions:
            time = count * self.dt
            lines += [f"DRIVE, 1, {slip / time:.17g}, 0", f"DRIVE, 2, 0, {-closing / time:.17g}",
                      f"CYCLE, {count + more}"]
            more = 0
        text = with_lines(self.head, PLOTS="PLOTS, 1") + "\n".join([*lines, "STOP", ""])
        run = self.case.run("held", text=turned(text, self.degrees, self.shift))
        box = Sheared(run, self.degrees)
        return box.normal[-1], box.shear[-1]


def held(case, kind, degrees, shift):
    """The joint is closed by 0.1 mm and then sheared while its top is held."""
    text = case.text("held.deck")
    joint = Held(case, text if kind == "rigid" else with_lines(text, RIGID=""), degrees, shift)
    where, exact = f"top held, {kind}, turned by {degrees}", "round-off"
    below = joint.after((1e-4, 0), (0, PEAK_SLIP * (1 - 1e-9)))
    case.equal(f"{where}: normal stress before the peak", 1e6, below[0], 1e-9, exact, "Pa")
    case.equal(f"{where}: shear stress, slip 1e-9 below the peak", PEAK * (1 - 1e-9), below[1],
               2e-10, exact, "Pa")
    above = joint.after((1e-4, 0), (0, PEAK_SLIP * (1 + 1e-9)))
    case.at_most(f"{where}: shear stress, slip 1e-9 beyond the peak, of the peak", 0.9,
                 above[1] / PEAK, "it has failed")
    normal = 1e6 + KS * RISE
    far = joint.after((1e-4, 0), (0, 6.5e-3))
    case.equal(f"{where}: FN after 6.5 mm", normal, far[0], 1e-9, exact, "N")
    case.equal(f"{where}: FS after 6.5 mm", RESIDUAL * normal, far[1], 1e-9, exact, "N")
    start = -RESIDUAL * 1e6 / KS  # where the plastic slip is 0
    # Dilation acts one step later, so the joint then moves by a picometre in a thousand steps.
    back = joint.after((1e-4, 0), (0, 6.5e-3), (0, start - 6.5e-3), (0, -1e-12))
    case.equal(f"{where}: FN after sliding back", 1e6, back[0], 1e-7,
               "the last picometre", "N")


def closure(case, kind, degrees, shift):
    """Bandis' closure, kni 10 GPa/m and vm 0.2 mm."""
    text = case.text("held.deck").replace("BOND, 1\n", "")
    text = with_lines(text, JOINT="JOINT, 1, , , , , , , , , , 1.E10\n"
                      "BARTON, 1, 10, 1.E8, 30, 0.00427593, 1.E10, 0.0002, 1.E12")
    joint = Held(case, text if kind == "rigid" else with_lines(text, RIGID=""), degrees, shift)
    where = f"Bandis, {kind}, turned by {degrees}"
    exact = "the first overlap is a difference of coordinates up to 200 m: 2e-13 m"
    at, little = 1e-4, 1e-8

    def stress(*closings):
        """A contact acts from the step on in which its corner is inside the edge: the second one."""
        return joint.after(*((v, 0) for v in closings), more=1)[0]

    case.equal(f"{where}: stress at a closure of 0.1 mm", 2e6, stress(at), 2e-8, exact, "Pa")
    tangent = (stress(at + little) - stress(at - little)) / (2 * little)
    case.equal(f"{where}: tangent at 2 MPa", 4e10, tangent, 2e-5,
               "the same, over 20 nm", "Pa/m")
    for part in (0.25, 0.75, 0.88):
        v = part * 2e-4
        case.equal(f"{where}: stress at a closure of {v * 1e3:g} mm", 1e10 * v / (1 - part),
                   stress(v), 2e-8, exact, "Pa")
    case.equal(f"{where}: after closing by 0.15 mm and opening by 0.05 mm", 2e6,
               stress(1.5e-4, -0.5e-4), 2e-8, exact, "Pa")


def mobilised(u):
    """JRCm / JRC for u >= 0.3."""
    return np.interp(u, [0.3, 0.6, 1, 2, 4, 10, 100], [0, 0.75, 1, 0.85, 0.7, 0.5, 0])


def angle(u, stress):
    """The angle in degrees that roughness adds to phir at a slip of u peak slips."""
    grown = JRC * log10(JCS / stress) * mobilised(u)
    return np.where(u < 0.3, PHIR * (u / 0.3 - 1), grown)


def shear_strength(u, stress):
    return stress * np.tan(np.radians(PHIR + angle(u, stress)))


def rise_of(slip, stress, stiffness):
    """Rise by dilation: the integral of tan(A / 2) over the plastic slip."""
    u = np.linspace(0, slip, 400001)
    plastic = u - shear_strength(u / UPEAK, stress) / stiffness
    slope = np.tan(np.radians(np.maximum(angle(u / UPEAK, stress), 0)) / 2)
    return np.concatenate([[0], np.cumsum(0.5 * (slope[1:] + slope[:-1]) * np.diff(plastic))]), u


def at_slip(box, slip):
    """The shear force at a slip, by a cubic through the frames just before it."""
    before = (box.slip > 0.93 * slip) & (box.slip <= slip)
    x = box.slip[before] / slip - 1
    return np.polyval(np.polyfit(x, box.shear[before], 3), 0.0)


def rough(case, stress, degrees, shift, kind="rigid"):
    """A joint with JRC 10, JCS 100 MPa and phir 30 degrees to beyond twice the peak slip."""
    pressure = 1.25 * stress
    text = case.text("rough.deck").replace("1.25E6, 1.25E6", f"{pressure:g}, {pressure:g}")
    if kind == "deformable":
        text = with_lines(text, RIGID="", MATERIAL="MATERIAL, 1, 2.E12, 1.E12, 2000")
    box = Sheared(case.run("rough", text=turned(text, degrees, shift)), degrees)
    where = f"{stress / 1e6:g} MPa, {kind}, turned by {degrees}"
    quiet = "mass times the acceleration of the rise adds to the normal stress"
    within = 1e-5
    if kind == "deformable":
        quiet, within = "strain 1e-6 in 1 m: both ends do not slip by the same amount", 1e-3
    for slips in (1, 2):
        tau = at_slip(box, slips * UPEAK)
        where_at = f"{where}, slip {slips} upeak"
        case.equal(f"{where_at}: shear stress", float(shear_strength(slips, stress)), tau, within,
                   quiet, "Pa")
        case.equal(f"{where_at}: angle", PHIR + float(angle(slips, stress)),
                   180 / pi * atan(tau / stress), within, quiet, "degrees")
    rises, slips = rise_of(2 * UPEAK, stress, 1e11)
    shown = (box.slip > 0.05 * UPEAK) & (box.slip < 2 * UPEAK)
    pressed = box.at(0.05)
    ours = box.rise - box.rise[pressed]
    case.equal(f"{where}: rise, largest error until 2 upeak", 0,
               np.abs(ours - np.interp(box.slip, slips, rises))[shown].max(),
               2e-7, "the dashpot carries up to 1 % of the load while the block rises", "m",
               absolute=True)
    off = box.shear[shown] / shear_strength(box.slip[shown] / UPEAK, stress) - 1
    slides = box.shear[shown] < 0.99 * 1e11 * box.slip[shown]
    case.equal(f"{where}: shear stress, largest error until 2 upeak", 0, np.abs(off[slides]).max(),
               10 * within, "the block swings as the drive begins", absolute=True)
    return box, ours


def check(case):
    title = "Mohr-Coulomb: a joint of 1 m under 1 MPa, to 6 mm, back, and to -6 mm"
    stress = Chart(title, "slip, mm", "shear stress, MPa")
    rise = Chart(title, "slip, mm", "rise, mm")
    for degrees, shift in FRAMES:
        peak(case, degrees, shift)
        box, risen, pressed = dilatant(case, "rigid", degrees, shift)
        dilatant(case, "deformable", degrees, shift)
    slip = 1e3 * box.slip[pressed:]
    for strength in (PEAK, 1e6 * RESIDUAL, -1e6 * RESIDUAL):
        stress.expected([-6, 6], [1e-6 * strength] * 2, "")
    stress.ours(slip, 1e-6 * box.shear[pressed:], "", line=True)
    rise.expected([-6, 6], [1e3 * RISE] * 2, "")
    rise.ours(slip, 1e3 * risen[pressed:], "", line=True)
    case.chart(stress)
    case.chart(rise)

    stresses = Chart("Barton: shear stress, JRC 10, JCS 100 MPa, phir 30 degrees", "slip, mm",
                     "shear stress / normal stress")
    rises = Chart("Barton: rise, JRC 10, JCS 100 MPa, phir 30 degrees", "slip, mm", "rise, mm")
    for normal in (1e6, 1e7, 1e8):
        for degrees, shift in FRAMES:
            box, ours = rough(case, normal, degrees, shift)
        rough(case, normal, *FRAMES[1], kind="deformable")
        u = np.linspace(0, 2.2 * UPEAK, 400)
        stresses.expected(1e3 * u, shear_strength(u / UPEAK, normal) / normal, "")
        opening, at = rise_of(2.2 * UPEAK, normal, 1e11)
        rises.expected(1e3 * at[::2000], 1e3 * opening[::2000], "")
        few = slice(box.at(0.05), None, 12)
        stresses.ours(1e3 * box.slip[few], box.shear[few] / normal, f"{normal / 1e6:g} MPa")
        rises.ours(1e3 * box.slip[few], 1e3 * ours[few], f"{normal / 1e6:g} MPa")
    case.chart(stresses)
    case.chart(rises)

    for kind in ("rigid", "deformable"):
        for degrees, shift in FRAMES:
            held(case, kind, degrees, shift)
            closure(case, kind, degrees, shift)
