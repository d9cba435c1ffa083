#!/usr/bin/python3
"""What does one model of many blocks cost?

big_model.py PROGRAM REPORT [--largest K] [--rounds R] measures models of 10^4 to 10^K blocks
and writes REPORT.md and REPORT.csv, with an extrapolation to 10^(K+1) blocks.
big_model.py --deck K prints the deck of 10^K blocks.

A model has layers of RANDOM blocks 2 high on a fixed floor between fixed sides, under gravity.
Each run is stopped after 100 and after 300 steps, and the difference is the cost of 200 steps.
From then on, nearly as many contacts act as in the model at rest.
"""

import argparse
import csv
import json
import math
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "reliability"))
import version  # noqa: E402

# Layers and blocks of each layer. The height is the same, so that the contacts of all models have
# settled alike after the same number of steps.
LAYERS = 50
SIZES = {power: (LAYERS, 10**power // LAYERS) for power in (4, 5, 6, 7)}
# The floor has pieces of this length, because the cost of a block grows with the square of its
# number of neighbours.
PIECE = 20  # metres
SETTLING, MEASURED = 100, 200  # steps


def deck(power):
    """The text of a deck of 10^power blocks and the fixed ones. Lengths are in metres."""
    layers, blocks = SIZES[power]
    width, height = 2 * blocks, 2 * layers
    pieces = width // PIECE + 2

    def fixed(left, bottom, right, top):
        return (f"CREATE, 4, 1, 1\n{left}, {left}, {right}, {right}\n"
                f"{bottom}, {top}, {top}, {bottom}\n")

    rock = "".join(f"LAYER, -{blocks}, 1, 0,{y}, 0,{y + 2}, {width},{y + 2}, {width},{y}, RANDOM\n"
                   for y in range(0, height, 2))
    return (f"START, {layers * blocks + pieces + 2}, 4\n"
            f"{layers} LAYERS OF {blocks} RANDOM BLOCKS\n"
            f"XLIMITS, {-2 * PIECE}, {width + 2 * PIECE}\nYLIMITS, -4, {height + 4}\n"
            f"BOXES, {blocks}, {layers}, 0.2\nSTIFF, 1.E9, 1.E9\nFRACTION, 0.025\n"
            "MATERIAL, 1, 1.E10, 4.E9, 2500\nUNITS, m, kg, s\nSEED, 1\nRIGID\nEND\n"
            f"CLOOP, {pieces}, {PIECE}, 0\n" + fixed(-PIECE, -2, 0, 0)
            + fixed(-2, 0, 0, height) + fixed(width, 0, width + 2, height)
            + "ORIENT, -5, 5\n" + rock
            + "GRAVITY, 0, -9.81\nFRICTN, 0.5\nDAMPING, 0.5\nOUTPUT, 1000, 4\nCYCLE, 1000\nSTOP\n")


class Cost:
    """Processor time of the program itself [s], time by the clock [s], peak memory [bytes]."""

    def __init__(self, command):
        with tempfile.TemporaryFile() as text:
            begin = time.perf_counter()
            with subprocess.Popen([*map(str, command)], stdout=text, stderr=text) as run:
                _, status, used = os.wait4(run.pid, 0)
                run.returncode = os.waitstatus_to_exitcode(status)
            self.clock = time.perf_counter() - begin
            if run.returncode not in (0, 75):
                text.seek(0)
                sys.exit(f"big_model: error: {' '.join(map(str, command))}\n"
                         f"{text.read()[-2000:].decode()}")
        self.user, self.memory = used.ru_utime, 1024 * used.ru_maxrss


def least(costs, what):
    return min(getattr(cost, what) for cost in costs)


def measure(program, power, rounds, folder):
    """The row of 10^power blocks: times [s], memory and files [bytes]."""
    layers, blocks = SIZES[power]
    count = layers * blocks
    source, name = folder / "big.deck", folder / "big"
    source.write_text(deck(power), encoding="utf-8")
    check = [Cost([program, "check", source]) for _ in range(rounds)]
    short, long = {1: [], 2: []}, {1: [], 2: []}
    for _ in range(rounds):
        for threads in (1, 2):
            for runs, steps in ((short, SETTLING), (long, SETTLING + MEASURED)):
                for old in folder.glob("big.*"):
                    if old != source:
                        old.unlink()
                runs[threads].append(Cost([program, "run", source, "-o", name, "-j", threads,
                                           "--stop-after", steps]))
                print(f"10^{power}, {threads} threads, {steps} steps: "
                      f"{runs[threads][-1].user:.2f} s, by the clock "
                      f"{runs[threads][-1].clock:.2f} s", file=sys.stderr, flush=True)
    summary = json.loads(name.with_suffix(".summary.json").read_text(encoding="utf-8"))
    row = {"blocks": count, "contacts": summary["contacts"]["active"],
           "check_seconds": least(check, "user"), "check_memory": least(check, "memory"),
           "start_seconds": least(short[1], "user"),
           "step_seconds": (least(long[1], "user") - least(short[1], "user")) / MEASURED,
           # By the clock, two runs of a round are compared, because other programs may run.
           "step_seconds_2": min(slow.clock - fast.clock for slow, fast in
                                 zip(long[2], short[2])) / MEASURED,
           "run_memory": least(long[1], "memory"), "run_memory_2": least(long[2], "memory")}
    row["start_seconds"] -= SETTLING * row["step_seconds"]
    for what in ("vtkhdf", "ckpt.h5", "out", "summary.json"):
        row[what] = (folder / f"big.{what}").stat().st_size
    for old in folder.glob("big.*"):
        old.unlink()
    return row


def exponent(rows, key):
    return math.log10(rows[-1][key] / rows[-2][key])


def extrapolate(rows):
    """A row with ten times as many blocks, by the exponents between the last two rows. They are
    taken as 1 if they are smaller, because a part of each cost does not depend on the blocks."""
    return {key: value * 10**max(1, exponent(rows, key)) for key, value in rows[-1].items()}


def seconds(value):
    if value >= 100:
        return f"{value / 60:.0f} min"
    return f"{value:.2g} s" if value >= 0.1 else f"{1000 * value:.2g} ms"


def size(value):
    for unit, factor in (("GB", 1e9), ("MB", 1e6)):
        if value >= factor:
            return f"{value / factor:.2g} {unit}" if value < 10 * factor else \
                f"{value / factor:.0f} {unit}"
    return f"{value / 1e3:.0f} kB"


QUANTITIES = [
    ("contacts that act", "contacts", lambda value: f"{value:,.0f}"),
    ("generation and certificate", "check_seconds", seconds),
    ("memory of `blocks check`", "check_memory", size),
    ("a run without its steps", "start_seconds", seconds),
    ("one step, one thread", "step_seconds", seconds),
    ("one step, two threads", "step_seconds_2", seconds),
    ("memory of a run", "run_memory", size),
    ("results, two frames", "vtkhdf", size),
    ("checkpoint", "ckpt.h5", size),
    ("listing", "out", size)]


def page(rows, rounds):
    text = ("# One big model\n\nWritten by `./go validate big`; do not edit. Layers of random "
            "blocks under gravity. The last\ncolumn is extrapolated with the exponent between "
            "the two largest models, or 1 if it is smaller.\n"
            f"Least of {rounds} rounds; two threads by the clock, all else in processor time "
            "(user).\n\n")
    last = extrapolate(rows)
    heads = ["", *(f"{row['blocks']:,}" for row in rows), "exponent", f"{last['blocks']:,.0f}"]
    text += "| " + " | ".join(heads) + " |\n" + "|---" * len(heads) + "|\n"
    for label, key, form in QUANTITIES:
        cells = [label, *(form(row[key]) for row in rows), f"{exponent(rows, key):.2f}",
                 form(last[key])]
        text += "| " + " | ".join(cells) + " |\n"
    return text + f"\n{version.sentence()}\n"


def main():
    reader = argparse.ArgumentParser(description=__doc__.split("\n\n", 1)[0])
    reader.add_argument("program", nargs="?")
    reader.add_argument("report", nargs="?", type=Path)
    reader.add_argument("--deck", type=int, choices=SIZES, metavar="K")
    reader.add_argument("--largest", type=int, choices=range(5, 8), default=6, metavar="K")
    reader.add_argument("--rounds", type=int, default=3)
    arguments = reader.parse_args()
    if arguments.deck:
        print(deck(arguments.deck), end="")
        return 0
    if not arguments.report:
        reader.error("give the program and the report, or --deck K")
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for power in range(min(SIZES), arguments.largest + 1):
            rows.append(measure(arguments.program, power, arguments.rounds, Path(folder)))
    with open(f"{arguments.report}.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    text = page(rows, arguments.rounds)
    Path(f"{arguments.report}.md").write_text(text, encoding="utf-8")
    print(text, end="")
    return 0


if __name__ == "__main__":
    sys.exit(main())
