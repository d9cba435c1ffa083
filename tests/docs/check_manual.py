#!/usr/bin/python3
"""Compares man pages and bash completion with the program: check_manual.py PROGRAM."""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

program = Path(sys.argv[1])


def blocks(*words):
    done = subprocess.run([program, *words], text=True, capture_output=True)
    assert done.returncode == 0, (words, done.stderr)
    return done.stdout


def plain(page):
    """Returns the words of a page as they are shown."""
    page = re.sub(r"\\f[BIR]|\\&", "", page)
    for escaped, shown in ((r"\-", "-"), (r"\(ha", "^"), (r"\(ga", "`"), (r"\(ti", "~"), (r"\e", "\\")):
        page = page.replace(escaped, shown)
    return page


def check_formatting(pages):
    """The formatter, if it is installed, has no warnings."""
    tools = [tool for tool in (["groff", "-man", "-ww", "-Tutf8", "-z"], ["mandoc", "-T", "lint", "-W", "error"])
             if shutil.which(tool[0])]
    for tool in tools:
        for page in pages:
            done = subprocess.run(tool, input=page, text=True, capture_output=True)
            assert done.returncode == 0 and not done.stderr, (tool, done.stderr)


def check_program_page(page):
    """The page has every command and every option of --help."""
    commands = re.findall(r"^  (\w+) +\S", blocks("--help").split("Subcommands:")[1], re.M)
    assert len(commands) > 8, commands
    for name in commands:
        parts = {"study": ["contacts"], "joints": ["statistics"]}.get(name, [])
        words = [name, *parts]
        section = page.split(f"\n.SS blocks {' '.join(words)}", 1)[1].split("\n.S", 1)[0]
        options = re.findall(r"(?:^  |,)(--?[a-z][\w-]*)", blocks(*words, "--help"), re.M)
        assert len(options) > 1, name
        for option in options:
            assert option in ("-h", "--help") or re.search(rf"(^|, ){option}\b", section, re.M), (name, option)


def check_deck_page(page):
    """The page has every card with its syntax and its example."""
    cards = re.findall(r"^  ([A-Z]\w+) ", blocks("cards"), re.M)
    assert len(cards) > 30, cards
    for name in cards:
        section = page.split(f"\n.SS {name}\n", 1)[1].split("\n.S", 1)[0]
        syntax, *_ = blocks("cards", name).splitlines()
        example = blocks("cards", name).split("\nExample\n")[1]
        for line in [syntax, *(line.strip() for line in example.splitlines())]:
            assert line in section.splitlines(), (name, line)


def check_completion(script, folder):
    for name in ("wall.deck", "wall.vtkhdf", "wall.ckpt.h5", "notes.txt", "a folder"):
        path = folder / name
        path.mkdir() if name == "a folder" else path.write_text("")

    def offered(line):
        """Returns the completions of bash after the last word of the line."""
        words = line.split(" ")
        code = ('source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _blocks; '
                'printf "%s\\n" "${COMPREPLY[@]}"')
        done = subprocess.run(["bash", "-c", code, script, *words], cwd=folder, text=True, capture_output=True)
        assert done.returncode == 0 and not done.stderr, (line, done.stderr)
        return sorted(done.stdout.split("\n")[:-1])

    for line, expected in {
        "blocks pl": ["plot"],
        "blocks run w": ["wall.deck"],
        "blocks run ": ["a folder", "wall.deck"],
        "blocks why w": ["wall.ckpt.h5", "wall.vtkhdf"],
        "blocks run x.deck --restart ": ["a folder", "wall.ckpt.h5"],
        "blocks export wall": ["wall.deck", "wall.vtkhdf"],
        "blocks import n": ["notes.txt"],
        "blocks plot --ori": ["--original"],
        "blocks plot x.vtkhdf --arrows v": ["velocity"],
        "blocks plot x.vtkhdf --colour shear": ["shear_force"],
        "blocks run --time-limit ": [""],
        "blocks cards GRA": ["GRAVITY"],
        "blocks cards --set w": ["wall.deck"],
        "blocks joints ": ["fit", "statistics"],
        "blocks joints fit n": ["notes.txt"],
        "blocks study ": ["contacts"],
        "blocks study contacts --vari": ["--variants"],
        "blocks manual ": ["bash", "deck", "program"],
    }.items():
        assert offered(line) == sorted(expected), (line, offered(line))


def check_lost_output():
    """A page that cannot be printed is an error."""
    with open("/dev/full", "w") as full:
        for words in (["manual", "deck"], ["cards", "--markdown"], ["--version"]):
            done = subprocess.run([program, *words], stdout=full, stderr=subprocess.PIPE, text=True)
            assert done.returncode == 5, (words, done.returncode)
            assert done.stderr.startswith("blocks: error: cannot write standard output"), done.stderr


def main():
    check_lost_output()
    program_page, deck_page = blocks("manual", "program"), blocks("manual", "deck")
    check_formatting([program_page, deck_page])
    check_program_page(plain(program_page))
    check_deck_page(plain(deck_page))
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder, "completion")
        blocks("manual", "bash", "-o", script)
        decks = Path(folder, "decks")
        decks.mkdir()
        check_completion(script, decks)


main()
