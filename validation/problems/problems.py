#!/usr/bin/python3
"""Validation problems: problems.py PROGRAM [NAME...] [--quick] [--report] [--kept].

Runs the check of each problem, or of those named, and prints one line per row of its table. With
--quick it runs the problems that take about a second, and `blocks check` on all decks. With
--report it writes figures and results into the folders of the problems, and REPORT.md and
REPORT.html above them from these results and the kept ones of the others. Rows carry the program
that measured them. With --kept it runs nothing and lists the kept results of another program.

The exit code is 4 if a row misses that is not in known_misses.json of its problem, or misses by
other values; with --kept, if a result is of another program. It is 1 if a deck does not run.
"""

import argparse
import importlib.util
import json
import subprocess
import sys
import tempfile
import traceback
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
SOURCE = HERE.parents[1]
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True

from suite import program as programs  # noqa: E402
from suite import report  # noqa: E402
from suite.case import Case, Row, RunFailed  # noqa: E402

# The order of the report: from one block to many.
ORDER = (HERE / "order.txt").read_text().split()


def load(name):
    """Loads check.py of a problem: check(case), and LENGTH, "quick" or "long"."""
    spec = importlib.util.spec_from_file_location(f"check_{name}", HERE / name / "check.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def solve(name, program, write):
    """Runs the check of one problem and returns its rows and figures. If a deck does not run,
    "rows" is None and "before" has the rows until then. If the check raises an exception, because
    it cannot evaluate the results of its deck, a further row says so and misses."""
    with tempfile.TemporaryDirectory() as scratch:
        case = Case(HERE / name, program, Path(scratch), HERE / name if write else None)
        try:
            load(name).check(case)
            case.check_energy()
            assert case.rows, f"{name} checks nothing"
        except RunFailed as fault:
            return {"problem": name, "rows": None, "fault": str(fault),
                    "before": [row.as_dict() for row in case.rows]}
        except Exception as fault:  # The other problems must run in any case.
            traceback.print_exc()
            case.same("the check comes to its end", "yes", f"no: {type(fault).__name__}: {fault}",
                      "a check evaluates every answer, the wrong ones too")
    rows = [row.as_dict() for row in case.rows]
    rows += [row.as_dict() for row in explain(name, rows)]
    return {"problem": name, "rows": rows, "figures": case.charts, "runs": case.runs}


def explain(name, rows):
    """Adds to known misses their reason from known_misses.json:
    {quantity: {"between": [least, most], "why": why}}. A miss outside these values is new. Returns
    a row that misses for each entry without a row."""
    path = HERE / name / "known_misses.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    for row in rows:
        if row["quantity"] not in known:
            continue
        least, most = known[row["quantity"]]["between"]
        if row["holds"] is not False:
            print(f"{name}: {row['quantity']}: holds now; known_misses.json still has it",
                  flush=True)
        elif row["value"] is not None and least <= row["value"] <= most:
            row["note"] = known[row["quantity"]]["why"]
        else:
            row["reason"] += f". Known to miss, but between {least:g} and {most:g}"
    absent = sorted(set(known) - {row["quantity"] for row in rows})
    return [Row(quantity, "measured", "no such row", "", "the same",
                "known_misses.json explains rows that there are", False) for quantity in absent]


def check_decks(program):
    """Returns the decks that `blocks check` refuses, with its messages."""
    decks = sorted(HERE.glob("*/*.deck"))
    assert len(decks) > 20, decks
    outcomes = [(deck, subprocess.run([program, "check", deck], text=True, capture_output=True,
                                      check=False)) for deck in decks]
    return [f"{deck}: {done.stderr}" for deck, done in outcomes if done.returncode != 0]


def show(result):
    if result["rows"] is None:
        print(f"{result['problem']}: FAILED: {result['fault']}", flush=True)
    for row in result["before"] if result["rows"] is None else result["rows"]:
        expected = f", expected {row['expected']}" if row["expected"] else ""
        error = f", error {row['error']}" if row["error"] else ""
        print(f"{report.verdict(row):12} {result['problem']}: {row['quantity']}: "
              f"{row['ours']}{expected}{error}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--kept", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_intermixed_args()
    unknown = sorted(set(arguments.names) - set(ORDER))
    if unknown:
        print(f"problems.py: error: no problem {', '.join(unknown)}; there are: "
              f"{', '.join(ORDER)}", file=sys.stderr)
        return 2
    names = arguments.names or [name for name in ORDER
                            if not arguments.quick or load(name).LENGTH == "quick"]
    program = arguments.program.resolve()
    if arguments.kept:
        return 4 if print_kept(programs.identity(program, SOURCE), kept_results()) else 0
    with ThreadPoolExecutor(arguments.jobs) as workers:
        results = []
        for result in workers.map(lambda name: solve(name, program, arguments.report), names):
            show(result)
            results.append(result)
    refused = check_decks(program) if arguments.quick else []
    for words in refused:
        print(f"FAILED: {words}")
    failed = [result for result in results if result["rows"] is None]
    sound = [result for result in results if result["rows"] is not None]
    missed = [row for result in sound for row in result["rows"] if row["holds"] is False]
    new = sum(not row["note"] for row in missed)
    if arguments.report:
        who = programs.identity(program, SOURCE)
        write_report(results, who)
        print_kept(who, [result for result in kept_results() if result["problem"] not in names])
    print(f"{len(sound)} problems, {new} misses, {len(missed) - new} known misses"
          f"{f', {len(failed)} FAILED' if failed else ''}")
    return 1 if failed or refused else 4 if new else 0


def print_kept(who, kept):
    """Prints the kept results and their programs. Returns how many have other numerics."""
    print(f"this program: {programs.describe(who)}")
    others = 0
    for result in kept:
        by = result.get("program")
        other = not by or by["numerics"] != who["numerics"]
        others += other
        print(f"kept, not run now: {result['problem']}: {programs.describe(by)}"
              f"{': ANOTHER PROGRAM' if other else ''}")
    return others


def kept_results():
    """Returns the contents of result.json of the problems, in the order of the report."""
    paths = [HERE / name / "result.json" for name in ORDER]
    return [json.loads(path.read_text()) for path in paths if path.exists()]


def write_report(results, who):
    """Keeps these results and writes the report of all kept results."""
    for result in results:
        if result["rows"] is None:  # Otherwise the report would show an older result.
            row = Row("every deck runs", "yes", "no", "", "",
                      "; ".join(result["fault"].split("\n")), False)
            result = {"problem": result["problem"], "rows": [*result["before"], row.as_dict()],
                      "figures": [], "runs": 0}
        path = HERE / result["problem"] / "result.json"
        path.write_text(json.dumps({**result, "program": who}, indent=1) + "\n")
    kept = [{**result, "readme": (HERE / result["problem"] / "README.md").read_text()}
            for result in kept_results()]
    (HERE.parent / "REPORT.md").write_text(report.markdown(kept))
    (HERE.parent / "REPORT.html").write_text(report.html(kept, HERE))


if __name__ == "__main__":
    sys.exit(main())
