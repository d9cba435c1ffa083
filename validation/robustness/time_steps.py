#!/usr/bin/python3
"""Does the error of the integration in time fall with the time step?

time_steps.py PROGRAM [DECK...] [--report] runs each deck with its FRACTION, with half and with a
quarter of it, and with an energy account. It prints the entry `integration` at the end as a part of
the energy at play (docs/laws.md#energy). Decks that count steps (CYCLE) are left out, because they
end at another time. Without decks, those of the validation problems are run. --report writes
TIME_STEPS.md here.
"""

import argparse
import concurrent.futures
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))
from frames import PROBLEMS, copy_files, name_of, name_of_card, plain, run_deck  # noqa: E402

PARTS = (1.0, 0.5, 0.25)


def with_account(text, part):
    """Returns the deck with a part of its FRACTION and an energy account."""
    lines = text.splitlines()
    names = [name_of_card(line) for line in lines]
    if "CYCLE" in names or "FRACTION" not in names or "FOS" in names:
        raise ValueError("it counts steps, has no FRACTION, or has FOS")
    at = names.index("FRACTION")
    fraction = (re.split(r"[$!]", lines[at])[0].split(",") + [""])[1].strip()
    if not fraction:
        raise ValueError("FRACTION is blank")
    lines[at] = f"FRACTION, {part * float(fraction.upper().replace('D', 'E')):.17g}"
    first = min(names.index(name) for name in ("MOTION", "SOLVE") if name in names)
    lines.insert(first, "HISTORY, 1.E9, energy:integration")
    return "\n".join(lines) + "\n"


def errors_of(program, deck, seconds):
    """Returns the error of the integration, of the energy at play, for each part of FRACTION."""
    text, found = plain(deck.read_text()), []
    for part in PARTS:
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            copy_files(deck, folder)
            run_deck(program, with_account(text, part), folder, seconds)
            energy = json.loads((folder / "run.summary.json").read_text())["energy"]
            found.append(energy["integration"] / energy["at_play"] if energy["at_play"] else 0.0)
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program")
    parser.add_argument("decks", nargs="*", type=Path)
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--seconds", type=float, default=200, help="of one run, at most")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    program = Path(given.program).resolve()
    decks = [deck.resolve() for deck in given.decks] or sorted(PROBLEMS.glob("*/*.deck"))
    lines = ["| deck | FRACTION of the deck | half | a quarter | falls by |", "|---|---|---|---|---|"]
    print("\n".join(lines), flush=True)
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        rows = [(deck, pool.submit(errors_of, program, deck, given.seconds)) for deck in decks]
        for deck, future in rows:
            try:
                found = future.result()
            except (ValueError, subprocess.TimeoutExpired) as error:
                print(f"{name_of(deck)}: left out: {error}", file=sys.stderr)
                continue
            falls = f"{abs(found[0] / found[2]):.1f}" if found[2] else ""
            cells = " | ".join(f"{value:.1e}" for value in found)
            lines.append(f"| {name_of(deck)} | {cells} | {falls} |")
            print(lines[-1], flush=True)
    if given.report:
        (HERE / "TIME_STEPS.md").write_text(
            "# Time steps\n\nWritten by `./go validate steps`; do not edit. The error of the integration, "
            "as a part of the energy at play ([energy](../../docs/laws.md#energy)).\n\n"
            + "\n".join(lines) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
