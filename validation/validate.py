#!/usr/bin/python3
"""Long checks and measurements: ./go validate SUBCOMMAND [ARGUMENTS].

Each subcommand builds what it needs, runs it, and writes a report into the folder of its subject.
The exit code is 0 if everything passed.
"""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
BUILD = ROOT / "build"
CI = BUILD / "ci"  # the release build and all further programs
RELEASE = BUILD / "release"  # the program only
RELIABILITY = HERE / "reliability"

sys.dont_write_bytecode = True
sys.path.insert(0, str(RELIABILITY))

import fuzz  # noqa: E402
import version  # noqa: E402


def build(preset, *targets):
    """Builds the targets, or everything if none is named; ends the program if that fails."""
    code = run(ROOT / "go", "build", preset, *targets)
    if code:
        sys.exit(code)


def run(*command, environment=None):
    """Runs a command and returns its exit code."""
    sys.stdout.flush()
    return subprocess.run([str(word) for word in command], check=False,
                          env={**os.environ, **(environment or {})}).returncode


def run_python(script, *arguments, environment=None):
    return run(sys.executable, HERE / script, *arguments, environment=environment)


def report_option(count, full, report, option="--report"):
    """Returns the option that writes the report. A run with fewer inputs than the full number
    gets no such option and leaves the committed report as it is."""
    return [option, HERE / report] if count >= full else []


def layers(arguments):
    build("ci", "layers", "certificate_study", "distribution_study")
    programs = CI / "validation/geometry"

    def report(name):
        return report_option(arguments.count, arguments.full, f"geometry/{name}")

    first_failure = 0
    for command in (
            [programs / "layers", "--layers", arguments.count, *report("LAYERS")],
            [programs / "certificate_study", *report("CERTIFICATE")],
            [programs / "distribution_study", *report("DISTRIBUTION")],
            [HERE / "geometry/compilers.sh", BUILD / "compilers"]):
        code = run(*command)
        if code:
            print(f"validate: {command[0].name}: exit code {code}", file=sys.stderr)
        first_failure = first_failure or code
    return first_failure


def law_figures(_):
    build("ci", "law_figures")
    return run(CI / "validation/laws/law_figures", ROOT / "docs/images")


def cells(arguments):
    build("ci", "cell_statistics")
    report = report_option(arguments.count, arguments.full, "cells")
    code = run(CI / "validation/cells/cell_statistics", "--networks", arguments.count, *report)
    if report and code in (0, 4):
        with open(HERE / "cells/REPORT.md", "a", encoding="utf-8") as page:
            page.write(f"\n{version.sentence()}\n")
    return code


def traces(arguments):
    build("ci", "trace_recovery")
    return run(CI / "validation/traces/trace_recovery", arguments.count,
               *report_option(arguments.count, arguments.full, "traces/RECOVERY.md")[1:])


def cuts(arguments):
    build("ci", "cuts")
    return run(CI / "validation/geometry/cuts", "--networks", arguments.count,
               *report_option(arguments.count, arguments.full, "geometry/CUTS"))


def splits(arguments):
    build("ci", "splits")
    return run(CI / "validation/geometry/splits", "--blocks", arguments.count,
               *report_option(arguments.count, arguments.full, "geometry/SPLITS"))


def seeds(arguments):
    build("release", "blocks")
    program, folder = RELEASE / "src/blocks", BUILD / "seeds.sweep"
    shutil.rmtree(folder, ignore_errors=True)
    table = HERE / "geometry/SEEDS.csv" if arguments.count >= arguments.full else BUILD / "SEEDS.csv"
    code = run(program, "sweep", HERE / "geometry/layer.deck", "--check",
               "--table", HERE / "geometry/orient.csv", "--seeds", f"1-{arguments.count}",
               "-o", folder)
    return code or run(program, "report", folder, "-o", table, "-q", "angles_redrawn,"
                       "sides_redrawn,sides_ruled,width:sd,aspect:max,shortest_side:min,"
                       "smallest_angle:min,p21,certificate")


def predicates(arguments):
    build("ci", "predicates")
    return run(CI / "validation/geometry/predicates", "--inputs", arguments.count,
               *report_option(arguments.count, arguments.full, "geometry/PREDICATES"))


def problems(arguments):
    build("release", "blocks")
    return run_python("problems/problems.py", RELEASE / "src/blocks", "--report",
                      *arguments.names, *(["--kept"] if arguments.kept else []))


