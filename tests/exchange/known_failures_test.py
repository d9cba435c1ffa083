#!/usr/bin/python3
"""Networks on which other programs fail (tests/corpus/known_failures), and random variations of them:
known_failures_test.py PROGRAM SOURCE

Each deck says what to expect. Its blocks are judged by validation/tiling/tiling.py, which shares nothing
with the program. Variations are of two kinds:
- moved exactly: turned by angles with decimal sines and cosines, mirrored, scaled by 1e-6 to 1e6 and
  shifted, in decimals without any rounding. So the same blocks are expected, whatever the place.
- moved and rounded: turned by any angle, rounded to doubles and moved by up to two units in the last
  place. Ends may then be off other joints, so snap is given. Decks that say so have the same blocks, some
  of them if emin and amin are given too. The others have joints that coincide or touch, and tile the outline
  or are refused with a place and a proposal.
"""

import json
import math
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from decimal import Context, Decimal, setcontext
from pathlib import Path

sys.dont_write_bytecode = True
PROGRAM, SOURCE = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]).resolve()
sys.path.insert(0, str(SOURCE / "validation/tiling"))
import tiling  # noqa: E402

CORPUS = SOURCE / "tests/corpus/known_failures"
EXACT, ROUNDED = 5, 4
REPAIRED = 1024  # units in the last place that the repair of cells moves points by (docs/joints.md#repair)
TURNS = [("1", "0"), ("0", "1"), ("-1", "0"), ("0.6", "0.8"), ("-0.28", "0.96"), ("0.352", "-0.936")]
NUMBER = r"-?\d+(?:\.\d+)?(?:[Ee][-+]?\d+)?"
setcontext(Context(prec=80))


class Case:
    """A deck of the corpus: its outline, traces and expectation."""

    def __init__(self, path):
        self.name, self.text = path.stem, path.read_text()
        said = re.search(r"^\$ expected: (.*)$", self.text, re.M)[1]
        self.given, _, self.proposed = said.partition("; as proposed: ")
        x, y = (line.split(",") for line in re.search(r"^OUTLINE.*\n(.*)\n(.*)$", self.text, re.M).groups())
        self.outline = [(Decimal(a.strip()), Decimal(b.strip())) for a, b in zip(x, y)]
        self.size = max(abs(a - b) for p, q in zip(self.outline, self.outline[1:]) for a, b in zip(p, q))
        self.files = {name: (CORPUS / name).read_text() for name in re.findall(r"^TRACES, ([\w.]+)", self.text, re.M)}
        self.is_stable = "\n$ stable: " in self.text
        self.is_cleaned = "\n$ cleaned: " in self.text

    def moved(self, point, size_of):
        """The deck and its files, with each point replaced and each length multiplied."""
        outline = [point(*corner) for corner in self.outline]
        text = re.sub(r"^(OUTLINE.*)\n.*\n.*$",
                      lambda found: "\n".join([found[1], *(", ".join(map(str, row)) for row in zip(*outline))]),
                      self.text, count=1, flags=re.M)
        reach = 3 * max(abs(value) for corner in outline for value in corner) + 3 * size_of(self.size)
        text = re.sub(r"^([XY]LIMITS), .*$", rf"\1, {-reach}, {reach}", text, flags=re.M)
        one = size_of(Decimal(1))
        text = re.sub(rf"^(BOXES, 10, 10|TRACES, [\w.]+, \d+|CUT), ({NUMBER}|\.\d+)(?:, (\.\d+))?$",  # amin is an area
                      lambda found: f"{found[1]}, {Decimal(found[2]) * one}"
                      + (f", {Decimal(found[3]) * one * one}" if found[3] else ""), text, flags=re.M)
        return text, {name: moved_file(name, content, point) for name, content in self.files.items()}, outline


def moved_file(name, text, point):
    def pair(found):
        x, y = point(Decimal(found[1]), Decimal(found[3]))
        return f"{x}{found[2]}{y}"
    if name.endswith(".csv"):
        rows = [line.split(",") for line in text.splitlines()]
        first = 0 if re.match(NUMBER, rows[0][0]) else 1
        for row in rows[first:]:
            a, b = (point(Decimal(row[i].strip()), Decimal(row[i + 1].strip())) for i in (0, 2))
            row[:4] = map(str, [*a, *b])
        return "".join(",".join(row) + "\n" for row in rows)
    if name.endswith(".wkt"):
        return re.sub(rf"({NUMBER})( )({NUMBER})", pair, text)
    return re.sub(rf"(?<=\[)({NUMBER})(, )({NUMBER})(?=\])", pair, text)


def export(folder, text, files):
    """Returns the output of export, and the file it wrote."""
    for name, content in {**files, "case.deck": text}.items():
        (folder / name).write_text(content)
    done = subprocess.run([PROGRAM, "export", "-q", "case.deck", "-o", "blocks.geojson"], cwd=folder, check=False,
                          capture_output=True, text=True)
    return done, folder / "blocks.geojson"


def judged(folder, text, files, outline, ulps=4):
    """The messages, the blocks and their ids; the tiling has been judged. No blocks: they were refused, with a
    place and a proposal."""
    done, path = export(folder, text, files)
    if done.returncode == 3:
        assert re.search(r"^case\.deck:\d+:\d+: error: CUT: .*, at \(.*\)$", done.stderr, re.M), done
        assert "  hint: " in done.stderr, done
        return done.stderr, None, None
    assert done.returncode == 0, done
    around = [[tiling.turned(tiling.ring(outline, "outline"), False)]]
    blocks = tiling.read(path)
    verdict, good, lines = tiling.judge(blocks, around, ulps)
    assert good, (verdict, lines, text, files)
    ids = {i for one in json.loads(path.read_text())["features"] for i in one["properties"].get("joints", [0])} - {0}
    return done.stderr, len(blocks), ids


