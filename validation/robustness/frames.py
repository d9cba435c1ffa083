#!/usr/bin/python3
"""Do decks give the same answer in every frame?

frames.py PROGRAM [DECK...] [--quick] [--report] runs each deck as it is and in eight frames: turned
by 33, 45, 90 and -120 degrees, shifted by (30, -7) and by rounding, mirrored, with its blocks in the
opposite order, and twice as large. It prints the largest difference of the motion of the blocks at
the end, of the largest motion, and the part of the run until which the difference is below 1e-6.
Without decks, all shipped decks and those of the validation problems are run. A frame that a deck
cannot be put into has no entry. --report writes FRAMES.md here. --quick runs a few decks, and exits
with 1 if one of them differs by more than 1e-6.
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
MESH = "$ the blocks"  # stands for READ9 in decks whose blocks are resolved
# Decks of --quick, which may differ by LIMIT at the end.
QUICK = ("decks/bounce", "decks/cohesive_slope", "decks/direct_shear", "decks/sliding", "decks/stack",
         "decks/toppling", "decks/wave", "problems/bonded/overhang", "problems/notch", "problems/walton/square")


class Turned:
    """A frame turned anticlockwise by an angle, and then shifted."""

    def __init__(self, degrees, shift=(0.0, 0.0)):
        self.degrees, self.shift = degrees, shift

    def put(self, text):
        return frames_of_decks.turned(text, self.degrees, self.shift)

    def place(self, x, y):
        c, s = math.cos(math.radians(self.degrees)), math.sin(math.radians(self.degrees))
        return c * x - s * y + self.shift[0], s * x + c * y + self.shift[1]

    def back(self, motion):
        """Motion of blocks, shape (frames, blocks, 2), in the frame of the deck."""
        c, s = math.cos(math.radians(self.degrees)), math.sin(math.radians(self.degrees))
        return motion @ np.array([[c, -s], [s, c]])


class AsItIs(Turned):
    def __init__(self):
        super().__init__(0)

    def put(self, text):
        return text

    def place(self, x, y):
        return x, y


class Mirrored:
    def put(self, text):
        # Sides have other numbers in a mirror image.
        for line in text.splitlines():
            if name_of_card(line) in ("PRESSBC", "QUIET", "SERVO"):
                raise ValueError(f"no mirror image is known for {line}")
        return frames_of_decks.mirrored(text)

    def place(self, x, y):
        return -x, y

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
        if len(blocks) < 2 and MESH not in lines:
            raise ValueError("fewer than two blocks")
        for place, block in zip(places, reversed(blocks)):
            lines[place:place + 3] = block
        return "\n".join(lines) + "\n"

    def place(self, x, y):
        return x, y

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
               "JOINT": {9: 2, 10: 0.5, 11: 0.5}, "QUIET": {3: 2, 4: 2}, "WATER": {1: .5},
               "JWATER": {2: 2, 3: 2, 5: 2, 6: 2, 8: 2}}
    SAME = {"START", "STIFF", "RIGID", "FRACTION", "SEED", "END", "FUNCTION", "FIX", "FRICTN", "DAMPING",
            "MERGE", "ORIENT", "PRESSBC", "PLOTS", "MOTION", "CYCLE", "STOP", "JPAIR", "BOND", "LOCDAMP",
            "KINDAMP", "SOLVE", "MSCALE", "MDAMP", "REMOVE", "FREE", "CREATE"}
    WITH_LENGTHS = ("CREATE", "LAYER", "REMOVE", "FREE", "WATER")  # lines of lengths follow

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

    def place(self, x, y):
        return 2 * x, 2 * y

    def back(self, motion):
        return motion / 2


FRAMES = {"33": Turned(33), "45": Turned(45), "90": Turned(90), "-120": Turned(-120),
          "shifted": Turned(0, (30.0, -7.0)), "by rounding": Turned(0, (1e-13, -1e-13)),
          "mirrored": Mirrored(), "reversed": Reversed(), "twice as large": Doubled()}


def name_of_card(line):
    return line.split(",")[0].strip().upper()


def plain(text):
    """Returns the deck without cards that only report. Each of them has one line."""
    return "".join(line for line in text.splitlines(True)
                   if name_of_card(line) not in ("HISTORY", "OUTPUT", "DUMP", "SAVE"))


class Mesh:
    """The blocks of a deck: their materials, corners with the joint id of the side that begins there,
    and whether they are fixed."""

    def __init__(self, program, folder):
        for name in ("made.geojson", "made.txt"):
            subprocess.run([program, "export", "made.deck", "-o", name, "-q"], cwd=folder, check=True,
                           capture_output=True)
        features = json.loads((folder / "made.geojson").read_text())["features"]
        self.fixed = [block["properties"]["fixed"] for block in features]
        self.blocks = []
        for line in (folder / "made.txt").read_text().splitlines():
            words = [word.strip() for word in line.split(",")]
            if line.startswith(" "):
                self.blocks[-1][1].append((float(words[0]), float(words[1]), ", ".join(words[2:])))
            elif words[0].isdigit():
                self.blocks.append((words[1], []))

    def write(self, file, frame):
        """Writes the text form of READ9. Returns the cards that read it."""
        order = range(len(self.blocks))
        order = list(reversed(order)) if isinstance(frame, Reversed) else list(order)
        text = f"BLOCKS {len(order)}\n"
        for b in order:
            material, corners = self.blocks[b]
            text += f"{len(corners)}, {material}\n"
            for x, y, joint in corners:
                x, y = frame.place(x, y)
                text += f"{x:.17g}, {y:.17g}{', ' if joint else ''}{joint}\n"
        file.write_text(text)
        return "\n".join([f"READ9, {file.name}",
                          *(f"FIX, {k + 1}" for k, b in enumerate(order) if self.fixed[b])])


def resolved(program, text, folder):
    """Returns a deck whose blocks are those of a mesh, and the mesh, if the deck makes them at random
    or from files; otherwise the deck and None."""
    making = {"CREATE", "CLOOP", "LAYER", "ORIENT", "MERGE", "SEED", "OUTLINE", "JSET", "VORONOI", "CUT",
              "TRACES", "READ9", "FIX"}
    lines = text.splitlines()
    names = [name_of_card(line) for line in lines]
    end = min((names.index(name) for name in ("MOTION", "CYCLE", "SOLVE", "FOS") if name in names),
              default=len(names))
    if (not making.intersection(names) - {"CREATE", "CLOOP", "SEED", "FIX"} or "REMOVE" in names[:end]
            or making.intersection(names[end:])):
        return text, None
    (folder / "made.deck").write_text(text)
    out, owner = [], ""
    for k, line in enumerate(lines):
        follows = not re.match(r"[A-Z]", names[k])  # values of the card above, or a comment
        if names[k] in making or (follows and owner in making):
            if MESH not in out and names[k] in making - {"SEED"}:
                out.append(MESH)
        else:
            out.append(line)
        if not follows and names[k - 1] != "START":
            owner = names[k]
    return "\n".join(out) + "\n", Mesh(program, folder)


def copy_files(deck, folder):
    """Copies the files beside a deck that its cards may read."""
    for file in deck.parent.iterdir():
        if file.is_file() and file.suffix in (".geojson", ".msh", ".txt", ".csv"):
            (folder / file.name).write_bytes(file.read_bytes())


def run_deck(program, text, folder, seconds):
    """Runs a deck as run.deck in a folder. Raises a ValueError with the first line of what the
    program wrote if there are no results."""
    (folder / "run.deck").write_text(text)
    done = subprocess.run([program, "run", "run.deck", "-q", "-j", "1"], cwd=folder, text=True,
                          capture_output=True, timeout=seconds, check=False)
    if done.returncode not in (0, 4) or not (folder / "run.summary.json").exists():
        raise ValueError((done.stderr.strip().splitlines() or ["no results"])[0])


def motion_of(program, text, folder, seconds):
    """Runs a deck. Returns the times of its frames, and the motion of its blocks."""
    folder.mkdir()
    run_deck(program, text, folder, seconds)
    results = Results(folder / "run", 0)
    centroid = results.all("Centroid")[:, :, :2]
    return results.times, centroid - centroid[0]


def compare(program, deck, seconds):
    """Returns for each frame the difference at the end and the part of the run that agrees; None where
    the deck cannot be put into the frame."""
    row = {}
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        copy_files(deck, folder)
        text, mesh = resolved(program, plain(deck.read_text()), folder)

        def run(name, frame):
            cards = mesh.write(folder / f"{name}.txt", frame) if mesh else ""
            cards = cards.replace("READ9, ", "READ9, ../")
            return motion_of(program, frame.put(text).replace(MESH, cards), folder / name, seconds)

        times, motion = run("as_it_is", AsItIs())
        largest = np.nanmax(np.abs(motion))
        if not largest > 0 or not np.isfinite(largest):
            return {}
        for name, frame in FRAMES.items():
            try:
                there = frame.back(run(name.replace(" ", "_"), frame)[1])
            except (ValueError, subprocess.TimeoutExpired):
                row[name] = None
                continue
            frames, blocks = (min(a, b) for a, b in zip(there.shape[:2], motion.shape[:2]))
            off = np.abs(there[:frames, :blocks] - motion[:frames, :blocks]) / largest
            off = np.nanmax(off, axis=(1, 2))
            late = np.flatnonzero(off > LIMIT)
            row[name] = (off[-1], times[late[0] - 1] / times[-1] if len(late) else 1.0)
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
            entries = [entry for entry in row.values() if entry is not None]
            failed += len(entries) < 5 or any(not off <= LIMIT for off, _ in entries)
    if given.report:
        (HERE / "FRAMES.md").write_text(
            "# Frames\n\nWritten by `./go validate frames`; do not edit. "
            "[Robustness](../../docs/robustness.md#decks-in-other-frames) explains the table.\n\n"
            + "\n".join(lines) + "\n")
    return 1 if given.quick and (failed or len(lines) != 2 + len(QUICK)) else 0


if __name__ == "__main__":
    sys.exit(main())
