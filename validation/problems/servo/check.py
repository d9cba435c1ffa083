"""A servo holds the normal stress on a side: on a fixed block, in direct shear, and in a biaxial
test."""

from math import radians, tan

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
GAIN = 0.5  # servo_gain of src/dynamics/servo.hpp
KN, KS, COH, FRIC, RESIDUAL = 1e10, 1e10, 5e5, 0.70020753820971, 3 ** -0.5
PEAK = COH + FRIC * 1e6
DILATION, RISE = tan(radians(10)), 0.005 * tan(radians(10))
JRC, JCS, PHIR, UPEAK = 10.0, 1e8, 30.0, 0.00427593


def kinds(text):
    """The deck with rigid and with deformable blocks."""
    return (("rigid", text), ("deformable", with_lines(text, RIGID="")))


def back(vectors, degrees):
    """Vectors in the frame that is not turned."""
    c, s = np.cos(radians(degrees)), np.sin(radians(degrees))
    x, y = vectors[..., 0], vectors[..., 1]
    return np.stack([c * x + s * y, -s * x + c * y], axis=-1)


def geometric(case, kind, text, degrees, shift):
    """A plate on a fixed block. The velocity in a frame is proportional to the error in its step."""
    for damping in ("0", "0.3"):
        where = f"plate, {kind}, DAMPING {damping}, turned by {degrees}"
        run = case.run("plate", text=turned(with_lines(text, DAMPING=f"DAMPING, {damping}"),
                                            degrees, shift))
        force = back(run.of("Force", 2)[:, :2], degrees)[:, 1]
        speed = -back(run.of("Velocity", 2)[:, :2], degrees)[:, 1]
        limited = speed > 0.199
        error = speed[~limited & (speed > 1e-6)]
        ratios = error[1:] / error[:-1]
        case.at_least(f"{where}: steps that are compared", 10, len(ratios), "")
        case.equal(f"{where}: error of the stress, from one step to the next, largest deviation",
                   1 - GAIN, ratios[np.abs(ratios - (1 - GAIN)).argmax()], 1e-6,
                   "coordinates up to 200 m")
        case.equal(f"{where}: force after 120 steps", 2e6, force[-1], 1e-9, "round-off", "N")


class Sheared:
    """Stress, slip and rise of the joint between block 1, driven, and block 2, under a servo."""

    def __init__(self, run, degrees):
        way = back(run.all("Centroid")[:, :, :2] - run.all("Centroid")[0, :, :2], degrees)
        force = back(run.of("Force", 2)[:, :2], degrees)
        pressed = np.searchsorted(run.times, 0.02 + 1e-9) - 1
        self.normal, self.shear = force[pressed:, 1], force[pressed:, 0]
        self.slip = (way[:, 0, 0] - way[:, 1, 0])[pressed:]
        self.rise = (way[:, 1, 1] - way[pressed, 1, 1])[pressed:]
        self.speed = back(run.of("Velocity", 1)[-1, :2], degrees)[0]
        self.dt = run.dt


def shear(case, kind, text, degrees, shift):
    """Mohr-Coulomb with dilation at constant normal stress."""
    where = f"Mohr-Coulomb, {kind}, turned by {degrees}"
    box = Sheared(case.run("shear", text=turned(text, degrees, shift)), degrees)
    bound = box.speed * DILATION * KN * box.dt * (1 - GAIN) / GAIN
    before = box.slip < PEAK / KS
    case.equal(f"{where}: normal force before the peak", 1e6,
               box.normal[before][np.abs(box.normal[before] - 1e6).argmax()], 1e-9, "round-off", "N")
    rises = (box.slip > 2e-4) & (box.slip < 0.0049)
    case.equal(f"{where}: normal force while the joint rises, above 1 MN", bound,
               float(np.mean(box.normal[rises] - 1e6)), 1e-3,
               "speed of the rise times k dt (1 - gain) / gain", "N")
    case.at_most(f"{where}: the largest error of the normal force then, of 1 MN", 1.001 * bound / 1e6,
                 np.abs(box.normal[rises] / 1e6 - 1).max(), "the same")
    level = (box.slip > 0.0052)
    case.equal(f"{where}: normal force beyond zdil", 1e6,
               box.normal[level][np.abs(box.normal[level] - 1e6).argmax()], 1e-9, "round-off", "N")
    case.equal(f"{where}: shear force beyond zdil", RESIDUAL * 1e6, box.shear[-1], 1e-9,
               "round-off", "N")
    case.equal(f"{where}: rise", RISE, box.rise[-1], 1e-6,
               "the slip begins within a step", "m")
    return box


