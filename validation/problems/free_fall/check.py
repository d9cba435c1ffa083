"""Local damping falsifies flight: falls at (1 - alpha) g, and the path of a thrown block."""

import math

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "quick"
G = 10.0
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
ALPHAS = (0.2, 0.8)


def path(alpha, velocity, times):
    """Places of a block thrown with this velocity. Its direction u, an angle against gravity,
    follows from dv/dt = g - alpha g v / |v|."""
    # dv/dt = -G (alpha + sin u), v du/dt = -G cos u: with small steps of the midpoint rule
    v, at = np.array(velocity), np.zeros(2)
    found, now, dt = [], 0.0, 1e-4

    def rate(v):
        return np.array([0, -G]) - alpha * G * v / np.hypot(*v)

    for t in times:
        while now < t - dt / 2:
            middle = v + dt / 2 * rate(v)
            at, v, now = at + dt * middle, v + dt * rate(middle), now + dt
        found.append(at)
    return np.array(found)


def placed(run, degrees, shift):
    """Path of the block in the frame of the deck."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    x, y = (run.of("Centroid", 1)[:, :2] - shift).T
    return np.array([c * x + s * y, c * y - s * x]).T


def check(case):
    text = case.text("thrown.deck")
    chart = Chart("A block thrown at 10 m/s under local damping", "x, m", "y, m", same_scale=True)
    for alpha in (0.0, *ALPHAS):
        for degrees, shift in FRAMES:
            own = with_lines(text, LOCDAMP=f"LOCDAMP, {alpha}")
            where = f"alpha {alpha:g}, turned by {degrees}"
            run = case.run("thrown", text=turned(own, degrees, shift))
            ours = placed(run, degrees, shift)
            exact = path(alpha, (6, 8), run.times)
            case.equal(f"thrown block, {where}: largest distance from the path", 0,
                       np.hypot(*(ours - exact).T).max(), 3 * G * run.times[-1] * run.dt,
                       "three times the shift of g t dt that the integrator has", "m",
                       absolute=True)
            warned = any("flies" in text for text in run.summary["warnings"])
            case.same(f"thrown block, {where}: the run warns of flight", "yes" if alpha else "no",
                      "yes" if warned else "no", "the block touches nothing")
            if degrees == 0:
                chart.expected(*exact.T, "" if alpha else "by hand")
                chart.ours(*ours[::3].T, f"alpha = {alpha:g}")
            if not alpha:
                continue
            for kind in ("rigid", "deformable"):
                fall = with_lines(own, SETVEL="", PLOTS="PLOTS, 0.1", MOTION="MOTION, 1")
                fall = fall if kind == "rigid" else with_lines(fall, RIGID="")
                run = case.run("thrown", text=turned(fall, degrees, shift))
                t = run.times[-1]
                case.equal(f"fall from rest, {kind}, {where}: acceleration", (1 - alpha) * G,
                           -2 * placed(run, degrees, shift)[-1, 1] / t ** 2, 12 * run.dt / t,
                           "the first two steps: errors of the order dt / t", "m/s2")
    case.chart(chart)
