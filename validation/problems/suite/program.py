"""Identifies the program that measured: version, commit and fingerprint of its arithmetic."""

import datetime
import hashlib
import json
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Short runs with everything that moves blocks: springs, dashpots, friction, planes, random
# layers, deformation, pressure, initial velocities.
RUNS = (("decks/bounce/bounce.deck", "MOTION.dt=0.5"),
        ("decks/sliding/sliding.deck", "MOTION.dt=0.2"),
        ("decks/crater/crater.deck", "MOTION.dt=0.01"),
        ("decks/subsidence/subsidence.deck", "MOTION.dt=0.02"),
        ("validation/problems/joint_wave/joint.deck", "MOTION.dt=0.02"))
# The sources on which a number of the report can depend.
FOLDERS = ("CMakeLists.txt", "geometry", "src/deck", "src/model", "src/dynamics", "src/run")


def fingerprint(program, source):
    """Returns eight digits from the last bits of five short runs. Two programs with the same
    digits compute the same results, even if their sources differ."""
    def state(run):
        deck, short = run
        with tempfile.TemporaryDirectory() as scratch:
            stem = Path(scratch) / "run"
            subprocess.run([program, "run", "-q", source / deck, "--set", short, "-o", stem],
                           check=True, capture_output=True, cwd=scratch)
            return json.loads((Path(scratch) / "run.summary.json").read_text())["state_hash"]

    with ThreadPoolExecutor(2) as workers:
        states = list(workers.map(state, RUNS))
    return hashlib.sha256(" ".join(states).encode()).hexdigest()[:8]


def commit(source):
    """Returns the last commit that changed these sources, with + if there are further changes."""
    def git(*words):
        done = subprocess.run(["git", "-C", source, *words, "--", *FOLDERS], text=True,
                              capture_output=True, check=False)
        return done.stdout.strip() if done.returncode == 0 else ""

    try:
        found = git("log", "-1", "--format=%h")
        return found + ("+" if git("status", "--porcelain") else "")
    except OSError:  # no git
        return ""


def identity(program, source):
    """Returns what is kept with the rows."""
    version = subprocess.run([program, "--version"], check=True, text=True, capture_output=True)
    return {"version": version.stdout.strip(), "commit": commit(source),
            "numerics": fingerprint(program, source),
            "day": datetime.date.today().isoformat()}


def describe(who):
    """Describes the program in words; rows of early reports have none."""
    if not who:
        return "a program not recorded"
    at = f", commit {who['commit']}" if who["commit"] else ""
    return f"{who['version']}{at}, numerics {who['numerics']}, {who['day']}"