def study(arguments):
    build("release", "blocks")
    program, folder = RELEASE / "src/blocks", BUILD / "study.sweep"
    if not arguments.resume:
        shutil.rmtree(folder, ignore_errors=True)
    # The last frame has the number count - 1.
    code = run(program, "sweep", "all", "--study", "--variants", "default",
               "--seeds", f"0-{arguments.count - 1}", "-o", folder)
    return code or run(program, "study", "contacts", folder, "--gate",
                       *report_option(arguments.count, arguments.full, "robustness/CONTACTS.csv",
                                      "--csv"))


def frames(arguments):
    build("release", "blocks")
    return run_python("robustness/frames.py", RELEASE / "src/blocks", *arguments.decks,
                      *([] if arguments.decks else ["--report"]))


def steps(arguments):
    build("release", "blocks")
    return run_python("robustness/time_steps.py", RELEASE / "src/blocks", *arguments.decks,
                      *([] if arguments.decks else ["--report"]))


def reliability(arguments):
    build("ci")
    return run_python("reliability/report.py", CI, RELIABILITY / "REPORT", *arguments.words,
                      environment={"BLOCKS_THOROUGH": "1"})


def bits(arguments):
    builds = BUILD / "bits"
    if not arguments.quick:
        return run_python("reliability/same_bits.py", builds, RELIABILITY / "SAME_BITS")
    build("ci", "blocks")
    return run_python("reliability/same_bits.py", builds, builds / "QUICK", "--quick",
                      "--program", f"g++ -O3={CI / 'src/blocks'}")


def fuzz_readers(arguments):
    targets = fuzz.parse_targets(arguments.targets)
    build("fuzz", "fuzz_seeds", *(f"fuzz_{name}" for name in targets))
    limit = [] if arguments.seconds is None else ["--seconds", arguments.seconds]
    return run_python("reliability/fuzz.py", BUILD / "fuzz", RELIABILITY / "FUZZ",
                      *limit, *arguments.targets)


def cracks(_):
    build("ci", "blocks")
    return run_python("reliability/crack_heap.py", CI / "src/blocks", BUILD / "crack_heap")


def soak(arguments):
    build("ci", "soak")
    report = report_option(arguments.count, arguments.full, "reliability/SOAK")
    code = run(CI / "validation/reliability/soak", "--steps", arguments.count, *report)
    if report and code == 0:
        with open(RELIABILITY / "SOAK.md", "a", encoding="utf-8") as page:
            page.write(f"\n{version.sentence()}\n")
    return code


def rest(arguments):
    build("ci", "rest")
    return run(CI / "validation/rest/rest", "--steps", arguments.count,
               *report_option(arguments.count, arguments.full, "rest/REST"))


def bench(arguments):
    build("ci", "bench")
    options = ["--quick"] if arguments.quick else []
    for name in ("output", "rounds", "largest"):
        value = getattr(arguments, name)
        options += [f"--{name}", value] if value else []
    return run(CI / "validation/performance/bench", *options, *arguments.parts)


def python(arguments):
    build("ci", "blocks", "blocks_python")
    return run("/usr/bin/python3", HERE / "performance/python_steps.py", CI / "src/blocks", CI / "python",
               "--rounds", arguments.rounds)


def big(arguments):
    build("release", "blocks")
    return run_python("performance/big_model.py", RELEASE / "src/blocks",
                      HERE / "performance/BIG_MODEL" if arguments.largest == 6
                      else BUILD / "BIG_MODEL",
                      "--largest", arguments.largest, "--rounds", arguments.rounds)


def sanitizers(arguments):
    preset = "fuzz" if arguments.subcommand == "asan" else "tsan"  # The fuzz preset has ASan.
    build(preset)
    # A run of selected tests leaves the committed report as it is.
    folder = BUILD / preset if arguments.options else RELIABILITY
    return run_python("reliability/sanitizers.py", arguments.subcommand, BUILD / preset,
                      folder / "SANITIZERS", *arguments.options)


def tiling(arguments):
    build("release", "blocks")
    if arguments.others:
        return run_python("tiling/others.py", RELEASE / "src/blocks")
    return run_python("tiling/decks.py", RELEASE / "src/blocks", *arguments.decks)


def whole_number(text):
    if not text.isdigit() or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text} is not a whole number above 0")
    return int(text)


