"""What the tests of the page of `blocks view` share: runs, pages, the numbers of the file, places on the screen."""

import csv
import io
import subprocess
import sys
import tempfile
from pathlib import Path

import browser


def with_browser(check):
    """Calls check(page, program, source, folder) with the arguments of the test, PROGRAM SOURCE [FOLDER]. Skips the
    test (77) without chromium."""
    program, source = Path(sys.argv[1]), Path(sys.argv[2])
    if browser.PROGRAM is None:
        print("skipped: no chromium")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(sys.argv[3] if len(sys.argv) > 3 else temporary)
        page = browser.Browser()
        try:
            check(page, program, source, folder)
        finally:
            page.close()


def run(program, deck, folder):
    """Runs a deck and returns the path of its results."""
    subprocess.run([program, "run", deck, "-q", "-o", folder / deck.stem], check=True, capture_output=True)
    return folder / f"{deck.stem}.vtkhdf"


def show(page, program, results, path, *options):
    """Makes the page of the results and opens it."""
    subprocess.run([program, "view", results, "-o", path, *options], check=True, capture_output=True)
    page.open(path)
    page.wait("document.documentElement?.dataset.ready === 'yes'")
    page.drawn()


def history(program, results, curves):
    done = subprocess.run([program, "history", results, "--csv", "-q", ",".join(curves)], capture_output=True, text=True,
                          check=True)
    return [{name.split(" (")[0]: float(value or "nan") for name, value in row.items()}  # "s11:4 (tension positive)"
            for row in csv.DictReader(io.StringIO(done.stdout))]


def same_number(shown, exact):
    """Whether the shown number has at least six digits of the number in the file."""
    digits = shown.split("e")[0].lstrip("-0.")
    # Zeros at the end of a whole number only fill its places.
    digits = digits.replace(".", "") if "." in digits else digits.rstrip("0")
    places = max(6, len(digits))
    return float(shown) == float(f"{exact:.{places}g}")


def screen(page, x, y):
    """Returns the place of a point of the model on the screen."""
    return page.evaluate(f"(() => {{ const box = $('model').getBoundingClientRect(), p = to_screen({x!r}, {y!r});"
                         "return [box.left + p[0], box.top + p[1]]; })()")
