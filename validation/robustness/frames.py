#!/usr/bin/python3
"""Do decks give the same answer in every frame?

frames.py PROGRAM [DECK...] [--quick] [--report] runs each deck as it is and in eight frames: turned
by 33, 45, 90 and -120 degrees, shifted by (30, -7) and by rounding, mirrored, with its blocks in the
opposite order, and twice as large. It prints the largest difference of the motion of the blocks at
the end, of the largest motion, and the part of the run until which the difference is below 1e-6.
Without decks, all shipped decks and those of the validation problems are run. A frame that a deck
cannot be put into has no entry. --report writes FRAMES.md here. --quick runs a few decks, and exits
with 1 if one of them differs by more than its limit.
"""

import argparse
import concurrent.futures
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "problems"))
from suite import deck as frames_of_decks  # noqa: E402
from suite.results import Results  # noqa: E402

PROBLEMS, DECKS = HERE.parent / "problems", ROOT / "decks"
LIMIT = 1e-6
# Decks of --quick, and by how much they may differ at the end.
QUICK = {"decks/stack": 1e-6, "decks/sliding": 1e-6, "decks/beam": 1e-6, "decks/wave": 1e-6,
         "problems/bonded/brick": 1e-6}


class Turned:
    """A frame turned anticlockwise by an angle, and then shifted."""

    def __init__(self, degrees, shift=(0.0, 0.0)):
        self.degrees, self.shift = degrees, shift

    def put(self, text):
        return frames_of_decks.turned(text, self.degrees, self.shift)

    def back(self, motion):
        """Motion of blocks, shape (frames, blocks, 2), in the frame of the deck."""
        c, s = math.cos(math.radians(self.degrees)), math.sin(math.radians(self.degrees))
        return motion @ np.array([[c, -s], [s, c]])


class Mirrored:
    def put(self, text):
        return frames_of_decks.mirrored(text)

    def back(self, motion):
        return motion * [-1, 1]


class Reversed:
    """The blocks in the opposite order."""

    def put(self, text):
        lines, blocks, places = text.splitlines(), [], []
        for k, line in enumerate(lines):
            name = name_of_card(line)
            if name in ("LAYER", "CLOOP", "READ9", "CUT", "PRESSBC", "FORCE", "FIX", "FREE", "REMOVE",
                        "SETVEL", "DRIVE", "SERVO", "QUIET"):
                raise ValueError(f"{name} counts blocks")
            if name == "CREATE":
                blocks.append(lines[k:k + 3])
                places.append(k)
        if len(blocks) < 2:
            raise ValueError("fewer than two blocks")
        for place, block in zip(places, reversed(blocks)):
            lines[place:place + 3] = block
        return "\n".join(lines) + "\n"

    def back(self, motion):
        return motion[:, ::-1]


