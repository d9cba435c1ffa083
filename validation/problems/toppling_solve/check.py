"""The slope of Goodman and Bray by SOLVE: limit friction, support force, and steps."""

from math import atan, cos, degrees, radians, sin, tan

from suite.numbers import bisect
from suite.toppling import DIP, HEIGHT, UNIT, WIDTH, between, equilibrium

LENGTH = "long"
SOLVE = "SOLVE, 1.E-5, 20000\n"
SUPPORTED = 0.65  # friction coefficient of the supported slope
TOE = 1  # the lowest column


def scene(case):
    """Returns the blocks of the problem goodman_bray, without dashpots and what follows them."""
    text = case.text("validation/problems/goodman_bray/goodman_bray.deck")
    text = text[:text.index("FRICTN")].replace("FRACTION, 0.03", "FRACTION, 0.1")
    return text.replace("RIGID\n", "FUNCTION, 1\n0, 1\nRIGID\n") + "LOCDAMP, 0.8\nFRICTN, 2\n" + SOLVE


def deformable_scene(text):
    """Returns the scene with blocks that deform less than their joints."""
    return text.replace("\nRIGID\n", "\n").replace("1.E7, 4.E6", "1.E8, 4.E7")


def lowered(phi, gradual):
    """Returns the cards that lower friction to phi degrees, in stages or at once."""
    stages = [45, 42, 40, 39, 38.6, 38.4, 38.3, 38.2] if gradual else []
    return "".join(f"FRICTN, {tan(radians(angle)):.15g}\n{SOLVE}"
                   for angle in [*(angle for angle in stages if angle > phi), phi])


def unloaded(support):
    """Returns the cards that lower the horizontal support of the toe from 2400 kN/m in stages."""
    stages = [2400, *range(2300, 0, -50)]
    stages = [*(stage for stage in stages if stage > support), support]
    cards = ""
    for before, now in zip([0, *stages], stages):
        push = now - before
        cards += f"FORCE, {TOE}, {push * cos(DIP):.15g}, {-push * sin(DIP):.15g}\n"
        cards += f"FRICTN, {SUPPORTED}\n" if before == 0 else ""
        cards += SOLVE
    return cards


def support_by_hand():
    """Returns the horizontal force on the toe with which it just does not slide."""
    phi = degrees(atan(SUPPORTED))
    weight = HEIGHT[TOE] * WIDTH * UNIT
    down = equilibrium(phi)[0][2] * (1 - SUPPORTED**2)
    return ((down - weight * (cos(DIP) * SUPPORTED - sin(DIP))) /
            (SUPPORTED * sin(DIP) + cos(DIP)))


def check(case):
    start = scene(case)

    def run(cards, scene_text=start):
        return case.run("toppling_solve", text=scene_text + cards + "STOP\n")

    def gives_way(done):
        return "has not converged" in done.log

    def limit(gradual, scene_text=start):
        """Returns the limit friction angle and the steps of all runs of the bisection."""
        steps = []

        def fails(phi):
            done = run(lowered(phi, gradual), scene_text)
            steps.append(done.summary["steps"])
            return gives_way(done)
        return bisect(fails, 37, 39, 0.02), sum(steps)

    expected = bisect(lambda phi: equilibrium(phi)[0][1] > 0, 35, 42, 1e-4)
    soft, soft_steps = limit(True)
    sudden, sudden_steps = limit(False)
    deformable, _ = limit(False, deformable_scene(start))
    for what, angle in (("in stages", soft), ("at once", sudden), ("at once, deformable", deformable)):
        case.equal(f"limit friction angle, friction lowered {what}", expected, angle, 0.02,
                   "the bisection ends at 0.02", "degrees", absolute=True)
    by_hand = support_by_hand()
    case.equal("support of the toe at tan phi = 0.65 by the recursion, against the published one",
               2013, by_hand, 1, "published without digits", "kN/m", absolute=True)
    ours = bisect(lambda force: gives_way(run(unloaded(force))), 1800, 2200, 10)
    case.equal("the same by SOLVE: the least support with which the slope holds", by_hand, ours,
               0.005, "the bisection ends at 10 kN/m", "kN/m")
    held = run(lowered(soft + 0.03, True))
    force, now = equilibrium(expected)[0], between(held, -1)
    for n in range(13, 1, -1):
        case.equal(f"force between columns {n} and {n - 1}, 0.03 degrees above the limit", force[n],
                   now[n], 0.01, "in the uppermost columns friction is not yet at its limit",
                   "kN/m")
    in_time = case.run("goodman_bray", text=case.text(
        "validation/problems/goodman_bray/goodman_bray.deck"))
    steps = in_time.summary["steps"]
    case.measured("steps of one run in time (goodman_bray)", str(steps),
                  "8 s to settle, and 12 s to see whether the slope holds")
    for angle in (39.0, 38.3):
        done = run(lowered(angle, False))
        case.measured(f"steps of one run by SOLVE, friction lowered to {angle:g} degrees at once",
                      f"{done.summary['steps']}, 1 / {steps / done.summary['steps']:.0f}",
                      "near the limit the columns turn slowly until friction is mobilised")
    case.measured("steps of the nine runs of the bisection: in time; by SOLVE in stages; at once",
                  f"{9 * steps}; {soft_steps}; {sudden_steps}", "most are those of slopes that fail")
