"""Which program measured: its version, its commit, and a fingerprint of its arithmetic."""

import datetime
import hashlib
import json
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# short, and with all that moves blocks: springs, dashpots, friction, planes, random layers,
# deformation, pressure, initial velocities
RUNS = (("decks/bounce/bounce.deck", "MOTION.dt=0.5"),
        ("decks/sliding/sliding.deck", "MOTION.dt=0.2"),
        ("decks/crater/crater.deck", "MOTION.dt=0.01"),
        ("decks/subsidence/subsidence.deck", "MOTION.dt=0.02"),
        ("validation/problems/joint_wave/joint.deck", "MOTION.dt=0.02"))
# what a number of the report can depend on
FOLDERS = ("CMakeLists.txt", "geometry", "src/deck", "src/model", "src/dynamics", "src/run")


def fingerprint(program, source):
    """Eight digits from the last bits of five short runs: two programs that share them compute
    alike, whatever their texts say."""
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
    """The last commit that changed what a number can depend on; + if there is more than it."""
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
    """All of it, as it is kept with the rows."""
    version = subprocess.run([program, "--version"], check=True, text=True, capture_output=True)
    return {"version": version.stdout.strip(), "commit": commit(source),
            "numerics": fingerprint(program, source),
            "day": datetime.date.today().isoformat()}


def told(who):
    """In words; rows of before there were stamps have none."""
    if not who:
        return "a program not recorded"
    at = f", commit {who['commit']}" if who["commit"] else ""
    return f"{who['version']}{at}, numerics {who['numerics']}, {who['day']}"