def peak(case, kind, text, degrees, shift):
    """The peak, in steps of 4 nm."""
    text = text.split("DRIVE, 1")[0]
    text = with_lines(text, PLOTS="PLOTS, 0.01")
    text += ("DRIVE, 1, 0.1, 0\nMOTION, 0.0011\nPLOTS, 1E-9\nDRIVE, 1, 2E-4, 0\nMOTION, 0.06\n"
             "STOP\n")
    box = Sheared(case.run("peak", text=turned(text, degrees, shift)), degrees)
    top = int(np.argmax(box.shear))
    where = f"Mohr-Coulomb, {kind}, turned by {degrees}"
    because = "the drive moves 3e-5 of the slip from step to step"
    case.equal(f"{where}: peak of the shear force", PEAK, box.shear[top], 5e-5, because, "N")
    case.equal(f"{where}: slip at the peak", PEAK / KS, box.slip[top], 5e-5, because, "m")


def mobilised(u):
    """JRCm / JRC for u >= 0.3."""
    return np.interp(u, [0.3, 0.6, 1, 2, 4, 10, 100], [0, 0.75, 1, 0.85, 0.7, 0.5, 0])


def angle(u):
    """The angle in degrees that roughness adds to phir under 1 MPa."""
    return np.where(u < 0.3, PHIR * (u / 0.3 - 1), JRC * np.log10(JCS / 1e6) * mobilised(u))


def strength(u):
    return 1e6 * np.tan(np.radians(PHIR + angle(u)))


def rough(case, kind, text, degrees, shift):
    """Barton and Bandis at constant normal stress, to twice the peak slip."""
    text = text.replace("BOND, 1\n", "")
    text = with_lines(text, JOINT="JOINT, 1, , , , , , , , , , 1.E11\n"
                      f"BARTON, 1, {JRC:g}, {JCS:g}, {PHIR:g}, {UPEAK:g}, 1.E10, 0.0005, 1.E11")
    box = Sheared(case.run("rough", text=turned(text, degrees, shift)), degrees)
    where = f"Barton, {kind}, turned by {degrees}"
    # The closure at 1 MPa has the tangent kni (1 + s / (vm kni))^2.
    tangent = 1e10 * (1 + 1e6 / (0.0005 * 1e10)) ** 2
    steepest = tan(radians(20 / 2))  # the largest angle of roughness is 20 degrees
    bound = box.speed * steepest * tangent * box.dt / GAIN
    shown = (box.slip > 0.05 * UPEAK) & (box.slip < 2 * UPEAK)
    case.at_most(f"{where}: the largest error of the normal force, of 1 MN", 1.01 * bound / 1e6,
                 np.abs(box.normal[shown] / 1e6 - 1).max(),
                 "speed of the rise times the tangent of the closure times dt / gain")
    slides = box.slip > 0.3 * UPEAK
    off = box.shear[slides & shown] / strength(box.slip[slides & shown] / UPEAK) - 1
    case.equal(f"{where}: shear strength until 2 upeak, largest error", 0, np.abs(off).max(),
               2 * bound / 1e6 + 1e-4, "the error of the normal force", absolute=True)
    return box


def plates(run, degrees):
    """Force of the specimen on the plate at the right, outwards, and on the one above."""
    right = back(run.of("Force", 3)[:, :2], degrees)[:, 0]
    above = back(run.of("Force", 4)[:, :2], degrees)[:, 1]
    return right, above


