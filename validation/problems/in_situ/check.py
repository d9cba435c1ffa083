"""Stress in the ground: equilibrium on every tiling from the first step on, and after a removal."""

import numpy as np
from suite.deck import rectangle, turned, with_lines

LENGTH = "long"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
GRAVITY = 10.0
DECKS = (("voronoi", "80 Voronoi cells"), ("layers", "merged, oriented layers with T-junctions"),
         ("joints", "two joint sets"))
STIFFNESS = "JOINT, 7, .9, , , , , , , , 1.E9, 5.E8\nJPAIR, 1, 1, 7\n"
LAWS = (("kn", STIFFNESS), ("WALTON", STIFFNESS.replace("JPAIR", "WALTON, 7, .5\nJPAIR")),
        ("bonded", STIFFNESS.replace(".9, , ", ".9, 1.E5, 5.E4") + "BOND, 7\n"))
ROUNDING = "round-off"


def ratio(run, gravity):
    """The unbalanced forces of the first step over all forces, from the velocities after it."""
    mass, inertia, free = (run.all(name)[-1] for name in ("Mass", "Inertia", "Fixed"))
    free = free == 0
    arm = np.sqrt(inertia / mass)
    forces = mass * np.hypot(*run.all("Velocity")[-1].T[:2]) + inertia * abs(run.all("Spin")[-1]) / arm
    rest = forces / run.dt
    if np.any(run.all("Stress")[-1]):
        applied, stress = run.all("AppliedStress")[-1], run.all("Stress")[-1]
        left = applied - stress
        left[:, 1:3] = left[:, 1:3].mean(axis=1, keepdims=True)
        rest = rest + run.all("Area")[-1] * np.linalg.norm(left, axis=1) / arm
    contacts = run.contacts(-1)
    every = np.hypot(contacts["NormalForce"], contacts["ShearForce"]).sum()
    return rest[free].sum() / (every + mass[free].sum() * gravity)


def speed(run):
    """The largest speed after the run [L/T]."""
    assert run.times[-1] > 0
    return np.hypot(*run.all("Velocity")[-1].T[:2]).max()


def check(case):
    def rest(text, what, gravity):
        first = case.run("first", text=text.replace("CYCLE, 999\n", ""))
        case.at_most(f"{what}: unbalanced force ratio of the first step", 1e-12,
                     ratio(first, gravity), ROUNDING)
        case.at_most(f"{what}: largest speed after 1000 steps", 1e-12,
                     speed(case.run("rest", text=text)), ROUNDING, "m/s")

    for name, what in DECKS:
        deck = case.text(name + ".deck")
        for kind, text in (("rigid", deck), ("deformable", with_lines(deck, RIGID=""))):
            for seed in (1, 2, 3):
                rest(with_lines(text, SEED=f"SEED, {seed}"),
                     f"{what}, seed {seed}, {kind}, gravity and K0 = .5", GRAVITY)
            # The same stress everywhere, which the lid carries too.
            uniform = with_lines(text, GRAVITY="GRAVITY, 0, 0", INSITU="INSITU, -1.E5, -2.E5, 4.E4")
            uniform = uniform.replace("$ The frame is fixed.\n",
                                      "$ The frame is fixed.\n" + rectangle(-1, 10, 11, 11, True))
            for degrees, shift in FRAMES:
                rest(turned(uniform, degrees, shift),
                     f"{what}, {kind}, uniform stress with shear, turned by {degrees}", 0.0)
    for law, cards in LAWS:
        rest(case.text("voronoi.deck").replace("FRICTN", cards + "FRICTN"),
             f"80 Voronoi cells, {law}, gravity and K0 = .5", GRAVITY)
    for name, what in DECKS[:2]:
        text = case.text(name + ".deck").replace("FRACTION, .03", "FRACTION, .02")
        text = text.replace("CYCLE, 999\n", "LOCDAMP, .8\nDAMPING, .1\nREMOVE, 20, 22\n"
                                            "SOLVE, 1.E-6, 50000\n")
        run = case.run("removed", text=text)
        energy = run.summary["energy"]
        case.at_most(f"{what}, three blocks removed: energy lost in transfers of springs, of the "
                     "energy of all springs", 1e-3, abs(energy["transfer"]) / energy["start"],
                     "no force is lost by corners that part")
    case.picture(run, "--colour", "displacement")
