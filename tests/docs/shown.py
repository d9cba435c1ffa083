"""Compares what pages show with what runs give.

`about` before a number means: within a quarter of it. Pages say so of rubble and cracks, where the
order in which numbers are rounded changes the course of a run. Other numbers hold to the last digit."""

import re

NUMBER = r"(-?\d[\d,]*(?:\.\d+)?(?:e-?\d+)?)"
ABOUT = 0.25


def value_of(text):
    return float(text.replace(",", ""))


def is_about(shown, value):
    return abs(value - shown) <= ABOUT * abs(shown)


def was_printed(line, printed):
    """Whether a line that a page shows is the printed one; `...` is any text.

    >>> was_printed("about 50 cracks ... 4.0 kJ", "about 62 cracks release 4.0 kJ")
    True
    >>> was_printed("about 50 cracks ... 4.0 kJ", "about 63 cracks release 4.0 kJ")
    False
    >>> was_printed("about 50 cracks ... 4.0 kJ", "about 62 cracks release 4.1 kJ")
    False
    >>> was_printed("50 cracks", "51 cracks")
    False
    """
    about = rf"\babout {NUMBER}"
    form = re.escape(re.sub(about, "about #", line)).replace(r"\.\.\.", ".*")
    found = re.fullmatch(form.replace(r"about\ \#", "about " + NUMBER), printed)
    return bool(found) and all(is_about(value_of(shown), value_of(value))
                               for shown, value in zip(re.findall(about, line), found.groups()))


def missing_lines(shown, printed):
    """Returns the lines that a page shows and that were not printed."""
    return [line for line in shown.splitlines()
            if not any(was_printed(line, other) for other in printed.splitlines())]