class Doubled:
    """Twice as large: lengths, velocities and accelerations are doubled, so that times, masses and
    stresses stay. Doubles have the same digits then."""

    # Fields of a card that are multiplied by 2, 1/4 (densities) or 1/2 (stiffnesses per area).
    FACTORS = {"XLIMITS": {1: 2, 2: 2}, "YLIMITS": {1: 2, 2: 2}, "BOXES": {3: 2}, "MATERIAL": {4: 0.25},
               "CLOOP": {2: 2, 3: 2}, "GRAVITY": {1: 2, 2: 2}, "SETVEL": {3: 2, 4: 2},
               "SETVELM": {2: 2, 3: 2}, "FORCE": {2: 2, 3: 2}, "SPLANE": {1: 2, 2: 2, 3: 2, 4: 2},
               "DRIVE": {2: 2, 3: 2}, "LAYER": {k: 2 for k in range(3, 11)}, "INSITU": {4: .5, 5: .5, 6: .5},
               "JOINT": {9: 2, 10: 0.5, 11: 0.5}, "QUIET": {3: 2, 4: 2}}
    SAME = {"START", "STIFF", "RIGID", "FRACTION", "SEED", "END", "FUNCTION", "FIX", "FRICTN", "DAMPING",
            "MERGE", "ORIENT", "PRESSBC", "PLOTS", "MOTION", "CYCLE", "STOP", "JPAIR", "BOND", "LOCDAMP",
            "KINDAMP", "SOLVE", "MSCALE", "MDAMP", "REMOVE", "FREE", "CREATE"}
    WITH_LENGTHS = ("CREATE", "LAYER", "REMOVE", "FREE")  # lines of lengths follow

    def put(self, text):
        out, owner, title = [], "", False
        for line in text.splitlines():
            words = [word.strip() for word in re.split(r"[$!]", line)[0].split(",")]
            name = words[0].upper()
            if title or not name:
                out.append(line)
                title = False
            elif re.match(r"[-+.\d]", name):
                out.append(self.times(words, dict.fromkeys(range(len(words)), 2))
                           if owner in self.WITH_LENGTHS else line)
            elif name in self.FACTORS or name in self.SAME:
                out.append(self.times(words, self.FACTORS.get(name, {})))
                owner, title = name, name == "START"
            elif name != "UNITS":
                raise ValueError(f"no larger model is known for {name}")
        return "\n".join(out) + "\n"

    @staticmethod
    def times(words, factors):
        for k, factor in factors.items():
            if k < len(words) and words[k]:
                words[k] = f"{factor * float(words[k].upper().replace('D', 'E')):.17g}"
        return ", ".join(words)

    def back(self, motion):
        return motion / 2


FRAMES = {"33": Turned(33), "45": Turned(45), "90": Turned(90), "-120": Turned(-120),
          "shifted": Turned(0, (30.0, -7.0)), "by rounding": Turned(0, (1e-13, -1e-13)),
          "mirrored": Mirrored(), "reversed": Reversed(), "twice as large": Doubled()}


def name_of_card(line):
    return line.split(",")[0].strip().upper()


def plain(text):
    """Returns the deck without cards that only report, in one line each."""
    return "".join(line for line in text.splitlines(True)
                   if name_of_card(line) not in ("HISTORY", "OUTPUT", "DUMP", "SAVE"))


def resolved(program, text, folder):
    """Returns a deck that makes the same blocks by CREATE, if another one makes them at random or
    from files. Otherwise, or if sides have joint ids with laws, returns the deck."""
    making = {"CREATE", "CLOOP", "LAYER", "ORIENT", "MERGE", "SEED", "OUTLINE", "JSET", "VORONOI", "CUT",
              "TRACES", "READ9"}
    lines = text.splitlines()
    names = [name_of_card(line) for line in lines]
    end = min((names.index(name) for name in ("MOTION", "CYCLE", "SOLVE", "FOS") if name in names),
              default=len(names))
    if (not making.intersection(names) - {"CREATE", "CLOOP", "SEED"} or "REMOVE" in names[:end]
            or making.intersection(names[end:])):
        return text
    (folder / "made.deck").write_text(text)
    subprocess.run([program, "export", "made.deck", "-o", "made.geojson", "-q"], cwd=folder, check=True,
                   capture_output=True)
    features = json.loads((folder / "made.geojson").read_text())["features"]
    if "JOINT" in names and any(any(block["properties"].get("joints", [])) for block in features):
        return text
    out, owner, made = [], "", False
    for k, line in enumerate(lines):
        if names[k] in making or (not names[k] or re.match(r"[-+.\d]", names[k])) and owner in making:
            if names[k] in making and not made and names[k] != "SEED":
                for block in features:
                    ring = block["geometry"]["coordinates"][0][:-1]
                    of = block["properties"]
                    out += frames_of_decks.polygon([ring[0], *ring[:0:-1]], of["fixed"],
                                                   of["material"]).splitlines()
                made = True
        else:
            out.append(line)
        if re.match(r"[A-Z]", names[k]) and names[k - 1] != "START":
            owner = names[k]
    return "\n".join(out) + "\n"


