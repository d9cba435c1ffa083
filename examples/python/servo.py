#!/usr/bin/python3
"""Presses a plate onto a wall of bricks until it carries a given force, by a servo in Python.

The velocity of the plate is set before each step. It is proportional to the difference between the wanted
force and the present contact force on the plate. The plate is so heavy that contacts hardly change its
velocity within a step, and a FORCE card carries its weight. A second wall has a fixed plate that a SERVO card
drives (docs/rest.md#servos). It presses faster, and friction between the bricks depends on the path, so the
plates end at heights that are close but not equal.

    python3 servo.py [force in N]       exit code 1: a force or the heights differ too much
"""

import sys

import numpy as np

import blocks

FLOOR, PLATE, WIDTH = 0, 11, 7.0  # blocks are counted from 0; width of the plate in m
STIFFNESS = 1e8  # of a contact, N/m
GRAVITY = 9.81  # m/s2
FASTEST = 0.05  # speed of the plate, m/s
GAIN = 0.005  # part of the missing force that a step adds
END = 1.5  # s
CLOSE = 1e-3  # part of a force that may be missing
APART = 1e-2  # part of the closure of the wall by which the plates may differ


def wall(is_fixed):
    """Returns a wall of three layers between a floor and a plate, which is free or fixed."""
    density = 2500.0 if is_fixed else 1e12
    deck = blocks.Deck(name="wall").start(12, 4, lines=["A PLATE ON A WALL"])
    deck.xlimits(-2, 8).ylimits(-2, 8).boxes(10, 10, 0.05).stiff(STIFFNESS, STIFFNESS).fraction(0.03)
    deck.material(1, 1e9, 4e8, 2500).material(2, 1e9, 4e8, density)
    deck.function(1, lines=[(0, 1)]).rigid().end()
    deck.create(4, 1, 1, lines=[(-1, -1, 7, 7), (-1, 0, 0, -1)])
    deck.layer(-3, 1, 0, 0, 0, 1, 6, 1, 6, 0)
    deck.layer(4, 1, 0, 1, 0, 2, 6, 2, 6, 1, lines=[(1, 2, 2, 1), (1, 2, 2, 1)])
    deck.layer(-3, 1, 0, 2, 0, 3, 6, 3, 6, 2)
    deck.create(4, 2, int(is_fixed), lines=[(-0.5, -0.5, 6.5, 6.5), (3, 3.5, 3.5, 3)])
    deck.gravity(0, -GRAVITY).frictn(0.6).damping(0.3)
    if not is_fixed:
        deck.force(PLATE + 1, 0, GRAVITY * density * 0.5 * WIDTH)  # cards count from 1
    return blocks.Simulation(deck)


def press(wanted):
    """Returns the wall after the servo in Python has pressed it."""
    rock = wall(is_fixed=False)
    gain = GAIN / (6 * STIFFNESS * rock.time_step)  # the plate has six contacts with three bricks
    next_line = 0.0
    print("   t [s]   plate at y [m]   force on it [N]")
    while rock.time < END:
        force = rock.contact_force[PLATE, 1]
        if rock.time >= next_line:
            print(f"{rock.time:8.3f}   {rock.centroid[PLATE, 1]:14.6f}   {force:15.1f}")
            next_line += 0.25
        down = np.clip(gain * (wanted - force), -FASTEST, FASTEST)
        rock.velocity[PLATE] = 0.0, -down
        rock.spin[PLATE] = 0.0
        rock.step(read=True)
    return rock


def press_by_card(wanted):
    """Returns the wall after a SERVO card has pressed it. Side 4 is the lower one of the plate."""
    rock = wall(is_fixed=True)
    rock.cards.servo(PLATE + 1, 4, -wanted / WIDTH, FASTEST)
    rock.run_until(END)
    return rock


def is_close(what, force, expected):
    """Prints a force and its expected value. Returns whether they agree."""
    error = force / expected - 1
    print(f"{what}: {force:.1f} N, expected {expected:.1f} N, error {100 * error:+.3f} %")
    return abs(error) < CLOSE


def main():
    wanted = float(sys.argv[1]) if len(sys.argv) > 1 else 1e6
    loop, card = press(wanted), press_by_card(wanted)
    weight = GRAVITY * loop.mass[FLOOR + 1:PLATE].sum()
    good = [
        is_close("on the plate, servo in Python", loop.contact_force[PLATE, 1], wanted),
        is_close("on the plate, SERVO card     ", card.contact_force[PLATE, 1], wanted),
        is_close("on the floor, servo in Python", -loop.contact_force[FLOOR, 1], wanted + weight),
        is_close("on the floor, SERVO card     ", -card.contact_force[FLOOR, 1], wanted + weight),
    ]
    apart = abs(loop.centroid[PLATE, 1] - card.centroid[PLATE, 1])
    closed = 3.25 - card.centroid[PLATE, 1]
    print(f"the wall has closed by {1e3 * closed:.3f} mm; the two plates differ by {1e3 * apart:.4f} mm")
    return 0 if all(good) and apart < APART * closed else 1


if __name__ == "__main__":
    sys.exit(main())