def is_expected(said, blocks, ids):
    if blocks is None or said == "a tiling, or refused":
        return "or refused" in said
    listed = re.search(r"ids ([\d ]+)", said)
    wanted = set(map(int, listed[1].split())) - {0} if listed else set()
    return blocks == int(said.split()[0]) and (ids == wanted or "ids" not in said)


def check(case, folder):
    """The deck as it is: blocks, certificate, pruned length, warnings and the proposal."""
    stderr, blocks, ids = judged(folder, case.text, case.files, case.outline)
    assert is_expected(case.given, blocks, ids), (case.name, blocks, ids, stderr)
    for text in re.findall(r"'(.*?)'", case.given):
        assert text in stderr, (case.name, text, stderr)
    if blocks is None:
        return
    done = subprocess.run([PROGRAM, "check", "--geometry", "--json", "case.deck"], cwd=folder, check=False,
                          capture_output=True, text=True)
    told = json.loads(done.stdout)
    assert told["certificate"]["holds"] and told["blocks"] == blocks, (case.name, told)
    if wanted := re.search(r"pruned ([\d.]+)", case.given):
        pruned = sum(joint["pruned"] for joint in told["cuts"][0]["joints"])
        assert math.isclose(pruned, float(wanted[1]), rel_tol=1e-4, abs_tol=1e-12), (case.name, pruned)
    proposal = re.search(r"warning: TRACES: .* at \(.*\)\n.*\n.*\n  hint: give snap (\S+) to", stderr)
    assert bool(proposal) == bool(case.proposed), (case.name, stderr)
    if proposal:
        text = re.sub(r"^(TRACES, [\w.]+)(, \d+)?$", lambda found: f"{found[1]}{found[2] or ', 0'}, {proposal[1]}",
                      case.text, flags=re.M)
        stderr, blocks, ids = judged(folder, text, case.files, case.outline)
        assert is_expected(case.proposed, blocks, ids), (case.name, blocks, ids, stderr)
        assert "loose" not in stderr, (case.name, stderr)


def vary_exactly(case, folder, rng):
    c, s = map(Decimal, rng.choice(TURNS))
    mirror, scale = rng.choice((1, -1)), Decimal(rng.choice((1, 2, 3, 7))) * Decimal(10) ** rng.randint(-6, 6)
    shift = [Decimal(rng.randint(-300, 300)) / 100 * case.size for _ in range(2)]
    x0, y0 = case.outline[0]

    def point(x, y):
        x, y = x - x0, (y - y0) * mirror
        return scale * (c * x - s * y + shift[0]), scale * (s * x + c * y + shift[1])
    stderr, blocks, ids = judged(folder, *case.moved(point, lambda length: length * scale))
    assert is_expected(case.given, blocks, ids), (case.name, blocks, ids, stderr, c, s, mirror, scale, shift)


def vary_rounded(case, folder, rng, clean):
    angle, scale = rng.uniform(0, 2 * math.pi), 10.0 ** rng.uniform(-6, 6)
    x0, y0 = case.outline[0]
    known = {}

    def point(x, y):
        if (x, y) not in known:
            dx, dy = float(x - x0), float(y - y0)
            known[x, y] = tuple(scale * v for v in (math.cos(angle) * dx - math.sin(angle) * dy,
                                                    math.sin(angle) * dx + math.cos(angle) * dy))
        return tuple(Decimal(v + rng.randint(-2, 2) * math.ulp(v)) for v in known[x, y])
    text, files, outline = case.moved(point, lambda length: Decimal(float(length) * scale))
    snap = 1e-12 * scale * float(case.size)
    text = re.sub(r"^(TRACES, [\w.]+)(, \d+)?$", lambda found: f"{found[1]}{found[2] or ', 0'}, {snap!r}", text,
                  flags=re.M)
    if clean:
        emin = 1e-6 * scale * float(case.size)
        text = re.sub(r"^CUT$", f"CUT, {emin!r}, {1e6 * emin * emin!r}", text, flags=re.M)
    stderr, blocks, ids = judged(folder, text, files, outline, REPAIRED)
    return blocks is not None and is_expected(case.given, blocks, ids)


def run(case):
    with tempfile.TemporaryDirectory() as name:
        folder, rng = Path(name), random.Random(case.name)
        check(case, folder)
        for _ in range(EXACT):
            vary_exactly(case, folder, rng)
        same = [vary_rounded(case, folder, rng, case.is_cleaned and k % 2 == 0) for k in range(ROUNDED)]
        assert all(same) or not case.is_stable, (case.name, same)
        assert all(same[::2]) or not case.is_cleaned, (case.name, same)
        return f"{case.name}: {case.given}; the same in {sum(same)} of {ROUNDED} rounded variations"


def main():
    cases = [Case(path) for path in sorted(CORPUS.glob("*.deck"))]
    assert len(cases) >= 20, len(cases)
    table = (CORPUS / "README.md").read_text()
    assert not (missing := [case.name for case in cases if f"`{case.name}`" not in table]), missing
    with ThreadPoolExecutor(2) as pool:
        for line in pool.map(run, cases):
            print(line)


main()