def motion_of(program, text, folder, seconds):
    """Runs a deck. Returns the times of its frames, and the motion of its blocks."""
    folder.mkdir()
    (folder / "run.deck").write_text(text)
    done = subprocess.run([program, "run", "run.deck", "-q", "-j", "1"], cwd=folder, text=True,
                          capture_output=True, timeout=seconds, check=False)
    if done.returncode not in (0, 4) or not (folder / "run.summary.json").exists():
        raise ValueError(done.stderr.strip().splitlines()[0] if done.stderr.strip() else "no results")
    results = Results(folder / "run", 0)
    centroid = results.all("Centroid")[:, :, :2]
    return results.times, centroid - centroid[0]


def compare(program, deck, seconds):
    """Returns the name of a deck, and for each frame the difference at the end and the part of the
    run that agrees; None where the deck cannot be put into the frame."""
    row = {}
    text = plain(deck.read_text())
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        for file in deck.parent.iterdir():
            if file.is_file() and file.suffix in (".geojson", ".msh", ".txt", ".csv"):
                (folder / file.name).write_bytes(file.read_bytes())
        text = resolved(program, text, folder)
        times, motion = motion_of(program, text, folder / "0", seconds)
        largest = np.nanmax(np.abs(motion))
        if not largest > 0 or not np.isfinite(largest):
            return {}
        for name, frame in FRAMES.items():
            try:
                there = motion_of(program, frame.put(text), folder / name.replace(" ", "_"), seconds)[1]
            except (ValueError, subprocess.TimeoutExpired):
                row[name] = None
                continue
            count = min(len(there), len(motion))
            if there.shape[1] != motion.shape[1]:
                row[name] = (math.inf, 0.0)
                continue
            off = np.nanmax(np.abs(frame.back(there)[:count] - motion[:count]), axis=(1, 2)) / largest
            late = np.flatnonzero(off > LIMIT)
            agrees = times[late[0] - 1] if len(late) else times[-1]
            row[name] = (off[-1], agrees / times[-1])
    return row


def name_of(deck):
    path = deck.relative_to(ROOT)
    short = path.with_suffix("") if path.stem != path.parent.name else path.parent
    return str(short).removeprefix("validation/")


def cell(entry):
    if entry is None:
        return ""
    off, agrees = entry
    text = "0" if off == 0 else f"{off:.0e}".replace("e-0", "e-").replace("e+0", "e+")
    return text if off <= LIMIT else f"{text} ({100 * agrees:.0f} %)"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("program")
    parser.add_argument("decks", nargs="*", type=Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--report", action="store_true")
    parser.add_argument("--seconds", type=float, default=120, help="of one run, at most")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    program = Path(given.program).resolve()
    decks = [deck.resolve() for deck in given.decks] or sorted(
        [*DECKS.glob("*/*.deck"), *PROBLEMS.glob("*/*.deck")])
    if given.quick:
        decks = [deck for deck in decks if name_of(deck) in QUICK]
    lines = ["| deck | " + " | ".join(FRAMES) + " |", "|---|" + "---|" * len(FRAMES)]
    print("\n".join(lines), flush=True)
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        rows = [(deck, pool.submit(compare, program, deck, given.seconds)) for deck in decks]
        for deck, future in rows:
            try:
                row = future.result()
            except (ValueError, subprocess.TimeoutExpired, OSError) as error:
                print(f"{name_of(deck)}: left out: {error}", file=sys.stderr)
                continue
            if not row:
                continue
            lines.append(f"| {name_of(deck)} | " + " | ".join(cell(row[name]) for name in FRAMES) + " |")
            print(lines[-1], flush=True)
            limit = QUICK.get(name_of(deck), math.inf)
            failed += any(entry is not None and not entry[0] <= limit for entry in row.values())
    if given.report:
        (HERE / "FRAMES.md").write_text(
            "# Frames\n\nWritten by `./go validate frames`; do not edit. "
            "[Robustness](../../docs/robustness.md#decks-in-other-frames) explains the table.\n\n"
            + "\n".join(lines) + "\n")
    return 1 if given.quick and failed else 0


if __name__ == "__main__":
    sys.exit(main())
