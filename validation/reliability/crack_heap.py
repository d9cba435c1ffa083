#!/usr/bin/python3
"""A heap of blocks that split thousands of times, audited: crack_heap.py PROGRAM FOLDER.

400 square blocks fall into a bin and break until START allows no more blocks. Every 20 steps all
contacts are decided once more by brute force, in whole numbers. Prints the totals; the exit code is
1 if a decision was wrong, a pair was missed, or there were fewer than 1,000 cracks."""

import json
import math
import random
import subprocess
import sys
from pathlib import Path

BLOCKS, IN_A_ROW, EVERY, LEAST_CRACKS = 400, 18, 20, 1000


def create(corners, fixed=0):
    return [f"CREATE, {len(corners)}, 1, {fixed}", *(", ".join(f"{value:.4f}" for value in row) for row in zip(*corners))]


def deck():
    """Returns the deck, with the same random numbers each time."""
    draw = random.Random(3)
    cards = ["START, 4000, 12", "A HEAP OF BLOCKS THAT SPLIT", "XLIMITS, -2, 26", "YLIMITS, -2, 60",
             "BOXES, 28, 60, .02", "STIFF, 1.E8, 1.E8", "FRACTION, .04", "MATERIAL, 1, 1.E9, 4.E8, 2500", "RIGID", "END"]
    for x0, y0, x1, y1 in ((-1, -1, 21, 0), (-1, 0, 0, 50), (20, 0, 21, 50)):
        cards += create([(x0, y0), (x0, y1), (x1, y1), (x1, y0)], 1)
    for k in range(BLOCKS):
        row, column = divmod(k, IN_A_ROW)
        x, y = 1.1 + 1.02 * column + draw.uniform(-.015, .015), 1 + 1.3 * row
        angle = draw.uniform(-.1, .1)
        c, s = .45 * math.cos(angle), .45 * math.sin(angle)
        cards += create([(x - c + s, y - s - c), (x - c - s, y - s + c), (x + c - s, y + s + c), (x + c + s, y + s - c)])
    return "\n".join([*cards, "FRICTN, .5", "DAMPING, .3", "CRACK, 1, 4.E4, .04, 8.E4", "GRAVITY, 0, -9.81",
                      "OUTPUT, .1", "PLOTS, .1", "MOTION, 1.3", "STOP", ""])


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "heap.deck").write_text(deck(), encoding="utf-8")
    subprocess.run([program, "run", folder / "heap.deck", "-o", folder / "heap", f"--audit={EVERY}", "-q"], check=True)
    summary = json.loads((folder / "heap.summary.json").read_text(encoding="utf-8"))
    cracks, audit = len(summary["cracks"]), summary["audit"]
    print(f"{cracks} cracks; {audit['moments']} audits of {audit['pairs']} pairs and {audit['acting']} acting contacts; "
          f"missed {audit['missed_pairs']}, wrong {audit['wrong_decisions']}, excess {audit['excess_pairs']}, "
          f"deep {audit['deep_contacts']}")
    sys.exit(audit["missed_pairs"] + audit["wrong_decisions"] + audit["excess_pairs"] > 0 or cracks < LEAST_CRACKS)


main()
