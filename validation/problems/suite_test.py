#!/usr/bin/python3
"""Tests of suite/: verdicts, fits and turned decks."""

import contextlib
import io
import json
import math
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

sys.dont_write_bytecode = True
HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

import problems  # noqa: E402
from suite import cracking, report, trough  # noqa: E402
from suite.case import Case  # noqa: E402
from suite.deck import mirrored, turned, with_lines  # noqa: E402
from suite.numbers import bisect, first_time, order  # noqa: E402
from suite.pressures import Pressures  # noqa: E402
from suite.results import Results  # noqa: E402
from suite.rings import Rings  # noqa: E402
from suite.spring_statics import Contact, Statics, section  # noqa: E402


def test_verdicts():
    case = Case(HERE / "bounce", Path("none"), Path("none"))
    case.equal("at the tolerance", 2.0, 2.5, 0.25, "relative")
    case.equal("beyond it", 2.0, 2.6, 0.25, "relative")
    case.equal("absolute", 0.0, 0.5, 0.5, "absolute", absolute=True)
    case.equal("not a number", 1.0, math.nan, 1e9, "a run gone wrong is a miss")
    case.at_most("above", 1.0, 1.1, "bound")
    case.at_least("not a number", 1.0, math.nan, "bound")
    case.measured("no verdict", 1.0, "nothing known")
    assert [row.holds for row in case.rows] == [True, False, True, False, False, False, None]
    case.same("in words", "slides", "slides", "the same")
    case.same("other words", "slides", "topples", "the same")
    assert [row.holds for row in case.rows[7:]] == [True, False]
    rows = [row.as_dict() for row in case.rows]
    rows[1]["note"] = "for a reason"
    result = {"problem": "x", "readme": "# X", "rows": rows, "figures": [], "runs": 1}
    page = report.markdown([result])
    assert "8 verdicts: 3 hold, 5 miss; 1 of them is known." in page, page
    assert page.count("**MISSES**") == 4 and page.count("New: not explained.") == 4, page
    assert page.count("**known miss**") == 1 and page.count("Known: for a reason") == 1, page


def test_whose_rows():
    def measured(name, numerics):
        return {"problem": name, "readme": "# X", "rows": [], "figures": [], "runs": 1,
                "program": {"version": "blocks 1", "commit": "c0ffee", "numerics": numerics,
                            "day": "today"}}
    page = report.markdown([measured("x", "aa"), measured("y", "aa")])
    assert "programs of the same arithmetic" in page, page
    assert "1 run of blocks 1, commit c0ffee, numerics aa, today" in page, page
    page = report.markdown([measured("x", "aa"), measured("y", "bb")])
    assert "**Rows of different programs** (numerics aa: x; numerics bb: y)" in page, page
    assert "not recorded: x" in report.markdown([{**measured("x", ""), "program": None}])


def test_known_misses():
    with tempfile.TemporaryDirectory() as folder:
        problems.HERE = Path(folder)
        (problems.HERE / "x").mkdir()
        (problems.HERE / "x" / "known_misses.json").write_text(
            '{"way": {"between": [3, 4], "why": "why"}}')
        rows = [{"quantity": quantity, "holds": False, "note": "", "reason": "", "value": value}
                for quantity, value in (("way", 3.5), ("speed", 3.5), ("way", 4.1), ("way", math.nan),
                                        ("way", None))]
        assert problems.explain("x", rows) == [], rows
        assert [row["note"] for row in rows] == ["why", "", "", "", ""], rows
        absent = problems.explain("x", rows[1:2])
        assert [(row.quantity, row.holds) for row in absent] == [("way", False)], absent


def test_wrong_answers_are_misses():
    """A limit outside its bracket, and a check that raises an exception, are misses."""
    assert math.isnan(bisect(lambda v: v < 3, 0, 2, 1e-6))
    assert math.isnan(bisect(lambda v: v < -1, 0, 2, 1e-6))
    with tempfile.TemporaryDirectory() as folder:
        problems.HERE = Path(folder) / "a" / "b"
        (problems.HERE / "x").mkdir(parents=True)
        (problems.HERE / "x" / "check.py").write_text(
            "def check(case):\n    case.measured('before', 1.0, '')\n    return {}[4.25]\n")
        with contextlib.redirect_stderr(io.StringIO()) as output:
            rows = problems.solve("x", Path("none"), False)["rows"]
    assert [row["holds"] for row in rows] == [None, False], rows
    assert rows[1]["ours"] == "no: KeyError: 4.25" and "check.py" in output.getvalue(), rows


