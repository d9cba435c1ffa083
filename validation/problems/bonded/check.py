"""Bonded beams, walls and overhangs: where failure begins, and what subdivision buys."""

import numpy as np
from suite.chart import Chart
from suite.deck import polygon, turned, with_lines

LENGTH = "long"
FRAMES = ((0, (0.0, 0.0)), (30, (100.0, 200.0)), (-100, (-50.0, 7.0)))
WEIGHT, KN, FRIC = 25e3, 1e11, 0.5  # N/m3, Pa/m
STEP, COUNT, TIME = 1e-5, 40, 0.005  # the strength falls by STEP of itself, COUNT times
STAIRS = "the strength falls in steps of 1e-5"


def falling(text, exact, card):
    """Returns the deck with a strength that falls in steps around the exact value. card(strength)
    is the JOINT card."""
    head = text.split("MOTION, 0.5")[0]
    stairs = "".join(f"{card(exact * (1 + STEP * (COUNT // 2 - k + 0.5)))}\nMOTION, {TIME}\n"
                     for k in range(COUNT))
    return with_lines(head, PLOTS="PLOTS, 0.5") + f"MOTION, 0.5\nPLOTS, {TIME}\n{stairs}STOP\n"


def tension(strength):
    return f"JOINT, 1, {FRIC}, 1.E8, {strength:.15g}, {FRIC}, 0, 0, , , {KN:g}, {KN:g}"


def cohesion(strength):
    """Much tensile strength, as much as the apex of the envelope allows."""
    return (f"JOINT, 1, {FRIC}, {strength:.15g}, {strength / FRIC * (1 - 1e-12):.15g}, {FRIC}, 0, 0, "
            f", , {KN:g}, {KN:g}")


def limit(case, text, exact, card=tension):
    """The strength at which the first block falls, and the run. NaN if none does, or at once."""
    run = case.run("falling", text=falling(text, exact, card))
    speed = np.hypot(*np.moveaxis(run.all("Velocity")[:, :, :2], 2, 0)).max(axis=1)
    steps = np.round((run.times - 0.5) / TIME).astype(int)  # that have ended
    falls = np.flatnonzero(speed > 1e-3)
    if len(falls) == 0 or steps[falls[0]] < 2:
        return float("nan"), run
    return exact * (1 + STEP * (COUNT // 2 - steps[falls[0]] + 2)), run


CASES = (  # deck, what, where failure begins: tensile strength [Pa]
    ("cantilever", "cantilever of four bricks, 2 m x 1 m", WEIGHT * 2 ** 2),
    ("cantilever_cut", "the same, cut", WEIGHT * 2 ** 2),
    ("supported", "four bricks on points 1.8 m apart", 2 * WEIGHT * (0.9 - 0.5)),
    ("hanging", "hanging wall of bricks, 2 m high", WEIGHT * 2),
    ("hanging_cut", "the same, cut", WEIGHT * 2),
    ("overhang", "slab of 3 m x 1 m, 2 m of it beyond the cliff", WEIGHT * 3 * 0.5 / 0.5))


def subdivided(text, sides, both):
    """The brick, and the wall if `both`, with faces of this number of sides."""
    heights = np.linspace(0, 1, sides + 1)
    brick = polygon([*((0, y) for y in heights), (0.5, 1), (0.5, 0)])
    wall = [(0, y) for y in heights[::-1]] if both else []
    wall = polygon([(-1, -1), (-1, 2), (0, 2), *wall, (0, -1)], True)
    tail = text.split("$ It comes to rest")[1]
    return text.split("CREATE")[0] + wall + brick + "$ It comes to rest" + tail


def check(case):
    for name, what, exact in CASES:
        for degrees, shift in FRAMES:
            text = turned(case.text(name + ".deck"), degrees, shift)
            for kind in ("rigid", "deformable"):
                own = text if kind == "rigid" else with_lines(text, RIGID="")
                ours, run = limit(case, own, exact)
                case.equal(f"{what}, {kind}, turned by {degrees}: tensile strength at which it fails",
                           exact, ours, 1e-5, STAIRS, "Pa")
    text = case.text("cantilever.deck")
    # the upper end of the root has the shear V / 2 and the tension M / L
    exact = 2 * (WEIGHT + FRIC * WEIGHT * 2)
    for degrees, shift in FRAMES:
        ours, _ = limit(case, turned(text, degrees, shift), exact, cohesion)
        case.equal(f"cantilever, rigid, turned by {degrees}: cohesion at which its root shears", exact,
                   ours, 1e-5, STAIRS, "Pa")

    stiff = Chart("Face of 1 m with n sides: rotational stiffness and bending strength", "n",
                  "of the continuum")
    sides, moment = (1, 2, 4, 8), WEIGHT * 0.5 ** 2 / 2
    every = np.linspace(1, 8, 50)
    stiff.expected(every, 1 + 2 / every ** 2, "1 + 2 / n^2")
    found = {"stiffness": [], "strength": []}
    for n in sides:
        for both in (False, True):
            text = subdivided(case.text("subdivided.deck"), n, both)
            factor = 1 + 2 / n ** 2
            exact = moment * 6 / factor
            ours, run = limit(case, turned(text, *FRAMES[1]), exact)
            # The frame at 0.5 s is at rest.
            angle = -run.of("Angle", 2)[run.times < 0.501][-1]
            how = f"{n} sides on {'both blocks' if both else 'the brick'}"
            case.equal(f"{how}: rotational stiffness", KN / 12 * factor, moment / angle, 1e-6,
                       "the springs give by 1e-7 of the size", "N m")
            case.equal(f"{how}: tensile strength at which it fails", exact, ours, 1e-5, STAIRS, "Pa")
        found["stiffness"].append(moment / angle * 12 / KN)
        found["strength"].append(6 * moment / ours)
    for name, values in found.items():
        stiff.ours(sides, values, name)
    case.chart(stiff)
