"""Overlaps and stillness of blocks at rest, in turned frames."""

import numpy as np
from suite.deck import turned

LENGTH = "quick"
K, G, RHO = 1e7, 10.0, 2000.0
FRAMES = ((0, (0, 0)), (17, (3, 4)), (45, (1e3, -2e3)), (90, (0, 0)), (133, (-500, 700)),
          (260, (1e4, 1e4)))


def check(case):
    deck = case.text("resting.deck")
    runs = [case.run("resting", text=turned(deck, *frame)) for frame in FRAMES]

    def worst(expected, ours):
        return max(np.abs(ours(run) / expected - 1).max() for run in runs)

    over = f"largest error over {len(FRAMES)} frames"
    because = "1e4 from the origin an overlap of 5e-4 m is known to 2e-12 / 5e-4"
    box = RHO * G / (2 * K)
    case.equal(f"box: W / (2 K) = {box:g} m, {over}", 0,
               worst(box, lambda run: run.overlap(2, 1)), 1e-7, because, absolute=True)
    weight = RHO * G * 0.54
    lean = weight / K * np.array([7, 5]) / 12  # Corner 1 is on the left, corner 3 on the right.
    case.equal(f"triangle: 7/12 and 5/12 of W / K, {over}", 0,
               worst(lean, lambda run: run.overlap(3, 1)), 1e-3,
               "the triangle leans by its own overlaps, 1e-4", absolute=True)
    pyramid = RHO * G * 1.5 / K
    case.equal(f"pyramid: sum of the floor's overlaps, {over}", 0, worst(
        pyramid, lambda run: np.array([run.overlap(b, 1).sum() for b in (4, 5)]).sum()),
        1e-6, because, absolute=True)
    wall = RHO * G * 8 / K
    case.equal(f"wall: sum of the floor's overlaps, {over}", 0, worst(
        wall, lambda run: np.array([run.overlap(b, 1).sum() for b in range(7, 11)]).sum()),
        1e-6, because, absolute=True)
    case.equal(f"largest speed at the end, {over.replace('error ', '')}", 0,
               max(np.abs(run.all("Velocity")[-1]).max() for run in runs), 1e-9,
               "swings die out within the 1.5 s", "m/s", absolute=True)
    stack = case.run("decks/stack/stack.deck")
    sunk = 0.25 + 0.5 * np.arange(6) - stack.all("Centroid")[-1, 1:7, 1]
    expected = np.cumsum([30, 12.5, 10, 7.5, 5, 2.5]) * 1e3 / 1e8
    for b in (0, 5):
        case.equal(f"aligned stack of six: brick {b + 1} from below has sunk", expected[b], sunk[b],
                   1e-4, "the last swings of six bricks after 2 s", "m")
    bounced = case.run("decks/bounce/bounce.deck")
    case.equal("decks/bounce at its end: overlap of the first square", 2000 * 9.81 / 2e7,
               bounced.overlap(2, 1)[0], 1e-9, "swings die out within 3 s", "m")
    case.picture(runs[1], "--colour", "speed", "--width", 700)
