#!/usr/bin/python3
"""The documentation is a test: check_docs.py {links|tutorial|commands} SOURCE [PROGRAM]."""

import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

FENCE = re.compile(r"^```(\S+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)


def pages(source):
    found = [*source.glob("*.md"), *source.glob("docs/*.md"), *source.glob("decks/*/*.md"),
             *source.glob("validation/**/*.md")]
    assert len(found) > 10, found
    return found


def anchors(text):
    """Headings as forges name them: lower case, no punctuation, dashes for blanks."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def check_links(source):
    """Every relative link points to a file, and its anchor to a heading there."""
    count, faults = 0, []
    for page in pages(source):
        for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
            if "://" in link:
                continue
            count += 1
            name, _, anchor = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists():
                faults.append(f"{page}: no file {link}")
            elif anchor and anchor not in anchors(target.read_text()):
                faults.append(f"{page}: no heading {link}")
    assert count > 10, count
    return faults


def missing_lines(shown, printed):
    """Lines shown that were not printed; `...` stands for any text."""
    lines = printed.splitlines()
    for line in shown.splitlines():
        form = ".*".join(re.escape(part) for part in line.split("..."))
        if not any(re.fullmatch(form, other) for other in lines):
            yield line


def check_tutorial(source, program):
    """Decks are written, commands and Python run, and what is shown was printed."""
    environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}"}
    printed, faults, kinds = "", [], set()
    with tempfile.TemporaryDirectory() as folder:
        for kind, name, text in FENCE.findall((source / "docs/tutorial.md").read_text()):
            kinds.add(kind)
            if kind == "deck":
                Path(folder, name).write_text(text)
                continue
            if kind == "text":
                faults += [f"not printed: {line}" for line in missing_lines(text, printed)]
                continue
            command = {"sh": ["sh", "-e", "-c", text], "python": [sys.executable, "-c", text]}[kind]
            done = subprocess.run(command, cwd=folder, env=environment, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            printed = done.stdout
            if done.returncode:
                return [*faults, f"exit code {done.returncode}:\n{text}{printed}"]
    assert kinds == {"deck", "sh", "text", "python"}, kinds
    return faults


def check_commands(source, program):
    """Command lines are accepted: run becomes check, figures lack their results."""
    count, faults = 0, []
    with tempfile.TemporaryDirectory() as folder:
        for page in [source / "README.md", *source.glob("decks/*/README.md")]:
            text = page.read_text()
            for line in re.findall(r"(?:^    |`)\./go ((?:run|blocks) [^`\n]*)", text, re.M):
                line = re.sub(r"\[[A-Z]+\]", "", line).replace("DECK", "decks/stack/stack.deck")
                words = shlex.split(line, comments=True)
                words = words[1:] if words[0] == "blocks" else ["check", *words[1:]]
                words = [str(source / word) if word.startswith("decks/") else word for word in words]
                done = subprocess.run([program, *words], cwd=folder, text=True, capture_output=True)
                count += 1
                if done.returncode != (5 if words[0] in ("plot", "history", "view", "why", "import") else 0):
                    faults.append(f"{page}: {line}: exit code {done.returncode}\n{done.stderr}")
    assert count > 10, count
    return faults


def main():
    what, source, *program = sys.argv[1:]
    check = {"links": check_links, "tutorial": check_tutorial, "commands": check_commands}[what]
    faults = check(Path(source), *map(Path, program))
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