def test_turned_deck():
    text = "XLIMITS, -1, 1\nYLIMITS, -1, 2\nCREATE, 3, 1, 1\n0, 0, 1\n0, 1, 0\nSETVEL, 1, 0, 1, 0\n"
    lines = turned(text, 90, (10, 20)).splitlines()
    numbers = [[float(word) for word in line.split(",")[1:]] for line in (lines[0], lines[5])]
    assert np.allclose([float(v) for v in lines[3].split(",")], [10, 9, 10]), lines
    assert np.allclose([float(v) for v in lines[4].split(",")], [20, 20, 21]), lines
    assert lines[2] == "CREATE, 3, 1, 1", lines
    assert np.allclose(numbers[1][2:4], [0, 1]), lines
    assert numbers[0][0] <= 8 and numbers[0][1] >= 12, lines
    assert with_lines(text, CREATE="FIX, 1").count("FIX") == 1

    def line(card):
        return [float(word) for word in turned(text + card, 90, (10, 20)).splitlines()[6].split(",")[1:]]
    assert np.allclose(line("FORCE, 1, 2, 3., .5"), [1, -3, 2, 0.5])
    assert np.allclose(line("FORCE, 1, 2.D0"), [1, 0, 2])
    assert np.allclose(line("SETVELM, 1, 2, 3, 4"), [1, -3, 2, 4])
    assert np.allclose(line("LAYER, -3, 1, 0, 0, 0, 1, 3, 1, 3, 0"), [-3, 1, 10, 20, 9, 20, 9, 23, 10, 23])
    assert np.allclose(line("SPLANE, 0, 0, 1, 2"), [10, 20, 8, 21])
    assert np.allclose(line("DRIVE, 1, 2, 3, 4"), [1, -3, 2, 4])
    assert turned(text + "JSET, 1, 5, , 1", 90, (10, 20)).splitlines()[6] == \
        "JSET, 1, 95, , 1, , , , , , 10, 20"
    outline = turned(text + "OUTLINE, 3, 2\n0, 0, 1\n0, 1, 0\nCUT, .1", 90, (10, 20)).splitlines()
    assert outline[6] == "OUTLINE, 3, 2" and outline[9] == "CUT, .1", outline
    assert np.allclose([float(v) for v in outline[7].split(",")], [10, 9, 10]), outline
    for card in ("READ9, mine.msh", "LAYER, -3, 1, 0, 0, 0, 1,\n3, 1, 3, 0", "WIND, 1, 0"):
        try:
            turned(text + card, 90)
        except ValueError as fault:
            assert card.split(",")[0] in str(fault), fault
        else:
            raise AssertionError(f"{card} was taken as it stands")


def test_mirrored_deck():
    text = "XLIMITS, -1, 3\nYLIMITS, -1, 2\nCREATE, 3, 1, 1\n0, 0, 1\n0, 1, 0\nGRAVITY, 1, -10, 2\n"
    lines = mirrored(text).splitlines()
    assert lines[0] == "XLIMITS, -3, 1" and lines[2] == "CREATE, 3, 1, 1", lines
    assert np.allclose([float(v) for v in lines[3].split(",")], [0, -1, 0]), lines
    assert np.allclose([float(v) for v in lines[4].split(",")], [0, 0, 1]), lines
    assert lines[5] == "GRAVITY, -1, -10, 2", lines
    try:
        mirrored(text + "SETVEL, 1, 0, 1, 0")
    except ValueError as fault:
        assert "SETVEL" in str(fault), fault
    else:
        raise AssertionError("SETVEL was taken as it stands")


def test_frames_with_more_and_more_blocks():
    """A square of mass 2 splits after two frames, and its piece of mass 1 moves away."""
    square, halves = [(0, 0), (0, 1), (1, 1), (1, 0)], [(0, 0), (0, 1), (0.5, 1), (0.5, 0),
                                                        (0.5, 0), (0.5, 1), (1, 1), (1, 0)]
    rows = {"Mass": [2.0, 1.0, 1.0], "Spin": [0.0, 0.0, 0.0], "Inertia": [1.0, 0.5, 0.5],
            "Velocity": [[0, 0, 0], [-1, 0, 0], [3, 0, 0]], "Fixed": [0, 0, 1],
            "Centroid": [[0.5, 0.5, 0], [0.25, 0.5, 0], [0.75, 0.5, 0]]}
    starts = {"Mass": [0, 0, 1], "Velocity": [0, 0, 1]}
    with tempfile.TemporaryDirectory() as folder:
        stem = Path(folder) / "run"
        Path(folder, "run.summary.json").write_text(json.dumps({"blocks": 2, "cracks": []}))
        with h5py.File(Path(folder) / "run.vtkhdf", "w") as file:
            for name, values in {"Steps/Values": [0.0, 1.0, 2.0], "Steps/PartOffsets": [0, 0, 1],
                                 "Steps/CellOffsets": [0, 0, 1], "NumberOfCells": [1, 2],
                                 "Offsets": [0, 4, 0, 4, 8], "Steps/PointOffsets": [0, 0, 4],
                                 "Points": np.pad(np.array(square + halves, float), ((0, 0), (0, 1))),
                                 }.items():
                file["VTKHDF/" + name] = values
            for name, values in rows.items():
                file["VTKHDF/CellData/" + name] = np.array(values)
                file["VTKHDF/Steps/CellDataOffsets/" + name] = starts.get(name, [0, 0, 1])
        run = Results(stem, 0.0)
        assert run.counts.tolist() == [1, 1, 2] and run.exists.tolist() == [[1, 0], [1, 0], [1, 1]]
        assert np.allclose(run.all("Mass"), [[2, np.nan], [2, np.nan], [1, 1]], equal_nan=True)
        assert run.all("Fixed").tolist() == [[0, 0], [0, 0], [0, 1]] and run.free() == [1]
        assert run.momentum().tolist() == [[0, 0], [0, 0], [2, 0]], run.momentum()
        assert run.angular_momentum().tolist() == [0, 0, -1], run.angular_momentum()
        assert run.kinetic_energy().tolist() == [0, 0, 5]
        assert run.corner_offsets.tolist() == [0, 4]
        assert run.outline(1, 0).tolist() == run.outline(1, 1).tolist() == [list(p) for p in square]
        assert [run.outline(b, 2).tolist() for b in (1, 2)] == \
            [[list(p) for p in halves[:4]], [list(p) for p in halves[4:]]]
        assert cracking.area(run.outline(2, -1)) == 0.5
    assert [cracking.off(*pair) for pair in ((179, 1), (1, 179), (120, 300), (31, 30))] == [-2, 2, 0, 1]


