#!/usr/bin/python3
"""libFuzzer on every reader for so many executions, with the address and
undefined-behaviour sanitizers: fuzz.py BUILD REPORT [TARGET[=EXECUTIONS]...].

BUILD: of the fuzz preset. REPORT: the page without its ending; rows of targets that are
not run stay as they are, and executions with the same sources add up. Inputs found are kept in
BUILD/../found/TARGET and are where the next run begins.
"""

import re
import subprocess
import sys
from pathlib import Path

import version

SOURCE = Path(__file__).resolve().parents[2]
CORPUS = SOURCE / "tests/corpus"
DICTIONARY = [f"-dict={SOURCE}/tests/fuzz/deck.dict"]

# target: what it reads, executions, folders of first inputs, options. HDF5 does not
# survive every damaged file of results, so each of these has a process of its own.
TARGETS = {
    "mesh": ("READ9's meshes", 5000000, [SOURCE / "tests/data/mesh", CORPUS / "fuzz/mesh"],
             []),
    "deck": ("decks", 300000, [CORPUS / "bad", CORPUS / "fuzz/run"],
             [*DICTIONARY, "-max_len=1000"]),
    "wkt": ("WKT", 3000000, [CORPUS / "bad_exchange"], []),
    "geojson": ("GeoJSON", 2000000, [CORPUS / "bad_exchange"], []),
    "layer": ("layers to be cut", 20000, [CORPUS / "fuzz/layer"], []),
    "run": ("decks, built and stepped", 5000, [CORPUS / "fuzz/run"], DICTIONARY),
    "checkpoint": ("checkpoints, sealed anew", 5000, [], []),
    "results": ("results", 5000, [], []),
}
# What a reader is made of, where it is not the whole program.
READER = {"mesh": ["src/deck", "geometry"], "deck": ["src/deck", "geometry"],
          "wkt": ["src/deck", "src/exchange", "geometry"],
          "geojson": ["src/deck", "src/exchange", "geometry"]}
HEAD = ["# Fuzzing", "",
        "Written by `./go validate fuzz`; do not edit. libFuzzer, every execution under the "
        "address and undefined-behaviour sanitizers, with the checks of libstdc++ and "
        "Eigen.", "",
        "| target | reads | executions | inputs kept | crashes, hangs, leaks | run with |",
        "|---|---|---|---|---|---|"]


def fuzz(build, name, executions):
    """Executions made, inputs kept, faults found."""
    reads, _, folders, options = TARGETS[name]
    found = build.parent / "found" / name
    seeds = build.parent / "found/seeds" / name
    faults = build.parent / "found/crash" / name
    for folder in (found, seeds, faults):
        folder.mkdir(parents=True, exist_ok=True)
    print(f"{name}: {reads}", flush=True)
    run = subprocess.run(
        [build / f"tests/fuzz/fuzz_{name}", f"-runs={executions}", "-timeout=60",
         "-rss_limit_mb=4096", "-print_final_stats=1", f"-artifact_prefix={faults}/",
         *options, found, seeds, *folders],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, cwd=build, check=False)
    told = run.stdout.decode(errors="replace")
    (build.parent / "found" / f"{name}.log").write_text(told)
    stats = dict(re.findall(r"stat::(\w+):\s+(\d+)", told))
    made = int(stats.get("number_of_executed_units", 0))
    kept = sum(1 for _ in found.iterdir())
    print(f"  {made:,} executions, exit {run.returncode}", flush=True)
    return made, kept, run.returncode


def rows_of(page):
    """Target to row of an earlier page."""
    lines = page.read_text().splitlines() if page.exists() else []
    return {line.split("`")[1]: line for line in lines if line.startswith("| `")}


def row(name, made, kept, code, earlier):
    """With the executions of an earlier row of the same sources."""
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
    build, page = Path(sys.argv[1]).resolve(), Path(sys.argv[2] + ".md")
    asked = dict((name.split("=") + [None])[:2] for name in sys.argv[3:]) \
        or dict.fromkeys(TARGETS)
    if unknown := set(asked) - set(TARGETS):
        print(f"blocks: error: no target {', '.join(unknown)}; there are "
              + ", ".join(TARGETS), file=sys.stderr)
        return 2
    if {"checkpoint", "results"} & set(asked):
        subprocess.run([build / "tests/fuzz/fuzz_seeds", build.parent / "found/seeds"],
                       check=True)
    failed = 0
    for name, executions in asked.items():
        made, kept, code = fuzz(build, name, int(executions or TARGETS[name][1]))
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
