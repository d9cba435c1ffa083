#!/usr/bin/python3
"""Describes what a report was run with in one sentence: version of the program, hashes of the
contents of the sources (git rev-parse HEAD:src), day and number of cores."""

import os
import re
import subprocess
import time
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]


def git(*words):
    run = subprocess.run(["git", "-C", SOURCE, *words], capture_output=True, text=True,
                         check=False)
    return run.stdout.strip() if run.returncode == 0 else None


def sources(folders=("src", "geometry")):
    """Returns "blocks 1.0.0 (src 1a2b3c4, geometry 5d6e7f8)", without hashes outside of git."""
    version = re.search(r"project\(blocks VERSION ([\d.]+)",
                        (SOURCE / "CMakeLists.txt").read_text())[1]
    trees = [(folder, git("rev-parse", "--short=7", f"HEAD:{folder}"))
             for folder in folders]
    if not all(tree for _, tree in trees):
        return f"blocks {version}"
    changed = git("status", "--porcelain", "--", *folders)
    return (f"blocks {version} (" + ", ".join(f"{name} {tree}" for name, tree in trees)
            + (", with changes)" if changed else ")"))


def sentence():
    return (f"Run with {sources()} on {time.strftime('%Y-%m-%d', time.gmtime())}, "
            f"{os.cpu_count()} cores.")


if __name__ == "__main__":
    print("\n" + sentence())