def test_pressures():
    """A rectangle of 4 m x 2 m is pushed at its upper half from the left, and pulled at the right."""
    corners = np.array([(1, 1), (1, 3), (5, 3), (5, 1)], float)
    loads = Pressures("PRESSBC, 1, 1, 0, 6, 0\nPRESSBC, 1, 3, -3, -3, 0\n", corners)
    assert loads.area == 8 and np.allclose(loads.centroid, (3, 2))
    assert np.allclose(loads.second_moment, 8 * (4 ** 2 + 2 ** 2) / 12)
    # 6 N at two thirds of the height of the left side, and 6 N at the middle of the right one.
    assert np.allclose(loads.force, (12, 0)) and np.allclose(loads.moment, -6 / 3), loads.moment
    assert np.allclose(loads.stress, [[0, 2 / 8], [0, 0]]), loads.stress


def test_spring_statics():
    """A beam of two blocks with a joint at x = 1, fixed at x = 0, under its weight of 4."""
    statics = Statics([[(0, 0), (0, 1), (1, 1), (1, 0)], [(1, 0), (1, 1), (3, 1), (3, 0)]])
    statics.add_weight((0, -1), 1)
    for x, left, right in ((0, -1, 0), (1, 0, 1)):
        for y in (0, 1):  # The edge of the block at the left runs downwards.
            statics.add_contact(Contact(np.array([x, y]), (0, -1), right, left, (1e3, 1e3)))
    forces, moved = statics.solve()
    assert np.allclose(forces[:, 0], [4.5, -4.5, 2, -2]), forces
    assert np.allclose(forces[:, 1], [1.5, 1.5, 1, 1]), forces
    # The outer block turns by (4.5 + 2) 2 / 1000, and its centroid sinks with both joints.
    assert np.allclose(moved[1, 2], -(9 + 4) / 1000), moved
    assert np.allclose(statics.displacement(moved, 1, (1, 0))[1], moved[0, 1] - 0.0045 - 0.001), moved


def test_rings():
    """Far outer rings give Kirsch's closure, and blocks on springs come close to the continuum."""
    far = Rings(16, 2.0, 2e5, 1e10)
    assert math.isclose(far.closure(1e6, (1e10, 4e9), 2.0), 2.25e-10 * 1e6 * 2, rel_tol=1e-6)
    assert math.isclose(far.closure(1e6, None, 2.0), 1e-10 * 1e6 * 2, rel_tol=1e-6)
    near = Rings(16, 2.0, 6.0, 1e10)
    centre = section(near.outline(*near.radii[:2], 0))[1]
    inwards = -near.statics([[-1e6, 0], [0, -1e6]], (1e10, 4e9))[0] @ centre / np.hypot(*centre)
    assert math.isclose(inwards, near.closure(1e6, (1e10, 4e9), np.hypot(*centre)), rel_tol=0.06)


def test_reach():
    x = np.array([0.0, 2.7, 5.4, 8.1, 12.0])
    s = 10.0 - x
    assert math.isclose(trough.reach(x, s, 5.0), 5.0)
    assert trough.reach(x, s, -5.0) == 12.0  # never falls below
    assert trough.reach(x, s, 11.0) == 0.0


def test_fits():
    x = np.linspace(0, 60, 60)
    for name in trough.FUNCTIONS:
        s = trough.profile(name, x, 1.5, 20.0, 12.0)
        found, left = trough.fit(name, x, s)
        assert np.allclose(found, (1.5, 20.0, 12.0), rtol=0.01) and left < 1e-3, (name, found, left)
    assert abs(bisect(lambda v: v < 1.3, 0, 2, 1e-6) - 1.3) < 1e-6
    assert math.isclose(order([1, 2, 4], [3, 12, 48]), 2)
    assert first_time(np.array([0, 1, 2]), np.array([0, 0, 4]), 1) == 1.25
    assert math.isnan(first_time(np.array([0, 1]), np.array([0, 0]), 1))


for test in (test_verdicts, test_whose_rows, test_known_misses, test_wrong_answers_are_misses,
             test_turned_deck, test_mirrored_deck, test_frames_with_more_and_more_blocks,
             test_pressures, test_spring_statics, test_rings, test_reach, test_fits):
    test()
