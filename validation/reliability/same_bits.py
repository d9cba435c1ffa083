#!/usr/bin/python3
"""Tests that every compiler, level of optimisation, number of threads and instruction set gives
the same bits. Builds the program with each compiler at each level, runs twenty decks and compares
the hashes of their last states.

BUILDS: a folder for the builds, which is reused. REPORT: the page without its ending.
--program NAME=PATH: also runs an existing program.
--quick: one build only, which differs most from the usual one, a sixteenth of the steps but for one
deck, and three ways to run each deck.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import version

SOURCE = Path(__file__).resolve().parents[2]

# The decks and the maximum number of steps of each. The decks of many blocks use all threads;
# more steps of them would take more than a minute per run at -O0.
DECKS = {
    "decks/bounce/bounce.deck": 20000,
    "decks/sliding/sliding.deck": 20000,
    "decks/toppling/toppling.deck": 20000,
    "decks/stack/stack.deck": 5000,
    "decks/wave/wave.deck": 1000,
    "decks/every_card/every_card.deck": 2000,
    "decks/crater/crater.deck": 500,
    "decks/subsidence/subsidence.deck": 300,
    "decks/slope/slope.deck": 400,
    "decks/opening/opening.deck": 200,
    "decks/footing/footing.deck": 400,
    "decks/direct_shear/rough.deck": 2000,
    "decks/cohesive_slope/cohesive_slope.deck": 1000,
    "decks/overhang/overhang.deck": 300,
    "decks/biaxial/biaxial.deck": 1000,
    "decks/circular_opening/circular_opening.deck": 300,
    "decks/quiet_column/quiet_column.deck": 48000,
    "decks/crater_cracks/crater_cracks.deck": 4000,
    "validation/problems/longwall/longwall.deck": 100,
    "validation/rest/wall.deck": 150,
}
THREADS = [1, 2, 4, 8]
SIMD = ["baseline", "avx2", "avx512"]
BUILDS = [(compiler, level) for compiler in ("g++", "clang++")
          for level in ("O0", "O2", "O3")]
QUICK = [("clang++", "O0")]
LONG = "decks/stack/stack.deck"  # runs all its steps, quick or not


def fail(message):
    print(f"blocks: error: {message}", file=sys.stderr)
    sys.exit(5)


def built(folder, compiler, level):
    """Builds the program with this compiler at this level and returns its path."""
    if shutil.which(compiler) is None:
        fail(f"no {compiler} on this machine (packages-test.txt names it)")
    build = folder / f"{compiler}-{level}"
    build.mkdir(parents=True, exist_ok=True)
    log = build / "build.log"
    with log.open("w") as out:
        for command in (
                ["cmake", "-S", SOURCE, "-B", build, "-G", "Ninja",
                 f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Release",
                 f"-DCMAKE_CXX_FLAGS_RELEASE=-{level} -DNDEBUG", "-DBUILD_TESTING=OFF"],
                ["cmake", "--build", build, "-j", str(os.cpu_count()), "--target",
                 "blocks"]):
            if subprocess.run(command, stdout=out, stderr=out, check=False).returncode:
                fail(f"the build failed, see {log}")
    return build / "src/blocks"


def hash_of(program, deck, steps, threads=1, simd=None):
    """Runs a deck; returns the steps and the hash of the last state, or None if this machine does
    not have the instruction set."""
    environment = dict(os.environ)
    environment.pop("BLOCKS_SIMD", None)
    if simd:
        environment["BLOCKS_SIMD"] = simd
    program = Path(program).resolve()
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [program, "run", SOURCE / deck, "-q", "-o", "a", "-j", str(threads),
             "--stop-after", str(steps)],
            cwd=folder, env=environment, capture_output=True, text=True, check=False)
        if run.returncode == 2 and simd:
            return None
        if run.returncode not in (0, 75):
            fail(f"{deck} by {program} ended with {run.returncode}: {run.stderr}")
        summary = json.loads((Path(folder) / "a.summary.json").read_text())
        return summary["steps"], summary["state_hash"]


def variants(program, deck, ways):
    """Yields the name and the hash of each way to run the deck with one program."""
    for threads, simd in ways:
        found = hash_of(program, deck, DECKS[deck], threads, simd)
        if found:
            yield simd or f"-j {threads}", found


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", type=Path)
    parser.add_argument("report")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--program", action="append", default=[])
    arguments = parser.parse_args()
    programs = dict(given.split("=", 1) for given in arguments.program)
    ways = [(threads, None) for threads in THREADS] + [(1, simd) for simd in SIMD]
    if arguments.quick:
        # Without a name the widest instruction set runs. So each number of threads and each set
        # runs once.
        ways = [(2, None), (1, "baseline"), (1, "avx2")]
        DECKS.update({deck: steps // 16 for deck, steps in DECKS.items() if deck != LONG})
    for compiler, level in QUICK if arguments.quick else BUILDS:
        print(f"building with {compiler} -{level} ...", flush=True)
        programs[f"{compiler} -{level}"] = built(arguments.builds.resolve(), compiler, level)
    golden, differing, runs, names = {}, [], 0, []
    for deck in DECKS:
        for name, program in programs.items():
            for how, found in variants(program, deck, ways):
                runs += 1
                if how not in names:
                    names.append(how)
                if golden.setdefault(deck, found) != found:
                    differing.append(f"{deck}, {name} {how}: {found}")
        print(f"{deck}: {golden[deck]}, {len(differing)} runs differ", flush=True)
    lines = ["# The same bits", "",
             "Written by `./go validate bits`; do not edit. The hash is of the last "
             "state, every number to the bit.", "",
             "| deck | steps | hash |", "|---|---|---|"]
    lines += [f"| `{deck}` | {steps} | `{state}` |"
              for deck, (steps, state) in golden.items()]
    lines += ["", f"{version.sentence()} {runs} runs by {', '.join(programs)}; each "
              f"with {', '.join(names)}. "
              + ("All have these hashes." if not differing else
                 f"**{len(differing)} differ**:"), ""]
    lines += [f"- {one}" for one in differing]
    Path(arguments.report + ".md").write_text("\n".join(lines).rstrip() + "\n")
    print(lines[-2 if not differing else -1])
    return 4 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
