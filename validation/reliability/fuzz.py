#!/usr/bin/python3
"""Runs libFuzzer on every reader, with the address and undefined-behaviour sanitizers.

fuzz.py BUILD REPORT [TARGET[=EXECUTIONS]...]: BUILD is a build folder of the fuzz preset, REPORT
the page without its ending. Rows of targets that do not run stay as they are, and executions of
the same sources add up.
fuzz.py BUILD REPORT --seconds N TARGET...: runs each target for N seconds, prints the output of
libFuzzer and writes no page.
The inputs that it finds are kept in BUILD/../found/TARGET, where the next run continues.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

import version

SOURCE = Path(__file__).resolve().parents[2]
CORPUS = SOURCE / "tests/corpus"
DICTIONARY = [f"-dict={SOURCE}/tests/fuzz/deck.dict"]

# Each target: what it reads, the number of executions, folders of first inputs, options.
# HDF5 does not survive every damaged results file, so each of these runs in its own process.
TARGETS = {
    "mesh": ("READ9's meshes", 5000000, [SOURCE / "tests/data/mesh", CORPUS / "fuzz/mesh"],
             []),
    "deck": ("decks", 300000, [CORPUS / "bad", CORPUS / "fuzz/run"],
             [*DICTIONARY, "-max_len=1000"]),
    "wkt": ("WKT", 3000000, [CORPUS / "bad_exchange"], []),
    "geojson": ("GeoJSON", 2000000, [CORPUS / "bad_exchange"], []),
    "layer": ("layers to be cut", 20000, [CORPUS / "fuzz/layer"], []),
    "traces": ("traces and points, cut into blocks", 1000000,
               [CORPUS / "bad_traces", CORPUS / "fuzz/traces"], ["-max_len=1000"]),
    "run": ("decks, built and stepped", 5000, [CORPUS / "fuzz/run"], DICTIONARY),
    "checkpoint": ("checkpoints with a new checksum", 5000, [], []),
    "results": ("results", 5000, [], []),
}
# The sources of each reader that does not need the whole program.
READER = {"mesh": ["src/deck", "geometry"], "deck": ["src/deck", "geometry"],
          "wkt": ["src/deck", "src/exchange", "geometry"],
          "geojson": ["src/deck", "src/exchange", "geometry"]}
HEAD = ["# Fuzzing", "",
        "Written by `./go validate fuzz`; do not edit. libFuzzer, every execution under the "
        "address and undefined-behaviour sanitizers, with the checks of libstdc++ and "
        "Eigen.", "",
        "| target | reads | executions | inputs kept | crashes, hangs, leaks | run with |",
        "|---|---|---|---|---|---|"]


def parse_targets(words):
    """Maps each target to its executions, from words TARGET or TARGET=EXECUTIONS; all targets if
    there are no words. Ends the program if a target does not exist or a number is not one."""
    asked = {}
    for word in words or TARGETS:
        name, _, executions = word.partition("=")
        if name not in TARGETS:
            fail(f"there is no target {name}; the targets are {', '.join(TARGETS)}")
        if executions and not executions.isdigit():
            fail(f"{word}: {executions} is not a number of executions")
        asked[name] = int(executions or TARGETS[name][1])
    return asked


def fail(message):
    print(f"fuzz.py: error: {message}", file=sys.stderr)
    sys.exit(2)


def command_of(build, name, limit):
    """Returns the command that runs a target up to a limit, and makes the folders it needs."""
    _, _, folders, options = TARGETS[name]
    found = build.parent / "found" / name
    seeds = build.parent / "found/seeds" / name
    faults = build.parent / "found/crash" / name
    for folder in (found, seeds, faults):
        folder.mkdir(parents=True, exist_ok=True)
    return [build / f"tests/fuzz/fuzz_{name}", limit, "-timeout=60", "-rss_limit_mb=4096",
            "-print_final_stats=1", f"-artifact_prefix={faults}/", *options, found, seeds,
            *folders]


def fuzz(build, name, executions):
    """Runs a target; returns the executions made, the inputs kept and the exit code."""
    print(f"{name}: {TARGETS[name][0]}", flush=True)
    run = subprocess.run(command_of(build, name, f"-runs={executions}"), cwd=build, check=False,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    output = run.stdout.decode(errors="replace")
    found = build.parent / "found"
    (found / f"{name}.log").write_text(output)
    stats = dict(re.findall(r"stat::(\w+):\s+(\d+)", output))
    made = int(stats.get("number_of_executed_units", 0))
    kept = sum(1 for _ in (found / name).iterdir())
    print(f"  {made:,} executions, exit {run.returncode}", flush=True)
    return made, kept, run.returncode


def rows_of(page):
    """Maps each target to its row of an earlier page."""
    lines = page.read_text().splitlines() if page.exists() else []
    return {line.split("`")[1]: line for line in lines if line.startswith("| `")}


def row(name, made, kept, code, earlier):
    """Returns a row of the page; executions of an earlier row with the same sources are added."""
    sources = version.sources(READER.get(name, ["src", "geometry"]))
    clean = code == 0
    if earlier and sources in earlier:
        made += executions_of(earlier)
        clean = clean and "**" not in earlier
    return (f"| `{name}` | {TARGETS[name][0]} | {made:,} | {kept:,} | "
            f"{'0' if clean else '**found**'} | {sources} |")


def executions_of(line):
    return int(line.split("|")[3].replace(",", ""))


def main():
    reader = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    reader.add_argument("build", type=Path)
    reader.add_argument("report")
    reader.add_argument("targets", nargs="*")
    reader.add_argument("--seconds", type=int)
    arguments = reader.parse_intermixed_args()
    build, page = arguments.build.resolve(), Path(arguments.report + ".md")
    asked = parse_targets(arguments.targets)
    if {"checkpoint", "results"} & set(asked):
        subprocess.run([build / "tests/fuzz/fuzz_seeds", build.parent / "found/seeds"],
                       check=True)
    failed = 0
    for name, executions in asked.items():
        if arguments.seconds is not None:
            command = command_of(build, name, f"-max_total_time={arguments.seconds}")
            failed += subprocess.run(command, cwd=build, check=False).returncode != 0
            continue
        made, kept, code = fuzz(build, name, executions)
        failed += code != 0
        rows = rows_of(page)
        rows[name] = row(name, made, kept, code, rows.get(name))
        counts = [executions_of(line) for line in rows.values()]
        clean = not any("**" in line for line in rows.values())
        page.write_text("\n".join(
            HEAD + [rows[one] for one in TARGETS if one in rows]
            + ["", f"{sum(counts):,} executions, "
               + ("nothing found." if clean else "**faults found**."), ""]))
    return 4 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
