"""Forces of a block in a notch without friction, with sliding friction, and held by springs."""

from math import atan, cos, radians, sin

import numpy as np
from suite.deck import with_lines
from suite.frames import FRAMES, forces, outlines
from suite.spring_statics import Contact, Statics, section

LENGTH = "quick"
LEFT, RIGHT = radians(55), radians(40)
STIFFNESS, ELASTIC, DENSITY, GRAVITY = (1e9, 1e9), (2e10, 8e9), 2500.0, (0.0, -10.0)
BLOCK, ENDS = 3, ((1, 1), (2, 1), (3, 2), (4, 2))  # the block, and its corners with their faces
# The faces run down to the notch on the left and up on the right, and the block slides down.
ALONG = {1: ((cos(LEFT), -sin(LEFT)), 1), 2: ((cos(RIGHT), sin(RIGHT)), -1)}
STATES = {"no friction": 0.0, "sliding": 0.3, "held": 2.0}  # and their friction
# Of the weight. The four forces at the ends, without friction, change as the block sinks.
TOLERANCE = {"no friction": 1e-5, "sliding": 1e-3, "held": 1e-6}


def by_hand(friction):
    """Returns the normal forces on both faces, of the weight, if the block slides on both."""
    phi = atan(friction)
    left, right = LEFT - phi, RIGHT - phi
    return {1: cos(phi) * sin(right) / sin(left + right),
            2: cos(phi) * sin(left) / sin(left + right)}


def on_springs(outline, state, elastic):
    """Returns the normal and shear forces at the four ends by the linear statics of springs."""
    statics = Statics([outline], elastic)
    statics.add_weight(GRAVITY, DENSITY)
    for corner, face in ENDS:
        along, slides = ALONG[face]
        statics.add_contact(Contact(outline[corner - 1], along, 0, -1, STIFFNESS,
                                    None if state == "held" else slides * STATES[state]))
    return statics.solve()[0]


def ends(run, frame):
    found = forces(run, frame)
    return np.array([found[BLOCK, corner, face] for corner, face in ENDS])


def check(case):
    text = case.text("wedge.deck")
    outline = outlines(text)[BLOCK - 1]
    weight = DENSITY * section(outline)[0] * 10
    for kind in ("rigid", "deformable"):
        deck = text if kind == "rigid" else text.replace("\nRIGID\n", "\n")
        for state, friction in STATES.items():
            one = with_lines(deck, FRICTN=f"FRICTN, {friction}")
            found = [ends(case.run("wedge", text=move(one)), frame)
                     for frame, move in FRAMES.items()]
            if state != "held":
                for face, hand in by_hand(friction).items():
                    normal = [sum(force[0] for end, force in zip(ENDS, ours) if end[1] == face) /
                              weight for ours in found]
                    case.equal(f"{state}, {kind}: normal force on face {face}, of the weight, worst "
                               "of three frames", hand, max(normal, key=lambda n: abs(n - hand)),
                               1e-8 if state == "no friction" else 1e-3,
                               "the ratio of SOLVE" if state == "no friction" else
                               "a little friction is lost as the ramp ends")
            expected = on_springs(outline, state, None if kind == "rigid" else ELASTIC)
            case.at_most(f"{state}, {kind}: largest error of the eight forces at the ends, of the "
                         "weight, three frames", TOLERANCE[state],
                         max(np.abs(ours - expected).max() for ours in found) / weight,
                         "springs shorten by 1e-4 m")
    sudden = with_lines(text, GRAVITY="GRAVITY, 0, -10")
    ours = ends(case.run("wedge", text=sudden), "as drawn")
    case.measured("sliding, rigid, weight at once: normal force on face 1, of that by hand",
                  ours[:2, 0].sum() / weight / by_hand(STATES["sliding"])[1],
                  "the block swings, and friction ends somewhere between its limits")
    case.measured("the same: shear over normal force at the four ends",
                  ", ".join(f"{s / n:.3f}" for n, s in ours), "0.3 by hand")
    case.picture(case.run("wedge.deck"), "--forces", "--zoom", "-3,4,-0.6,3.4")
