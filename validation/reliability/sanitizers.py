#!/usr/bin/python3
"""Runs every test under a sanitizer and counts the reports of all processes:
sanitizers.py KIND BUILD REPORT [ctest options]. KIND is asan (address, undefined) or tsan.

BUILD is a build of that kind, REPORT the page without its ending. The row of the other kind stays
as it is. The sanitizers write to files, so reports of child processes are found even if a test
ignores their exit codes.
"""

import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import version

LEAKS = Path(__file__).resolve().parent / "leaks.supp"
KINDS = {"asan": "address and undefined behaviour", "tsan": "threads"}
HEAD = ["# Every test under the sanitizers", "",
        "Written by `./go validate asan` and `./go validate tsan`; do not edit. Reports are counted from all "
        "processes, also those that a test starts.", "",
        "| sanitizer | tests passed | of | not run | reports | minutes | run with |",
        "|---|---|---|---|---|---|---|"]


def environment(reports):
    """Returns the environment with the options of every sanitizer, followed by those of the user."""
    options = {"ASAN_OPTIONS": "verify_asan_link_order=0", "UBSAN_OPTIONS":
               "print_stacktrace=1", "TSAN_OPTIONS": "",
               "LSAN_OPTIONS": f"print_suppressions=0:suppressions={LEAKS}"}
    result = dict(os.environ)
    for name, value in options.items():
        result[name] = ":".join(filter(None, [value, f"log_path={reports}/{name[:4]}",
                                              result.get(name, "")]))
    return result


def output_of(command, environment):
    """Runs the command, prints its output as it appears, and returns it."""
    with subprocess.Popen(command, env=environment, text=True, errors="replace",
                          stdout=subprocess.PIPE) as run:
        lines = []
        for line in run.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    return "".join(lines)


def main():
    kind, build, page = sys.argv[1], sys.argv[2], Path(sys.argv[3] + ".md")
    began = time.time()
    with tempfile.TemporaryDirectory() as reports:
        output = output_of(["ctest", "--test-dir", build, "--output-on-failure",
                        "-j", str(os.cpu_count()), *sys.argv[4:]], environment(reports))
        found = sorted(Path(reports).iterdir())
        texts = [one.read_text(errors="replace") for one in found]
    for text in texts[:10]:
        print(text[:5000])
    summary = re.search(r"(\d+) tests failed out of (\d+)", output)
    failed, of = map(int, summary.groups()) if summary else (0, 0)
    left_out = len(re.findall(r"\(Disabled\)|\*\*\*Skipped", output))
    rows = {line.split("`")[1]: line for line in
            (page.read_text().splitlines() if page.exists() else [])
            if line.startswith("| `")}
    rows[kind] = (f"| `{kind}`: {KINDS[kind]} | {of - failed - left_out} | {of} | "
                  f"{left_out} | {len(texts)} | {(time.time() - began) / 60:.0f} | "
                  f"{version.sources()} |")
    page.write_text("\n".join(HEAD + [rows[one] for one in KINDS if one in rows] + [""]))
    return 4 if failed or texts or not of else 0


if __name__ == "__main__":
    sys.exit(main())