def bricks(case, kind, text, degrees, shift):
    """Bricks in running bond: stress held while the other axis moves."""
    run = case.run("bricks", text=turned(text, degrees, shift))
    right, above = plates(run, degrees)
    where = f"bricks, {kind}, turned by {degrees}"
    pressed = np.searchsorted(run.times, 0.3 + 1e-9) - 1
    case.equal(f"{where}: stress at the right under two servos", 5e5, right[pressed] / 1.4, 1e-3,
               "the swing that is left", "Pa")
    case.equal(f"{where}: stress above under two servos", 1e6, above[pressed] / 1.9, 1e-3,
               "the swing that is left", "Pa")
    later = run.times > 0.31
    worst = right[later][np.abs(right[later] / 1.4 - 5e5).argmax()] / 1.4
    case.equal(f"{where}: stress at the right while the top is driven, largest error", 5e5, worst,
               1e-3, "bricks that move carry their inertia", "Pa")
    case.at_least(f"{where}: stress above at the end", 1.2e6, above[-1] / 1.9, "it is driven")


def wedges(case, kind, text, degrees, shift):
    """Two joints at 60 degrees with 30 degrees of friction."""
    run = case.run("wedges", text=turned(text, degrees, shift))
    right, above = plates(run, degrees)
    where = f"wedges, {kind}, turned by {degrees}"
    slides = run.times > 1.25
    speed = float(np.mean(back(run.of("Velocity", 3)[slides, :2], degrees)[:, 0]))
    case.equal(f"{where}: speed of the plate at the right while the joint slides",
               0.002 / tan(radians(60)), speed, 1e-3, "the blocks still settle", "m/s")
    case.equal(f"{where}: force at the right then, above 2 MN", speed * 2 * KN * run.dt / GAIN,
               float(np.mean(right[slides])) - 2e6, 1e-2,
               "the lag: speed of the plate times k dt / gain", "N")
    case.equal(f"{where}: force above while the joint slides", 2e6 / tan(radians(60 - 30)),
               float(np.mean(above[slides])), 1e-3, "the lag of the servo and dashpots", "N")
    return run, right, above


def check(case):
    for kind, text in kinds(case.text("plate.deck")):
        for degrees, shift in FRAMES:
            geometric(case, kind, text, degrees, shift)
    chart = Chart("Direct shear under a servo at 1 MPa", "slip, mm", "stress, MPa")
    for kind, text in kinds(case.text("shear.deck")):
        for degrees, shift in FRAMES:
            peak(case, kind, text, degrees, shift)
            box = shear(case, kind, text, degrees, shift)
            worn = rough(case, kind, text, degrees, shift)
    u = np.linspace(0, 0.009, 400)
    chart.expected([0, 9], [1e-6 * RESIDUAL * 1e6] * 2, "")
    chart.expected(1e3 * u, 1e-6 * strength(u / UPEAK), "")
    for one, name in ((box, "Mohr-Coulomb"), (worn, "Barton")):
        few = slice(0, None, 2)
        chart.ours(1e3 * one.slip[few], 1e-6 * one.shear[few], name)
    chart.ours(1e3 * worn.slip[::2], 1e-6 * worn.normal[::2], "normal")
    case.chart(chart)
    for kind, text in kinds(case.text("bricks.deck")):
        for degrees, shift in FRAMES:
            bricks(case, kind, text, degrees, shift)
    chart = Chart("Biaxial test: joints at 60 degrees, 30 degrees of friction", "time, s",
                  "force, MN")
    for kind, text in kinds(case.text("wedges.deck")):
        for degrees, shift in FRAMES:
            run, right, above = wedges(case, kind, text, degrees, shift)
    chart.expected([0.3, 1.5], [2 / tan(radians(30))] * 2, "")
    chart.ours(run.times, 1e-6 * right, "right", line=True)
    chart.ours(run.times, 1e-6 * above, "above", line=True)
    case.chart(chart)
