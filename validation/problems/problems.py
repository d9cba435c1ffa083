#!/usr/bin/python3
"""Validation problems: problems.py PROGRAM [NAME...] [--quick | --long] [--report].

Runs the check of each problem (all but the long ones; --long: these too; --quick: those that take
about a second, and `blocks check` on all decks) and prints one line per row of its table. With
--report figures and results are written beside the problems, and REPORT.md and REPORT.html, from
these results and the kept ones of the others, above them. Exit code 4 if a row misses, 1 if a deck
does not run.
"""

import argparse
import importlib.util
import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from suite import report  # noqa: E402
from suite.case import Case, Row, RunFailed  # noqa: E402

# in the order of the report: from one block to many
ORDER = (HERE / "order.txt").read_text().split()


def load(name):
    """check.py of a problem: check(case), and LENGTH, "quick", "medium" or "long"."""
    spec = importlib.util.spec_from_file_location(f"check_{name}", HERE / name / "check.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def solve(name, program, write):
    """Rows and figures of one problem; rows None if a deck did not run."""
    with tempfile.TemporaryDirectory() as scratch:
        case = Case(HERE / name, program, Path(scratch), HERE / name if write else None)
        try:
            load(name).check(case)
        except RunFailed as fault:
            return {"problem": name, "rows": None, "fault": str(fault)}
    assert case.rows, f"{name} checks nothing"
    return {"problem": name, "rows": [row.as_dict() for row in case.rows],
            "figures": case.charts, "runs": case.runs}


def check_decks(program):
    """Decks that `blocks check` refuses, with what it says."""
    decks = sorted(HERE.glob("*/*.deck"))
    assert len(decks) > 20, decks
    outcomes = [(deck, subprocess.run([program, "check", deck], text=True, capture_output=True,
                                      check=False)) for deck in decks]
    return [f"{deck}: {done.stderr}" for deck, done in outcomes if done.returncode != 0]


def show(result):
    if result["rows"] is None:
        print(f"{result['problem']}: FAILED: {result['fault']}", flush=True)
        return
    for row in result["rows"]:
        expected = f", expected {row['expected']}" if row["expected"] else ""
        error = f", error {row['error']}" if row["error"] else ""
        print(f"{report.verdict(row):6} {result['problem']}: {row['quantity']}: "
              f"{row['ours']}{expected}{error}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--long", action="store_true")
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_intermixed_args()
    unknown = sorted(set(asked.names) - set(ORDER))
    if unknown:
        print(f"problems.py: error: no problem {', '.join(unknown)}; there are: "
              f"{', '.join(ORDER)}", file=sys.stderr)
        return 2
    lengths = {"quick"} if asked.quick else {"quick", "medium", "long"} if asked.long \
        else {"quick", "medium"}
    names = asked.names or [name for name in ORDER if load(name).LENGTH in lengths]
    program = asked.program.resolve()
    with ThreadPoolExecutor(asked.jobs) as workers:
        results = []
        for result in workers.map(lambda name: solve(name, program, asked.report), names):
            show(result)
            results.append(result)
    refused = check_decks(program) if asked.quick else []
    for words in refused:
        print(f"FAILED: {words}")
    failed = [result for result in results if result["rows"] is None]
    sound = [result for result in results if result["rows"] is not None]
    missed = sum(row["holds"] is False for result in sound for row in result["rows"])
    if asked.report:
        write_report(results)
    print(f"{len(sound)} problems, {missed} misses{f', {len(failed)} FAILED' if failed else ''}")
    return 1 if failed or refused else 4 if missed else 0


def write_report(results):
    """Keeps these results, and writes the report from all that are kept."""
    for result in results:
        if result["rows"] is None:  # or the report would go on saying what once held
            row = Row("every deck runs", "yes", "no", "", "", "", False, result["fault"])
            result = {"problem": result["problem"], "rows": [row.as_dict()], "figures": [],
                      "runs": 0}
        path = HERE / result["problem"] / "result.json"
        path.write_text(json.dumps(result, indent=1) + "\n")
    kept = []
    for name in ORDER:
        path = HERE / name / "result.json"
        if path.exists():
            kept.append({**json.loads(path.read_text()),
                         "readme": (HERE / name / "README.md").read_text()})
    (HERE.parent / "REPORT.md").write_text(report.markdown(kept))
    (HERE.parent / "REPORT.html").write_text(report.html(kept, HERE))


if __name__ == "__main__":
    sys.exit(main())
