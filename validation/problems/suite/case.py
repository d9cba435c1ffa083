"""What the check of a problem uses to run decks, add rows to the table and draw figures."""

import itertools
import math
import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path

from .results import Results


@dataclass
class Row:
    """A row of the table."""
    quantity: str
    expected: str
    ours: str
    error: str
    tolerance: str
    reason: str
    holds: bool | None  # None: no known answer
    note: str = ""  # reason of a known miss (known_misses.json)
    value: float | None = None  # ours as a number, which a known miss limits

    def as_dict(self):
        return asdict(self)


class RunFailed(Exception):
    """A deck did not run to its end."""


def number(value, unit=""):
    """Formats a value with six digits and its unit."""
    if isinstance(value, float) and (math.isinf(value) or math.isnan(value)):
        return str(value)
    text = f"{value:.6g}"
    return f"{text} {unit}".strip()


def finite(value):
    """Returns the value for JSON: None if it is not finite."""
    return float(value) if math.isfinite(value) else None


def small(value):
    """Formats an error or a tolerance with two digits."""
    return "0" if value == 0 else f"{value:.2g}"


class Case:
    """The argument of check() in the check.py of a problem."""

    def __init__(self, folder, program, scratch, figures=None):
        self.folder, self.source = folder, folder.parents[2]
        self.program, self.scratch, self.figures = program, scratch, figures
        self.rows, self.charts, self.runs = [], [], 0
        self.energy_errors = []  # of each run, of the energy at play
        self._count = itertools.count(1)

    def text(self, deck):
        """Returns the text of a deck beside check.py, or of a path in the repository."""
        path = self.source / deck if "/" in deck else self.folder / deck
        return path.read_text()

    def run(self, deck, *options, text=None):
        """Runs a deck, or the text in its place, on one thread with options of `blocks run`."""
        stem = self.scratch / f"{Path(deck).stem}_{next(self._count)}"
        path = stem.with_name(stem.name + ".deck")
        path.write_text(with_account(self.text(deck) if text is None else text))
        log = stem.with_name(stem.name + ".log")
        with log.open("w") as sink:
            child = subprocess.Popen([self.program, "run", "-q", "-j", "1", path, "-o", stem,
                                      *map(str, options)], cwd=self.scratch, stdout=sink,
                                     stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            raise RunFailed(f"{path.name}: exit code {child.returncode}\n{log.read_text()}")
        self.runs += 1
        results = Results(stem, usage.ru_utime + usage.ru_stime, log.read_text())
        energy = results.summary.get("energy", {})
        if energy.get("at_play", 0) > 1e-15:  # J; blocks at rest have less, by round-off
            self.energy_errors.append(abs(energy["residual"]) / energy["at_play"])
        return results

    def run_all(self, decks):
        """Runs many decks, two at a time, each (deck, options, text or None). Returns the results
        in the same order."""
        with ThreadPoolExecutor(2) as workers:
            return list(workers.map(lambda one: self.run(one[0], *one[1], text=one[2]), decks))

    def equal(self, quantity, expected, ours, within, because, unit="", absolute=False):
        """Adds a row: |ours - expected| is at most `within`, relative unless absolute."""
        error = abs(ours - expected) if absolute else abs(ours - expected) / abs(expected)
        holds = bool(error <= within)  # False for NaN
        text_unit = unit if absolute else ""
        self.rows.append(Row(quantity, number(expected, unit), number(ours, unit),
                             f"{small(error)} {text_unit}".strip() if absolute else percent(error),
                             f"{small(within)} {text_unit}".strip() if absolute else percent(within),
                             because, holds, value=finite(ours)))

    def at_most(self, quantity, bound, ours, because, unit=""):
        """Adds a row: ours is at most the bound."""
        self.rows.append(Row(quantity, f"at most {number(bound, unit)}", number(ours, unit), "",
                             "the bound", because, bool(ours <= bound), value=finite(ours)))

    def at_least(self, quantity, bound, ours, because, unit=""):
        """Adds a row: ours is at least the bound."""
        self.rows.append(Row(quantity, f"at least {number(bound, unit)}", number(ours, unit), "",
                             "the bound", because, bool(ours >= bound), value=finite(ours)))

    def compared(self, quantity, expected, ours, because, unit=""):
        """Adds a row with an error but no verdict: the expected value is of another model."""
        self.rows.append(Row(quantity, number(expected, unit), number(ours, unit),
                             percent(abs(ours / expected - 1)), "none", because, None))

    def same(self, quantity, expected, ours, because):
        """Adds a row: ours is the expected text."""
        self.rows.append(Row(quantity, expected, ours, "", "the same", because, ours == expected))

    def measured(self, quantity, ours, because, unit=""):
        """Adds a row without a verdict: a measurement with no known answer."""
        value = ours if isinstance(ours, str) else number(ours, unit)
        self.rows.append(Row(quantity, "", value, "", "", because, None))

    def check_energy(self):
        """Adds a row: the energy account of every run closes."""
        if self.energy_errors:
            self.at_most("energy account: largest error of the sum in all runs, of the energy at "
                         "play", 1e-9, max(self.energy_errors), "round-off")

    def chart(self, chart):
        """Adds a figure: figure.svg, figure2.svg ... Writes it if there is a folder for figures."""
        name = "figure.svg" if not self.charts else f"figure{len(self.charts) + 1}.svg"
        self.charts.append(name)
        if self.figures is not None:
            (self.figures / name).write_text(chart.svg())

    def picture(self, results, *options):
        """Adds a figure of the blocks, by `blocks plot` with these options."""
        name = "blocks.png" if "blocks.png" not in self.charts else "blocks2.png"
        self.charts.append(name)
        if self.figures is not None:
            # The scratch folder is used because blocks plot keeps the picture that it replaces.
            subprocess.run([self.program, "plot", results.path, "-o", self.scratch / name,
                            "--units", "m,kg,s", *map(str, options)], check=True,
                           cwd=self.scratch, capture_output=True, text=True)
            shutil.copy(self.scratch / name, self.figures / name)


def with_account(deck):
    """Returns a deck that keeps an energy account, which does not change its motion."""
    lines = deck.splitlines()
    if any(line.upper().startswith("HISTORY") for line in lines):
        return deck
    first = next((i for i, line in enumerate(lines)
                  if re.match(r"(MOTION|CYCLE|SOLVE)\s*(,|$)", line, re.I)), len(lines))
    return "\n".join([*lines[:first], "HISTORY, 1E9, energy:residual", *lines[first:], ""])


def percent(share):
    """Formats 0.00123 as 0.12 %, and round-off as a power of ten."""
    return f"{small(100 * share)} %" if share >= 1e-6 or share == 0 else f"{share:.1e}"
