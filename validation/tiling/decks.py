#!/usr/bin/python3
"""Judges the blocks of decks by tiling.py: decks.py PROGRAM [DECKS]

The blocks of all decks must not overlap. Those of each LAYER and CUT must tile its outline, up to rounding. Blocks of
CREATE are as the deck gives them: twelve decimals of slanted corners overlap by 1e-12 of their size. Without decks,
those of the repository are judged. The exit code is 1 if a deck fails.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(Path(__file__).parent))
import tiling  # noqa: E402

MOTION = {"MOTION", "CYCLE", "SOLVE", "FOS", "REMOVE", "FREE", "STOP"}
DECIMALS = 1e-11  # of the size of a block: the digits that decks of CREATE give


def cards_of(text):
    """The cards before the first motion: lists of lines without comments."""
    cards = []
    for line in text.splitlines():
        line = re.split(r"[$!]", line)[0].strip()
        if re.match(r"[A-Za-z]", line):
            cards.append([line])
        elif line and cards:
            cards[-1].append(line)
        if cards and cards[-1][0].split(",")[0].upper() in MOTION:
            return cards[:-1]
    return cards


def numbers(text):
    return [float(word.upper().replace("D", "E")) for word in text.split(",") if word.strip()]


def outlines_of(cards):
    """The outlines of LAYER and OUTLINE cards, in their order."""
    layers, cuts = [], []
    for first, *more in cards:
        name, *words = first.split(",")
        if name.upper() == "LAYER":
            values = [float(word.replace("D", "E")) for word in (",".join([*words[2:], *more])).split(",")[:8]]
            layers.append(list(zip(values[::2], values[1::2])))
        elif name.upper() == "OUTLINE":
            values = numbers(",".join(more))
            cuts.append(list(zip(values[:len(values) // 2], values[len(values) // 2:])))
    return layers, cuts


def judge_deck(program, deck):
    """Yields the outline, the verdict, whether it is good, and its lines."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "blocks.geojson"
        # REMOVE takes blocks out of layers, so what follows is left out.
        text = deck.read_text()
        end = re.search(rf"^({'|'.join(MOTION)})\b", text, re.M | re.I)
        part = deck if end is None else Path(folder) / deck.name
        if end is not None:
            part.write_text(text[:end.start()])
            for other in deck.parent.iterdir():
                if other.is_file() and other.suffix not in (".deck", ".png", ".md"):
                    (Path(folder) / other.name).write_bytes(other.read_bytes())
        subprocess.run([program, "export", "-q", part, "-o", path], check=True, capture_output=True)
        told = json.loads(subprocess.run([program, "check", "--geometry", "--json", part], check=False,
                                         capture_output=True, text=True).stdout)
        blocks = tiling.read(path)
        numbered = [one["properties"]["number"] for one in json.loads(path.read_text())["features"]]
    verdict, good, lines = tiling.judge(blocks, None)
    if not good and verdict == "overlaps":
        deep = float(re.search(r"([\d.e+-]+) deep", "\n".join(lines))[1])
        if deep < DECIMALS * min(abs(float(tiling.twice_area(rings[0]))) ** 0.5 for rings in blocks):
            verdict, good = f"overlaps by the digits of the deck, {deep:.1g}", True
    yield "all", verdict, good, lines
    made = {"layer": told.get("layers", []), "cut": told.get("cuts", [])}
    for kind, outlines in zip(made, outlines_of(cards_of(text))):
        for record, outline in zip(made[kind], outlines, strict=True):
            first, count = record["first_block"], record["blocks"]
            mine = [rings for number, rings in zip(numbered, blocks) if first <= number < first + count]
            around = [[tiling.turned(tiling.ring(outline, "outline"), False)]]
            yield (f"{kind} {record[kind]}", *tiling.judge(mine, around))


def main():
    program = str(Path(sys.argv[1]).resolve())
    decks = [Path(name).resolve() for name in sys.argv[2:]] or sorted((ROOT / "decks").glob("*/*.deck"))
    failed = 0
    for deck in decks:
        for what, verdict, good, lines in judge_deck(program, deck):
            failed += not good
            print(f"{deck.stem}: {what}: {verdict}" + ("" if good else "\n  " + "\n  ".join(lines)))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
