#!/usr/bin/python3
"""Finds friction with SciPy: that at which a block just slides, and that of a measured displacement.

1. A block is on a slope of 30 degrees. Bisection finds the friction at which it begins to slide. Theory:
   tan 30 degrees.
2. A jointed slope (decks/slope) has moved by a known distance within 0.8 s. Which friction angle has it?
   Here the "measured" distance is that of a run with 23 degrees, so the answer is known.

    python3 slope_friction.py [folder of the decks]       exit code 1: an answer is wrong
"""

import math
import sys
from pathlib import Path

import numpy as np
from scipy.optimize import bisect, brentq

import blocks

DECKS = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "decks"
SLOPE = math.radians(30)
HIDDEN_ANGLE = 23.0  # degrees


def block_on_slope():
    """Returns the cards of a block, 2 m wide and 1 m high, on a slope that is fixed."""
    turn = np.array([[math.cos(SLOPE), -math.sin(SLOPE)], [math.sin(SLOPE), math.cos(SLOPE)]])
    deck = blocks.Deck(name="block").start(2, 4, lines=["A BLOCK ON A SLOPE"])
    deck.xlimits(-20, 20).ylimits(-20, 20).boxes(20, 20, 0.05).stiff(1e7, 1e7).fraction(0.02)
    deck.material(1, 1e9, 4e8, 2000).rigid().end()
    for x, y, width, height, is_fixed in ((-10, -1, 20, 1, 1), (-1, 0, 2, 1, 0)):
        outline = np.array([(x, y), (x, y + height), (x + width, y + height), (x + width, y)]) @ turn.T
        deck.create(4, 1, is_fixed, lines=outline.T)
    # The springs take up the weight slowly: local damping brings the block to rest on them.
    return deck.gravity(0, -9.81).locdamp(0.8)


def sliding(friction):
    """Returns 1 if the block slides and -1 if it holds."""
    rock = blocks.Simulation(block_on_slope().frictn(friction))
    rock.run_until(0.5)
    before = rock.centroid[1].copy()
    rock.run_until(1.0)
    moved = np.linalg.norm(rock.centroid[1] - before)
    return 1 if moved > 1e-6 else -1


def displacement(angle):
    """Returns the mean displacement of the rock of decks/slope after 0.8 s with a friction angle [degrees]."""
    rock = blocks.Simulation(DECKS / "slope/slope.deck", moves=False)
    rock.cards.frictn(math.tan(math.radians(angle)))
    free, before = rock.is_free, rock.centroid.copy()
    rock.run_until(0.8)
    moved = np.linalg.norm(rock.centroid - before, axis=1)
    return moved[free] @ rock.mass[free] / rock.mass[free].sum()


def main():
    critical = bisect(sliding, 0.3, 0.9, xtol=1e-5)
    error = critical - math.tan(SLOPE)
    print(f"the block slides below {critical:.5f}; tan 30 = {math.tan(SLOPE):.5f}, error {error:+.1e}")

    measured = displacement(HIDDEN_ANGLE)
    calls = []

    def misfit(angle):
        calls.append(angle)
        return displacement(angle) - measured

    angle = brentq(misfit, 15, 30, xtol=0.01)
    print(f"a displacement of {measured:.4f} m means {angle:.2f} degrees of friction "
          f"({len(calls)} runs; it was made with {HIDDEN_ANGLE:g})")
    return 0 if abs(error) < 1e-3 and abs(angle - HIDDEN_ANGLE) < 0.1 else 1


if __name__ == "__main__":
    sys.exit(main())
