#!/usr/bin/python3
"""Runs the tests of reliability and writes their counts: report.py BUILD REPORT [WORD...].

BUILD is a build folder with the test programs, REPORT the page without its ending. With words,
only the rows that contain one of them are measured; the others are kept.
BLOCKS_THOROUGH in the environment makes the runs long; the page has their lengths.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import version

# Promise, how it is tested, program, filter of its tests, property with the count (None: the
# tests are counted), what is counted.
TESTS = [
    ("a run that is stopped anywhere and resumed has the same bits as an uninterrupted run",
     "every deck of `decks/`, at length of `validation/` and `tests/` too, stopped at "
     "random steps",
     "run/run_tests", "*ResumedDeck*",
     "splits", "stops"),
    ("a run that is killed at any moment does too, and its files are readable",
     "kill -9 at random moments, then resumed", "reliability/reliability_tests", "Killed.*",
     "kills", "kills"),
    ("a damaged checkpoint is refused", "one bit changed", "output/output_tests",
     "Checkpoint.RefusesAnyDamagedByte", "bytes", "bytes"),
    ("a checkpoint that no run can write is refused, whatever its checksum",
     "each value of a model forged", "output/output_tests",
     "ForgedCheckpoint.IsRefusedIfNoRunWritesTheValue", "forged", "forgeries"),
    ("a forged checkpoint that a run might write is refused or stepped",
     "each value of a model forged", "output/output_tests",
     "ForgedCheckpoint.IsRefusedOrMakesAStep", "forged", "forgeries"),
    ("the results file is complete at every moment", "the file between any two of its changes",
     "reliability/reliability_tests", "ResultsAtAnyMoment.*", "moments", "moments"),
    ("a full disk is reported, and existing files remain",
     "the disk is full from the n-th change of a file on", "reliability/reliability_tests",
     "FullDisk.*", "tried", "places"),
    ("failing memory is reported, and leaves no incomplete file",
     "the k-th request fails, once or from then on", "reliability/reliability_tests",
     "*FailingMemory*", "tried", "requests"),
    ("two programs that write files of one name lose and mix nothing",
     "started at the same time", "reliability/reliability_tests", "TwoAtOnce.*", "pairs", "pairs"),
    ("a bad card gets exactly its message", "a sound deck with one card spoilt",
     "run/run_tests", "*BadCard*", "decks", "decks"),
    ("a deck that cannot be read or built gets exactly its messages",
     "`tests/corpus/bad`", "deck/deck_tests", "*BadDeck.*", None, "decks"),
    ("", "`tests/corpus/bad_run`", "run/run_tests", "*BadRun.Gets*", None, "decks"),
    ("a file that is not a deck is refused with a short message and little memory",
     "binary, one line of 10 MB, counts of 1e12 ...", "reliability/reliability_tests",
     "WholeFile.*", None, "groups"),
    ("a deck changed at random is refused, runs or ends as unsound",
     "up to 4 changes", "reliability/reliability_tests", "Mutants.*", "tried", "decks"),
]

# Promise, how it is tested, script of the tests, its name in the table.
SCRIPTS = [
    ("readers refuse files whose structure is damaged, and name the file",
     "objects that are missing, of another type or shape, links, stored elsewhere, out of range",
     "tests/reliability/damaged_structure.py", "damaged_structure"),
]

# Target, options, inputs of a short and of a thorough run, folders.
FUZZ = [
    ("deck", [], 2000, 50000, ["tests/corpus/bad", "decks"]),
    ("run", [], 200, 10000, ["decks/every_card", "tests/corpus/fuzz/run"]),
    ("mesh", [], 5000, 500000, ["tests/data/mesh", "tests/corpus/fuzz/mesh"]),
    ("geojson", [], 2000, 100000, ["tests/corpus/bad_exchange"]),
    ("wkt", [], 2000, 100000, ["tests/corpus/bad_exchange"]),
    ("layer", [], 500, 20000, ["tests/corpus/fuzz/layer"]),
    ("traces", [], 2000, 100000, ["tests/corpus/bad_traces", "tests/corpus/fuzz/traces"]),
    ("results", ["--children"], 100, 3000, ["seeds/results"]),
    ("checkpoint", ["--children"], 100, 3000, ["seeds/checkpoint"]),
]


def run_tests(program, wanted):
    """Runs the wanted tests and returns their outcomes as reported by gtest."""
    with tempfile.TemporaryDirectory() as folder:
        told = Path(folder) / "outcome.json"
        subprocess.run([program, f"--gtest_filter={wanted}", f"--gtest_output=json:{told}"],
                       stdout=sys.stderr, check=False)
        if not told.exists():
            return []
        return [test for suite in json.loads(told.read_text())["testsuites"]
                for test in suite["testsuite"]]


def name_of(test):
    """Returns the name of a row: the filter of its tests."""
    return test[3].strip("*").rstrip(".")


def is_requested(text):
    return not sys.argv[3:] or any(word in text for word in sys.argv[3:])


def earlier_rows(page):
    """Maps each name to its row of the existing page."""
    rows = {}
    for line in page.read_text().splitlines():
        if line.startswith("| ") and "`" in line:
            promise, how, count, verdict = (cell.strip() for cell in line.split("|")[1:-1])
            rows[how.split("`")[-2]] = promise, how, count, verdict == "holds"
    return rows


def row_of_tests(build, test):
    promise, how, program, wanted, counted, unit = test
    tests = [one for one in run_tests(build / "tests" / program, wanted)
             if one["result"] == "COMPLETED"]
    sound = tests and not any("failures" in one for one in tests)
    count = sum(int(one.get(counted, 0)) for one in tests) if counted else len(tests)
    sound = sound and count > 0
    return promise, f"{how}: `{name_of(test)}`", f"{count:,} {unit}", sound


def row_of_fuzz(build, source, target):
    name, options, short, long, folders = target
    mutants = long if "BLOCKS_THOROUGH" in os.environ else short
    inputs = [str(build / "tests/fuzz" / folder if folder.startswith("seeds")
                  else source / folder) for folder in folders]
    with tempfile.TemporaryDirectory() as folder:
        outcome = subprocess.run([build / "tests/fuzz" / f"fuzz_{name}", *options,
                                  str(mutants), *inputs], cwd=folder, text=True,
                                 stdout=subprocess.PIPE, check=False)
    said = outcome.stdout.strip()
    count = sum(int(number) for number in re.findall(r"(\d+) (?:inputs|mutants)", said))
    told = re.search(r"(\d+) of them told", said)
    words = f"{count:,} inputs" + (f", HDF5 failed in {told[1]}" if told else "")
    return "", f"any bytes, mutants of a corpus: `fuzz_{name}`", words, outcome.returncode == 0


def row_of_script(build, source, script):
    promise, how, path, name = script
    outcome = subprocess.run(["/usr/bin/python3", source / path, build / "src/blocks", build / "python"],
                             text=True, stdout=subprocess.PIPE, check=False)
    count = sum(int(number) for number in re.findall(r"(\d+) inputs", outcome.stdout))
    return promise, f"{how}: `{name}`", f"{count:,} inputs", outcome.returncode == 0


def main():
    build, report = Path(sys.argv[1]).resolve(), Path(sys.argv[2] + ".md")
    source = Path(__file__).resolve().parents[2]
    earlier = earlier_rows(report) if sys.argv[3:] else {}
    subprocess.run([build / "tests/fuzz/fuzz_seeds", build / "tests/fuzz/seeds"], check=True)
    rows = [row_of_tests(build, test) if is_requested(test[1] + test[3]) or name_of(test) not in earlier else
            earlier[name_of(test)] for test in TESTS]
    rows += [row_of_script(build, source, script) if is_requested(script[3]) or script[3] not in earlier else
             earlier[script[3]] for script in SCRIPTS]
    fuzzed = [row_of_fuzz(build, source, target) if is_requested("fuzz_" + target[0]) else
              earlier["fuzz_" + target[0]] for target in FUZZ]
    fuzzed[0] = ("readers take any bytes, and cut any layer", *fuzzed[0][1:])
    lines = ["# What is promised of files and inputs, as tested", "",
             "Written by `./go validate reliability`; do not edit. What the promises mean: "
             "[docs/reliability.md](../../docs/reliability.md).", "",
             "| promise | how it is tested | count | verdict |", "|---|---|---|---|"]
    for promise, how, count, sound in rows + fuzzed:
        lines.append(f"| {promise} | {how} | {count} | {'holds' if sound else '**FAILS**'} |")
    failed = sum(not row[-1] for row in rows + fuzzed)
    lines += ["", "Every promise holds. " if failed == 0 else f"{failed} rows fail. ", ""]
    told = version.sentence()
    lines[-2] += "Latest rows: " + told[0].lower() + told[1:] if sys.argv[3:] else told
    report.write_text("\n".join(lines))
    print("\n".join(lines[5:]))
    return 4 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
