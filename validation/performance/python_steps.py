#!/usr/bin/python3
"""What a step costs from Python: python_steps.py PROGRAM PACKAGE [--rounds N].

A wall of 10,000 bricks at rest is stepped by the program, by step(1000) and by 1,000 calls of
step(1), in turns. The exit code is 1 if step(1000) takes more than 1.05 of the program's time, or
if a call of step(1) takes more than 5 us more than a step of step(1000)."""

import argparse
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROWS, COLUMNS, SETTLED, STEPS = 100, 100, 200, 1000
MOST, MOST_MORE = 1.05, 5.0


def wall():
    """Returns a deck with a wall in running bond in a trough, without steps."""
    cards = ["START, 11000, 4", "WALL IN RUNNING BOND", f"XLIMITS, -5, {COLUMNS + 5}", f"YLIMITS, -5, {ROWS}",
             "BOXES, 100, 100, .05", "STIFF, 1.E9, 5.E8", "FRACTION, .05", "MATERIAL, 1, 1.E9, 4.E8, 2500", "RIGID",
             "END"]

    def box(x0, y0, x1, y1, fixed=0):
        cards.extend([f"CREATE, 4, 1, {fixed}", f"{x0}, {x0}, {x1}, {x1}", f"{y0}, {y1}, {y1}, {y0}"])

    box(-1, -1, COLUMNS + 1, 0, 1)
    box(-1, 0, 0, ROWS / 2 + 1, 1)
    box(COLUMNS, 0, COLUMNS + 1, ROWS / 2 + 1, 1)
    for row in range(ROWS):
        for column in range(COLUMNS + row % 2):
            left, right = column - row % 2 / 2, column + 1 - row % 2 / 2
            box(max(0, left), row / 2, min(COLUMNS, right), row / 2 + .5)
    return "\n".join([*cards, "FRICTN, .5", "DAMPING, .2", "GRAVITY, 0, -9.81", ""])


def processor_time(program, deck):
    """Returns the processor time of a run, s."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "run", deck, "-o", Path(folder, "wall"), "-j", "1", "-q"], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("package")
    parser.add_argument("--rounds", type=int, default=7)
    options = parser.parse_args()
    sys.path.insert(0, options.package)
    import blocks

    simulation = blocks.Simulation(wall())
    simulation.step(SETTLED)
    of_program, of_steps, of_calls = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        short, long = Path(folder, "short.deck"), Path(folder, "long.deck")
        for path, steps in ((short, SETTLED), (long, SETTLED + STEPS)):
            path.write_text(f"{wall()}CYCLE, {steps}\nSTOP\n", encoding="utf-8")
        for _ in range(options.rounds):
            of_program.append(processor_time(options.program, long) - processor_time(options.program, short))
            # The same steps as those of the program.
            simulation = blocks.Simulation(wall())
            simulation.step(SETTLED)
            begin = time.process_time()
            simulation.step(STEPS)
            of_steps.append(time.process_time() - begin)
            simulation = blocks.Simulation(wall())
            simulation.step(SETTLED)
            begin = time.process_time()
            for _ in range(STEPS):
                simulation.step(1)
            of_calls.append(time.process_time() - begin)
    microseconds = [[1e6 * t / STEPS for t in times] for times in (of_program, of_steps, of_calls)]
    ratio = statistics.median(b / a for a, b in zip(*microseconds[:2]))
    more = statistics.median(c - b for b, c in zip(*microseconds[1:]))
    for name, times in zip(("blocks run", f"step({STEPS})", "step(1)"), microseconds):
        print(f"{name:11} {statistics.median(times):8.1f} us a step ({min(times):.1f} to {max(times):.1f})")
    print(f"step({STEPS}) takes {ratio:.3f} of the program's time, at most {MOST}")
    print(f"a call of step(1) takes {more:+.1f} us more than a step of step({STEPS}), at most {MOST_MORE:g}")
    sys.exit(0 if ratio <= MOST and more <= MOST_MORE else 1)


main()