def parser():
    top = argparse.ArgumentParser(prog="./go validate", description=__doc__.split("\n\n", 1)[1],
                                  epilog="./go validate SUBCOMMAND --help explains one of them.")
    subcommands = top.add_subparsers(dest="subcommand", required=True, metavar="SUBCOMMAND")

    def add(name, function, summary, more="", count=None):
        """Adds a subcommand; count is the full number of its inputs and what they are."""
        command = subcommands.add_parser(name, help=summary,
                                         description=f"{summary[0].upper()}{summary[1:]}. {more}")
        command.set_defaults(run=function)
        if count:
            full, what = count
            command.add_argument("count", metavar="N", nargs="?", type=whole_number, default=full,
                                 help=f"number of {what} (default {full:,}); with fewer, the "
                                      "committed report is left as it is")
            command.set_defaults(full=full)
        return command

    command = add("problems", problems, "problems with known answers",
                  "Writes validation/REPORT.md and REPORT.html, and the figures and results of "
                  "each problem. Exit code 4: a row misses that is not a known miss.")
    command.add_argument("names", metavar="NAME", nargs="*",
                         help="folders of validation/problems (default: all); the report keeps "
                              "the rows of the others")
    command.add_argument("--kept", action="store_true",
                         help="run nothing; print which program measured the rows of the report")
    add("layers", layers, "generated layers and their certificate",
        "Writes LAYERS.md, CERTIFICATE.md and DISTRIBUTION.md in validation/geometry and compares "
        "the layers that g++ and clang++ make. All four parts run; the exit code is that of the "
        "first part that fails.", (100_000, "random layers"))
    add("cells", cells, "cells of random joints against exact answers",
        "Exit code 4: a mean deviates too far from its exact value. Writes "
        "validation/cells/REPORT.md and its figures. Takes 6 minutes.",
        (4000, "networks of Poisson lines; the others are in proportion"))
    add("traces", traces, "joint sets fitted to the maps that they made",
        "Writes validation/traces/RECOVERY.md. Exit code 4: an interval covers too seldom. Takes a "
        "minute.", (500, "maps of each kind"))
    add("law-figures", law_figures, "the laws of joints as curves",
        "Drives single contacts along paths and writes docs/images/laws-*.svg.")
    add("cuts", cuts, "random networks of joints, cut and judged",
        "Writes validation/geometry/CUTS.md. Takes ten minutes on two cores. Exit code 4: a "
        "certified result is wrong, or a refusal has no place.", (100_000, "random networks"))
    add("splits", splits, "random blocks, each cut in two and judged",
        "Writes validation/geometry/SPLITS.md. Takes two minutes. Exit code 4: a result is wrong.",
        (100_000, "random blocks"))
    add("seeds", seeds, "random layers of 100 blocks with sides of several angles",
        "A sweep in build/seeds.sweep. Writes its report to validation/geometry/SEEDS.csv. Takes "
        "half a minute.", (1000, "seeds for each range of angles"))
    add("predicates", predicates, "the contact predicates against MPFR",
        "Writes validation/geometry/PREDICATES.md.", (10_000_000, "inputs"))
    command = add("study", study, "every scene of contact detection by the default rules",
                  "A sweep in build/study.sweep. Exit code 4: a hang-up or fall-through in a "
                  "scene that is known to pass, or a decision that is not exact. Writes "
                  "validation/robustness/CONTACTS.csv.", (1000, "frames of each scene"))
    command.add_argument("--resume", action="store_true",
                         help="go on with an interrupted sweep of the same program")
    command = add("tiling", tiling, "blocks of decks judged by a program of its own",
                  "Exports the blocks of decks and judges exactly whether they tile their outlines "
                  "(validation/tiling/tiling.py, which shares no code with the program).")
    command.add_argument("decks", metavar="DECK", nargs="*", help="default: all shipped decks")
    command.add_argument("--others", action="store_true",
                         help="compare with GEOS and Qhull on random networks; needs "
                              "python3-shapely and python3-scipy")
    command = add("frames", frames, "decks in other frames: turned, shifted, mirrored, twice as large",
                  "Runs all shipped decks and those of the validation problems in nine frames, and "
                  "compares the motion of their blocks. Takes a quarter of an hour. Writes "
                  "validation/robustness/FRAMES.md.")
    command.add_argument("decks", metavar="DECK", nargs="*", help="only these decks; writes no report")
    command = add("steps", steps, "the error of the integration for three time steps",
                  "Runs the decks of the validation problems with their FRACTION, half and a quarter "
                  "of it. Takes ten minutes. Writes validation/robustness/TIME_STEPS.md.")
    command.add_argument("decks", metavar="DECK", nargs="*", help="only these decks; writes no report")
    command = add("reliability", reliability, "files and inputs that are damaged or forged",
                  "Kills runs, fills disks, lets memory requests fail and changes files at random, "
                  "at length. Writes validation/reliability/REPORT.md.")
    command.add_argument("words", metavar="WORD", nargs="*",
                         help="run only the rows that contain one of these words")
    command = add("bits", bits, "the same bits from every compiler and thread count",
                  "Runs twenty decks with builds of g++ and clang++ at -O0, -O2 and -O3, with 1 to 8 "
                  "threads and every instruction set. Writes validation/reliability/SAME_BITS.md.")
    command.add_argument("--quick", action="store_true",
                         help="two builds, a sixteenth of the steps, three ways to run each; "
                              "writes build/bits/QUICK.md")
    command = add("fuzz", fuzz_readers, "every reader under libFuzzer",
                  "Writes validation/reliability/FUZZ.md and keeps the inputs that it finds in "
                  "build/found/TARGET, where the next run continues.")
    command.add_argument("targets", metavar="TARGET[=N]", nargs="*",
                         help=f"{', '.join(fuzz.TARGETS)} (default: all), with N executions")
    command.add_argument("--seconds", type=whole_number,
                         help="run each target for this time, print the output of libFuzzer and "
                              "leave the committed report as it is")
    add("cracks", cracks, "a heap of blocks that split thousands of times, audited",
        "Takes 5 minutes. Exit code 1: a decision was wrong, or there were fewer than 1,000 cracks.")
    add("soak", soak, "many steps of the 850 blocks of subsidence",
        "Exit code 4: a number is not finite, the energy rises above its start, or blocks still "
        "move at the end. Writes validation/reliability/SOAK.md.", (10_000_000, "steps"))
    add("rest", rest, "many steps of a wall of 1,000 bricks at rest",
        "Exit code 4: the wall is not at rest at the end. Writes validation/rest/REST.md.",
        (1_000_000, "steps"))
    command = add("bench", bench, "times of scenes in several states, against other codes",
                  "Takes 13 minutes. Writes bench.md, bench.json and bench.png in the current "
                  "folder.")
    command.add_argument("parts", metavar="PART", nargs="*",
                         help="rock, wall, pile, slope, crater, subsidence, decks, search, predicates, "
                              "generation, cut, seeds, sweeps (default: all)")
    command.add_argument("--quick", action="store_true", help="small scenes; takes one minute")
    command.add_argument("-o", "--output", metavar="NAME", help="write NAME.md, .json and .png")
    command.add_argument("--rounds", type=whole_number, help="turns of each code (5; quick: 3)")
    command.add_argument("--largest", type=whole_number, metavar="K",
                         help="at most 10^K blocks (6; quick: 4)")
    command = add("python", python, "times of steps from Python",
                  "Steps a wall of 10,000 bricks by the program and from Python, in turns. Takes a minute.")
    command.add_argument("--rounds", type=whole_number, default=7, help="turns of each (7)")
    command = add("big", big, "one model of up to a million blocks",
                  "Measures times, memory and files, and extrapolates them to ten times as many "
                  "blocks. Takes half an hour. Writes validation/performance/BIG_MODEL.md and "
                  ".csv; with another --largest, the same in build.")
    command.add_argument("--largest", type=int, choices=(5, 6, 7), default=6, metavar="K",
                         help="at most 10^K blocks: 5, 6 (default) or 7")
    command.add_argument("--rounds", type=whole_number, default=3,
                         help="runs of each kind; the least one counts (default 3)")
    for name, what in (("asan", "the address and undefined-behaviour sanitizers"),
                       ("tsan", "the thread sanitizer")):
        add(name, sanitizers, f"every test under {what}",
            "Writes the row of this sanitizer in validation/reliability/SANITIZERS.md. Further "
            "options go to ctest, for example -R NAME; with any, the committed report is left as "
            "it is.")
    return top


def main():
    reader = parser()
    arguments, further = reader.parse_known_args()
    if further and arguments.run is not sanitizers:
        reader.error(f"unrecognized arguments: {' '.join(further)}")
    arguments.options = further
    try:
        return arguments.run(arguments)
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
