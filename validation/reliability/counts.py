#!/usr/bin/python3
"""Copies the counts of the reports in this folder to docs/reliability.md. With --check it changes
nothing and exits with 4 if the page has other counts."""

import re
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs/reliability.md"
BEGIN, END = "<!-- counts: by counts.py, do not edit -->\n", "<!-- end of the counts -->\n"
WHAT = [("FUZZ", "any bytes, by libFuzzer"), ("SANITIZERS", "every test under the sanitizers"),
        ("SAME_BITS", "the same bits from every compiler"), ("SOAK", "many steps of 850 blocks")]


def table(text):
    """Returns the rows of the first table of a page, without its head."""
    return [line for line in text.splitlines() if line.startswith("|")][2:]


def paragraphs(text):
    """Returns the plain paragraphs after the table."""
    return [part.replace("\n", " ") for part in text.strip().split("\n\n")
            if not part.startswith(("|", "#", "-", "Written by"))]


def wrapped(text, indent=""):
    return textwrap.fill(text, 100, subsequent_indent=indent, break_long_words=False,
                         break_on_hyphens=False)


def sanitizer(row):
    kind, passed, of, left_out, reports, minutes, who = re.split(r" *\| *", row.strip("| "))
    return (f"{kind}: {reports} reports; {passed} of {of} tests passed, {left_out} not run; "
            f"{minutes} minutes; {who}")


def counts():
    report = (HERE / "REPORT.md").read_text()
    lines = ["| promise | how it is tested | count | verdict |", "|---|---|---|---|",
             *table(report), "", *map(wrapped, paragraphs(report)), ""]
    for name, what in WHAT:
        page = HERE / f"{name}.md"
        if not page.exists():
            continue
        text = page.read_text()
        text_of_counts = " ".join(paragraphs(text))
        if name == "SANITIZERS":
            text_of_counts = ". ".join(sanitizer(row) for row in table(text)) + "."
        lines.append(wrapped(f"- {what[0].upper() + what[1:]}: {text_of_counts} "
                             f"([{name}.md](../validation/reliability/{name}.md))", "  "))
    return "\n".join(lines) + "\n"


def main():
    text = PAGE.read_text()
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    wanted = before + BEGIN + "\n" + counts() + "\n" + END + after
    if sys.argv[1:] == ["--check"]:
        if wanted != text:
            print("docs/reliability.md has other counts than the reports: run "
                  "validation/reliability/counts.py", file=sys.stderr)
            return 4
        return 0
    PAGE.write_text(wanted)
    return 0


if __name__ == "__main__":
    sys.exit(main())
