"""Reads results files and compares every number with what the program says."""

import csv
import fcntl
import json
import math
import os
import shutil
import subprocess
import sys
import time
import types
from contextlib import nullcontext
from pathlib import Path

import h5py
import numpy as np
import pytest

import blocks
from blocks import results_file
from blocks.dimensions import Units, unit_text
from blocks.errors import FileError
from blocks.quantities import KINDS, QUANTITIES, kind_of, quantity, quantity_names
from conftest import PRELOADED
from blocks.results import History, read

PROGRAM = os.environ["BLOCKS_PROGRAM"]
DECKS = Path(__file__).parents[2] / "decks"

# Bricks with bonded joints; the second HISTORY card replaces the first. No UNITS card.
BONDED = """START, 20, 4
BONDED "BRICKS" & <MORE>
XLIMITS, -2, 10
YLIMITS, -2, 8
BOXES, 24, 20, 0.1
STIFF, 1.E8, 1.E8
FRACTION, 0.02
MATERIAL, 1, 1.E9, 4.E8, 2000, 'brick "A"'
RIGID
END
CREATE, 4, 1, 1
-1, -1, 9, 9
-1, 0, 0, -1
CREATE, 4, 1
1, 1, 2, 2
0, 0.5, 0.5, 0
CREATE, 4, 1
1, 1, 2, 2
0.5, 1, 1, 0.5
JOINT, 1, .6, 1.D6, 3.D5, .6, 0., 0., , , 2.D8, 2.D8
JPAIR, 1, 1, 1
BOND
GRAVITY, 0, -10
HISTORY, .01, y:3, {first}
PLOTS, .02
MOTION, .05
HISTORY, .01, y:3, {second}, speed:max
MOTION, .05
STOP
"""
ENERGIES = [name for name in KINDS if name.startswith("energy:")]
HALVES = ENERGIES[:10], ENERGIES[10:]


def run(*arguments, check=True):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert not check or done.returncode == 0, done.stderr
    return done


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Results of small runs: bricks, cracks, removed blocks, joints with laws."""
    folder = tmp_path_factory.mktemp("results")
    first, second = map(", ".join, HALVES)
    (folder / "bonded.deck").write_text(BONDED.format(first=first, second=second))
    for name, deck, options in (
        ("stack", DECKS / "stack/stack.deck", ("--until", ".5")),
        ("cracks", DECKS / "crater_cracks/crater_cracks.deck", ("--until", ".06")),
        ("every", DECKS / "every_card/every_card.deck", ()),
        ("bonded", folder / "bonded.deck", ()),
    ):
        run("run", deck, "-o", folder / name, "--threads", 1, "-q", *options)
    return {path.stem: path for path in folder.glob("*.vtkhdf")}


CONTACT_FIELDS = (
    "corner_block", "corner", "edge_block", "edge", "point", "normal", "force", "normal_force", "shear_force",
    "overlap",
)
CRACK_FIELDS = (
    "step", "time", "parent", "child", "cause", "stress", "begin", "end", "parent_area", "child_area",
    "released",
)
NAMES = ["stack", "cracks", "every", "bonded"]


@pytest.fixture(params=NAMES)
def opened(request, files):
    with read(files[request.param]) as results:
        yield results


@pytest.fixture
def stack(files):
    with read(files["stack"]) as results:
        yield results


@pytest.fixture
def cracked(files):
    with read(files["cracks"]) as results:
        yield results


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def column(rows, name, kind=float):
    return np.array([kind(row[name]) for row in rows])


# --- Facts of the run


def test_facts_are_those_of_the_summary(opened):
    summary = json.loads(Path(opened.path).with_suffix(".summary.json").read_text())
    assert opened.title == summary["title"]
    assert opened.seed == summary["seed"]
    assert opened.version == summary["version"]
    assert opened.deck_file == summary["deck"]
    assert opened.deck == Path(summary["deck"]).read_text()
    assert len(opened) == summary["frames"]
    last = opened[-1]
    assert (last.step, last.time) == (summary["steps"], summary["time"])
    assert len(last) == summary["blocks"]
    assert last.kinetic_energy == summary["kinetic_energy"]
    assert last.worst_overlap == summary["worst_overlap"]["end"]
    assert len(last.contacts) == summary["contacts"]["active"]


def test_names_of_the_deck(files):
    with read(files["every"]) as every, read(files["bonded"]) as bonded:
        assert every.units == Units("m", "kg", "s") and bonded.units is None
        assert every.materials == {1: "HARD ROCK"}
        assert bonded.materials == {1: 'brick "A"'}
        assert every.continues_run == "" and len(every.run_id) == 16
        assert every.overrides.startswith("READ9")


# --- Frames


def test_frames_are_those_of_a_simulation(tmp_path):
    """Contacts, cracks and all attributes have the same names, numbers and values."""
    deck = (DECKS / "beam/beam.deck").read_text().split("GRAVITY")[0] + "GRAVITY, 0., -9.81, .2\n"
    simulation = blocks.Simulation(deck)
    whole = len(simulation)
    simulation.run_until(0.4, True, every=100, callback=lambda model: len(model) > whole)
    simulation.step(20, read=True)
    simulation.write_frame(tmp_path / "beam.vtkhdf")
    with read(tmp_path / "beam.vtkhdf") as results:
        frame = results[0]
        assert len(frame.contacts) > 0 < len(frame.cracks)
        assert {"law", "bonded", "slip"} <= set(simulation.contacts.dtype.names)
        for table in ("contacts", "cracks"):
            own, other = getattr(frame, table), getattr(simulation, table)
            assert own.dtype.names[: len(other.dtype.names)] == other.dtype.names
            for name in other.dtype.names:
                np.testing.assert_array_equal(own[name], other[name], err_msg=name)
        shared = "corners first_corner joint centroid velocity spin angle stress strain_rate force moment"
        shared += " mass inertia area material is_free kinetic_energy title"
        for name in shared.split():
            np.testing.assert_array_equal(getattr(frame, name), getattr(simulation, name), err_msg=name)
        # Displacements of results are those since their first frame.
        for name in set(frame.quantities) & set(quantity_names(simulation)) - {"displacement", "dx", "dy"}:
            np.testing.assert_array_equal(frame.quantity(name), quantity(simulation, name), err_msg=name)


def test_quantities_are_those_of_export(opened, tmp_path):
    run("export", opened.path, "-o", tmp_path / "all.csv", "-q")
    rows = table(tmp_path / "all.csv")
    names = [name for name in rows[0] if name in QUANTITIES]
    assert len(names) >= 29 and ("unbalanced" in names) == ("every" in opened.path)
    assert column(rows, "time").tolist() == np.repeat(
        opened.times, [np.count_nonzero(~frame.is_removed) for frame in opened]
    ).tolist()
    begin = 0
    for frame in opened:
        shown = ~frame.is_removed
        own = rows[begin : (begin := begin + np.count_nonzero(shown))]
        assert column(own, "step", int).tolist() == [frame.step] * len(own)
        assert column(own, "block", int).tolist() == frame.number[shown].tolist()
        assert column(own, "material", int).tolist() == frame.material[shown].tolist()
        assert column(own, "fixed", int).tolist() == frame.fixed[shown].tolist()
        if "parent" in rows[0]:
            assert column(own, "parent", int).tolist() == (frame.parent[shown] + 1).tolist()
        for name in names:
            values = frame.quantity(name)
            np.testing.assert_array_equal(values[shown], column(own, name), err_msg=name)
            assert np.isnan(values[~shown]).all()
    assert begin == len(rows)


def test_contacts_are_those_of_export(opened, tmp_path):
    run("export", opened.path, "-o", tmp_path / "all.csv", "-q")
    rows = table(tmp_path / "all_contacts.csv")
    begin = 0
    for frame in opened:
        contacts = frame.contacts
        own = rows[begin : (begin := begin + len(contacts))]
        if not own:
            continue
        starts, on_plane = frame.first_corner, contacts["edge_block"] < 0
        edge_starts = np.where(on_plane, 0, starts[contacts["edge_block"]])
        for name, counted in (
            ("corner_block", contacts["corner_block"]),
            ("corner", contacts["corner"] - starts[contacts["corner_block"]]),
            ("edge_block", contacts["edge_block"]),
            ("edge", contacts["edge"] - edge_starts),
        ):
            assert column(own, name, int).tolist() == (counted + 1).tolist()
        np.testing.assert_array_equal(frame.corners[contacts["corner"]], contacts["point"])
        assert contacts.dtype.names[:10] == CONTACT_FIELDS
        for name in ("normal_force", "shear_force", "overlap"):
            np.testing.assert_array_equal(column(own, name), contacts[name])
        for name, pair in (("point", "x y"), ("normal", "nx ny"), ("force", "fx fy")):
            for axis, of_program in enumerate(pair.split()):
                np.testing.assert_array_equal(column(own, of_program), contacts[name][:, axis])
        if "bonded" in opened.path:
            assert column(own, "joint", int).tolist() == contacts["law"].tolist()
            for name in set(contacts.dtype.names[10:]) - {"law"}:  # every state
                np.testing.assert_array_equal(column(own, name), contacts[name])
    assert begin == len(rows) > 0


def test_states_of_laws_are_missing_without_laws(files):
    with read(files["stack"]) as stack, read(files["bonded"]) as bonded:
        assert "law" not in stack[-1].contacts.dtype.names
        last = bonded[-1].contacts
        assert {"law", "bonded", "failed", "slip_path", "shear_stiffness"} <= set(last.dtype.names)
        assert last["bonded"].any() and last["law"].any()


WET = BONDED.split("JOINT")[0] + """GRAVITY, 0, -10
PLOTS, .01
MOTION, .01
WATER, 5000, 2
0, .8
3, 1.4
CYCLE, 2
STOP
"""


def test_water(tmp_path):
    (tmp_path / "wet.deck").write_text(WET)
    run("run", tmp_path / "wet.deck", "-o", tmp_path / "wet")
    results = read(tmp_path / "wet.vtkhdf")
    dry, wet = results[0], results[-1]
    assert dry.water_table.shape == (0, 2) and not len(dry.wet_sides) and not dry.water_force.any()
    line = wet.water_table
    assert line[0][0] < 0 and (np.diff(line[:, 0]) > 0).all()
    # The pressure at each end of a part is that of its depth.
    sides, ends = wet.wet_sides, np.roll(np.arange(len(wet.corners)), -1)
    for first, last in zip(wet.first_corner[:-1], wet.first_corner[1:]):
        ends[last - 1] = first
    assert len(sides) > 8
    for corner, share, pressure in sides:
        at = wet.corners[corner] + share[:, None] * (wet.corners[ends[corner]] - wet.corners[corner])
        depth = np.interp(at[:, 0], line[:, 0], line[:, 1]) - at[:, 1]
        assert np.allclose(pressure, 5000 * depth, atol=1e-6)
    # Drowned: the weight of the water, and its slope.
    assert np.allclose(wet.water_force[1], [-5000 * 0.2 * 0.5, 5000 * 0.5])
    assert np.array_equal(wet.quantity("water_y"), wet.water_force[:, 1])
    sim = blocks.Simulation(blocks.Deck(WET))
    assert np.allclose(sim.water_force, wet.water_force, rtol=1e-3)


def test_shapes(opened):
    for frame in opened:
        n = len(frame)
        assert frame.number.tolist() == list(range(1, n + 1))
        assert frame.centroid.shape == frame.velocity.shape == frame.force.shape == (n, 2)
        assert frame.stress.shape == frame.applied_stress.shape == frame.strain_rate.shape == (n, 2, 2)
        assert frame.first_corner.shape == (n + 1,) and len(frame.polygons) == n
        assert frame.first_corner[-1] == len(frame.corners) == len(frame.joint)
        for polygon, gone in zip(frame.polygons, frame.is_removed):
            assert len(polygon) == 0 if gone else len(polygon) >= 3
            assert len(polygon) == 0 or np.shares_memory(polygon, frame.corners)


def test_cell_arrays_are_as_stored(cracked):
    frame = cracked[2]
    with h5py.File(cracked.path) as file:
        vtk = file["VTKHDF"]
        assert set(frame.names) == set(vtk["CellData"]) == set(dict(frame))
        for name in frame.names:
            first = vtk["Steps/CellDataOffsets"][name][2]
            stored = vtk["CellData"][name][first : first + len(frame)]
            assert frame[name].dtype == stored.dtype
            np.testing.assert_array_equal(frame[name], stored)
    s = frame["Stress"]
    np.testing.assert_array_equal(frame.stress[:, 1, 0], s[:, 2])
    with pytest.raises(KeyError, match="no cell array 'stress': choose .*Stress"):
        frame["stress"]
    for name in ("Stress", "stress", "corners", "names", "plot", "sped"):
        with pytest.raises(KeyError, match=f"no quantity '{name}': choose speed"):
            frame.quantity(name)
    assert frame.quantity("fixed").tolist() == frame.fixed.tolist()
    for name in frame.quantities:
        assert frame.quantity(name).shape == (len(frame),)


def test_removed_blocks(files):
    with read(files["every"]) as every:
        last = every[-1]
        assert last.is_removed.tolist() == [False] * 35 + [True]
        assert not every[-2].is_removed.any()
        assert len(last.polygons[35]) == 0 and len(every[-2].polygons[35]) == 4
        assert math.isnan(last.displacement[35, 0])
        assert last.area[35] > 0  # as stored
        assert 0 < last.unbalanced_ratio < 1
        assert last.unbalanced.shape == (36,)


def test_without_equilibrium(stack):
    assert math.isnan(stack[0].unbalanced_ratio)
    with pytest.raises(AttributeError, match="does not ask for equilibrium"):
        stack[0].unbalanced
    assert "unbalanced" not in stack[0].quantities


def test_arrays_are_read_once_and_kept(stack):
    frame = stack[1]
    read_before = frame["Velocity"], frame.contacts, frame.corners
    assert not frame["Velocity"].flags.writeable and not frame.contacts.flags.writeable
    with pytest.raises(ValueError):
        frame.velocity[0] = 1.0
    assert stack[1] is frame  # as long as it is used
    stack.close()
    assert frame["Velocity"] is read_before[0]
    assert frame.contacts is read_before[1] and frame.corners is read_before[2]
    with pytest.raises(ValueError, match="is closed"):
        frame.spin
    assert "closed" in repr(stack)


def test_sequence(stack):
    count = len(stack)
    assert count == 6 and stack.times.shape == stack.steps.shape == (6,)
    assert [frame.index for frame in stack] == list(range(6))
    assert [frame.index for frame in stack[::-2]] == [5, 3, 1]
    assert stack[-1].index == stack[np.int64(5)].index == 5
    for wrong in (count, -count - 1):
        with pytest.raises(IndexError, match="has frames 0 to 5"):
            stack[wrong]
    assert stack.at(0.12).index == 1 and stack.at(0.16).index == 2
    assert stack.at(stack.times[-1] + 1e-5).index == 5
    with pytest.raises(ValueError, match="has times 0 to 0.50"):
        stack.at(5.0)


def test_representations(stack, cracked, files):
    assert repr(stack) == "<Results stack.vtkhdf: 6 frames, 13 blocks, t 0 to 0.500019>"
    assert repr(stack[-1]) == f"<Frame 5 of stack.vtkhdf: t 0.500019, step {stack[-1].step}, 13 blocks>"
    assert repr(cracked.history).startswith("<History: 61 samples of cracks, energy:cracks, energy:residual")
    assert repr(stack.history) == "<History: no samples>"


# --- Cracks


def test_cracks_are_those_of_the_program(cracked):
    rows = list(csv.DictReader(run("cracks", cracked.path, "--csv").stdout.splitlines()))
    cracks = cracked.cracks
    assert len(cracks) == len(rows) > 10
    assert cracks.dtype.names[:11] == CRACK_FIELDS
    assert column(rows, "step", int).tolist() == cracks["step"].tolist()
    for name in ("parent", "child"):
        assert column(rows, name, int).tolist() == (cracks[name] + 1).tolist()
    assert [row["cause"] == "stress" for row in rows] == (cracks["cause"] == 0).tolist()
    floats = "time stress moved parent_area child_area released kinetic_before strain_after"
    for name in floats.split():
        np.testing.assert_array_equal(column(rows, name), cracks[name])
    for name, end in (("begin", "from"), ("end", "to")):
        for axis, letter in enumerate("xy"):
            np.testing.assert_array_equal(column(rows, f"{end}_{letter}"), cracks[name][:, axis])


def test_frames_across_cracks(cracked):
    for before, now in zip(cracked, cracked[1:]):
        made = now.cracks[len(before.cracks) :]
        assert len(now) == len(before) + len(made)
        assert np.all((made["time"] > before.time) & (made["time"] <= now.time))
        assert now.parent[made["child"]].tolist() == made["parent"].tolist()
    assert len(cracked[0].cracks) == 0 and (cracked[0].parent == -1).all()
    assert np.isfinite(cracked[-1].displacement).all()


def test_without_cracks(stack):
    assert len(stack.cracks) == 0 and len(stack[-1].cracks) == 0
    assert stack[-1].parent.tolist() == [-1] * 13
    assert stack.cracks.dtype.names[:11] == CRACK_FIELDS


# --- Histories


def test_history_is_that_of_the_program(files):
    for name in ("cracks", "every"):
        with read(files[name]) as results:
            history = results.history
            rows = list(csv.DictReader(run("history", results.path, "--csv").stdout.splitlines()))
            assert len(rows) == len(history) > 50
            assert len(rows[0]) == len(history.names) + 1
            np.testing.assert_array_equal(history["t"], column(rows, "time"))
            for quantity in history:
                np.testing.assert_array_equal(history[quantity], column(rows, quantity))
            assert history["t"] is history.times
    assert history.interval == 0.005


def test_two_history_cards(files):
    with read(files["bonded"]) as results, h5py.File(files["bonded"]) as file:
        history = results.history
        first, second = file["BLOCKS/history/1"], file["BLOCKS/history/2"]
        assert history.names == ("y:3", *ENERGIES, "speed:max")
        assert np.all(np.diff(history["t"]) > 0)
        assert sorted({*first["time"][:], *second["time"][:]}) == history["t"].tolist()
        assert not np.isnan(history["y:3"]).any()
        np.testing.assert_array_equal(history["y:3"][-len(second["time"]) :][1:], second["values"][1:, 0])
        later = history["t"] > first["time"][-1]
        assert np.isnan(history[HALVES[0][0]][later]).all() and later.any()
        assert np.isnan(history["speed:max"][history["t"] < second["time"][0]]).all()
        speeds = history["speed:max"][history["t"] >= second["time"][0]]
        np.testing.assert_array_equal(speeds, second["values"][:, -1])


def test_history_of_unknown_names(stack, cracked):
    with pytest.raises(KeyError, match="no HISTORY card"):
        stack.history["y:3"]
    with pytest.raises(KeyError, match="recorded are cracks, energy:cracks"):
        cracked.history["y:3"]
    assert "cracks" in cracked.history and "y:3" not in cracked.history
    assert len(stack.history) == 0


def test_table_of_pandas(files, monkeypatch):
    pandas = pytest.importorskip("pandas")
    with read(files["every"]) as every:
        history = every.history
        table = history.to_pandas()
        assert isinstance(table, pandas.DataFrame)
        assert table.index.name == "t" and table.index.tolist() == history["t"].tolist()
        assert table.columns.tolist() == list(history.names)
        assert table.attrs["units"] == {"kinetic_energy": "J/m", "y:4-8": "m", "y:material=2:p90": "m"}
        assert table.attrs["time_unit"] == "s"
        monkeypatch.setitem(sys.modules, "pandas", None)
        with pytest.raises(ImportError, match="apt install python3-pandas"):
            history.to_pandas()


@pytest.mark.parametrize("units", ["m,kg,s", "cm,g,ms", None])
def test_labels_and_units_are_those_of_the_program(files, units):
    """All quantities that HISTORY can record, so that a new one in the program fails here."""
    listed = run("history", "--help").stdout.split("Quantities of blocks", 1)[1].split("of corners")
    of_blocks = [word.strip(" ,\n") for word in listed[0].split("):", 1)[1].split(",")]
    model = [word.strip(" ,\n") for word in listed[1].split("of the model:")[1].split(",")]
    missing = {"unbalanced", "unbalanced_ratio", "local_ratio", "unbalanced:local"} | {name for name in model if name.startswith("energy:")}
    names = [f"{name}:max" for name in of_blocks if name not in missing]
    names += [name for name in model if name not in missing]
    names += [f"{name}:joint=1" for name in ("normal_stress", "shear_stress", "slip", "joint_length")]
    options = ("--units", units) if units else ()
    source = files["bonded"]
    told = run("history", source, "--frames", "-q", ",".join(names), "--json", *options)
    columns = json.loads(told.stdout)["runs"][0]["columns"]
    for half in HALVES:
        recorded = json.loads(run("history", source, "-q", ",".join(half), "--json", *options).stdout)
        columns += recorded["runs"][0]["columns"][1:]
    assert len(columns) == 1 + len(names) + len(ENERGIES) > 75
    history = History(np.zeros(0), {}, units=Units(*units.split(",")) if units else None)
    assert columns[0]["unit"] == history.unit("t")
    for one in columns[1:]:
        assert history.unit(one["name"]) == one["unit"], one["name"]
        assert history.label(one["name"]).removesuffix(", tension positive") in one["label"]


def test_units_of_frames(stack, files):
    frame = stack[0]
    assert (frame.label("vx"), frame.unit("vx")) == ("velocity x", "m/s")
    assert (frame.unit("angle"), frame.unit("material"), frame.unit("rotation")) == ("rad", "", "degrees")
    with read(files["bonded"]) as bonded:
        assert bonded[0].unit("spin") == "rad T⁻¹" and bonded[0].unit("s11") == "M L⁻¹ T⁻²"
    assert unit_text(kind_of("s11").dimension, Units("cm", "g", "ms")) == "g cm⁻¹ ms⁻²"


# --- Other forms


def test_geojson_is_that_of_export(opened, tmp_path):
    for frame in opened:
        whole = tmp_path / "program.geojson"
        run("export", opened.path, "-o", whole, "--time", repr(frame.time), "-q")
        assert opened.at(frame.time).to_geojson() == whole.read_text()
        whole.unlink()
    frame.to_geojson(tmp_path / "own.geojson")
    assert (tmp_path / "own.geojson").read_text() == frame.to_geojson()
    assert [path.name for path in tmp_path.iterdir()] == ["own.geojson"]
    for link, kept in (("link.geojson", False), ("own.geojson.tmp", True)):
        (tmp_path / link).symlink_to(tmp_path / "precious")
        with nullcontext() if kept else pytest.raises(FileError, match="it is a link"):
            frame.to_geojson(tmp_path / link.removesuffix(".tmp"))
        assert (tmp_path / link).is_symlink() and not (tmp_path / "precious").exists()
    features = frame.__geo_interface__["features"]
    assert len(features) == np.count_nonzero(~frame.is_removed)
    for ending in ("", "2", "3"):
        (tmp_path / "own.geojson").write_text("mine" + ending)
        for _ in range(2):  # the same content is not kept twice
            frame.to_geojson(tmp_path / "own.geojson")
        assert (tmp_path / f"own.geojson.bak{ending}").read_text() == "mine" + ending
    with pytest.raises(ValueError, match="would be overwritten"):
        frame.to_geojson(opened.path)


def test_pyvista(files, monkeypatch):
    """pyvista itself is too large for the tests: PolyData gets points and faces."""

    class PolyData:
        def __init__(self, points, faces):
            self.points, self.faces, self.cell_data = points, faces, {}

    monkeypatch.setitem(sys.modules, "pyvista", types.SimpleNamespace(PolyData=PolyData))
    with read(files["every"]) as every:
        frame = every[-1]
        mesh = frame.to_pyvista()
    faces, shown = mesh.faces.tolist(), []
    while faces:
        count = faces.pop(0)
        shown.append(mesh.points[faces[:count]])
        del faces[:count]
    polygons = [polygon for polygon in frame.polygons if len(polygon)]
    assert len(shown) == len(polygons) == 35
    for own, polygon in zip(shown, polygons):
        np.testing.assert_array_equal(own, np.column_stack([polygon, np.zeros(len(polygon))]))
    assert set(mesh.cell_data) == set(frame.names)
    np.testing.assert_array_equal(mesh.cell_data["Stress"], frame["Stress"][:35])
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="pip install pyvista"):
        frame.to_pyvista()


def test_no_other_package_is_needed(files):
    code = (
        "import sys\n"
        "for name in ('matplotlib', 'pandas', 'pyvista', 'IPython'): sys.modules[name] = None\n"
        "from blocks.results import read\n"
        "results = read(sys.argv[1])\n"
        "assert results._repr_png_() is None and '<img' not in results._repr_html_()\n"
        "try: results[-1].plot()\n"
        "except ImportError as error: print(error)\n"
    )
    environment = {**os.environ, **PRELOADED}
    done = subprocess.run([sys.executable, "-c", code, files["stack"]], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    assert "apt install python3-matplotlib" in done.stdout


# --- Files that a run is writing


def set_mark(path, number):
    with open(path, "r+b") as file:
        file.seek(len(results_file._MARK))
        file.write(b"%020d" % number)


def test_a_run_that_goes_on(tmp_path, files):
    deck = DECKS / "stack/stack.deck"
    run("run", deck, "-o", tmp_path / "on", "--until", ".3", "-q", "--threads", 1)
    with read(tmp_path / "on.vtkhdf") as results:
        assert len(results) == 4 and results.refresh() == 0
        early = results[1]
        run("run", deck, "-o", tmp_path / "on", "--restart", tmp_path / "on.ckpt.h5", "--until", ".6", "-q")
        assert len(results) == 4
        with read(files["stack"]) as whole:
            np.testing.assert_array_equal(early.velocity, whole[1].velocity)  # from the changed file
        assert results.refresh() == 4  # the run wrote a frame where it stopped
        assert len(results) == 8 and results[-1].time == pytest.approx(0.6, abs=1e-3)


def test_reading_while_a_run_writes(tmp_path):
    path = tmp_path / "busy.vtkhdf"
    deck = (DECKS / "crater_cracks/crater_cracks.deck").read_text()
    (tmp_path / "busy.deck").write_text(deck.replace("PLOTS, 0.02", "PLOTS, .001"))
    command = [PROGRAM, "run", tmp_path / "busy.deck", "-o", tmp_path / "busy", "-q", "--threads", "1"]
    command += ["--until", ".2"]
    with subprocess.Popen([*map(str, command)], stdout=subprocess.DEVNULL) as running:
        while not path.exists() and running.poll() is None:
            time.sleep(0.002)
        results, seen, last, sums = read(path), 0, {}, {}
        while running.poll() is None:
            seen += results.refresh() > 0
            frame = results[-1]
            assert len(frame.polygons) == len(frame.centroid) == len(frame)
            assert len(frame.cracks) == np.count_nonzero(frame.parent >= 0)
            sums[frame.index] = frame.velocity.sum(), len(frame.contacts), len(results.history)
    assert running.returncode == 0 and seen > 3
    results.refresh()
    assert len(results) > 150
    for index, (total, contacts, samples) in sums.items():
        assert results[index].velocity.sum() == total and len(results[index].contacts) == contacts
        assert samples <= len(results.history)
    results.close()


def test_a_change_that_does_not_end(tmp_path, files, monkeypatch):
    path = shutil.copy(files["stack"], tmp_path)
    monkeypatch.setattr(results_file, "_PATIENCE", 0.1)
    results = read(path)
    number = results._file._marked.changes()
    assert number > 0 and number % 2 == 0
    set_mark(path, number + 1)
    assert results[2].spin.shape == (13,)  # no lock: the run has ended
    with open(path, "rb") as writer:
        fcntl.flock(writer, fcntl.LOCK_EX)
        with pytest.raises(FileError, match="a run is writing to it now; try again"):
            results[3].spin
        set_mark(path, number + 2)
        assert results[3].spin.shape == (13,)
    results.close()


def test_a_change_during_reading_repeats_it(tmp_path, files):
    path = shutil.copy(files["stack"], tmp_path)
    with read(path) as results:
        number, calls = results._file._marked.changes(), []

        def action(file):
            calls.append(file)
            if len(calls) == 1:
                set_mark(path, number + 2)
                raise KeyError("half of the data")
            return len(calls)

        assert results._file.read(action) == 2
        assert not calls[0] and calls[1]  # the file was opened again


def test_frames_that_a_restart_removes(tmp_path, files):
    path = shutil.copy(files["stack"], tmp_path)
    with read(path) as results:
        with h5py.File(path, "r+") as file:
            file["VTKHDF/Steps"].attrs["NSteps"] = 2
        set_mark(path, results._file._marked.changes() + 2)
        with pytest.raises(FileError, match="a restart has removed frames"):
            results[5].spin
        assert results.refresh() == -4
        assert len(results) == 2 and results[-1].spin.shape == (13,)


def test_a_file_that_is_replaced(tmp_path, files):
    path = shutil.copy(files["stack"], tmp_path)
    with read(path) as results:
        os.replace(shutil.copy(files["every"], tmp_path / "new"), path)
        assert results[1].spin.shape == (13,)  # still the file that was opened
        with pytest.raises(FileError, match="another file has replaced it; read it again"):
            results.refresh()


# --- Files that are no results


@pytest.mark.parametrize(
    "name, data, words",
    [
        ("a.vtkhdf", b"", "it is empty"),
        ("a.txt", b"some words\n", "not a results file of BLOCKS, but a text file"),
        ("a.json", b'{"a": 1}', "a JSON file"),
        ("a.deck", b"START, 1\n", "but a deck; `blocks run` makes results from it"),
        ("a.bin", b"\x7fELF\0\0\1", "a file of another program"),
        ("a.vtkhdf", results_file._MARK + b"0" * 20 + b" " * 444, "it is truncated, it has no data"),
        ("a.vtkhdf", results_file._HDF5_HEAD + b"\0" * 90, "it is damaged"),
    ],
)
def test_other_files(tmp_path, name, data, words):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(FileError, match=words) as caught:
        read(tmp_path / name)
    assert name in str(caught.value) and "hint:" in str(caught.value)


def test_other_files_of_a_run(files):
    for ending, words in ((".out", "a listing of a run"), (".ckpt.h5", "a checkpoint, for RESTART")):
        with pytest.raises(FileError, match=words) as caught:
            read(files["stack"].with_suffix("").with_suffix(ending))
        assert "hint: results in this folder: " in str(caught.value)
    with pytest.raises(FileError, match="No such file .*\n.*results in this folder: .*every.vtkhdf"):
        read(files["stack"].with_name("none.vtkhdf"))
    with pytest.raises(FileError, match="Is a directory"):
        read(files["stack"].parent)


def test_other_hdf5_files(tmp_path, files):
    with h5py.File(tmp_path / "other.h5", "w") as file:
        file["x"] = 1
    with pytest.raises(FileError, match="an HDF5 file of another program"):
        read(tmp_path / "other.h5")
    for change, words in (
        (lambda file: file["BLOCKS"].attrs.modify("format", 2), "a newer version of BLOCKS"),
        (lambda file: file["VTKHDF/Steps"].attrs.modify("NSteps", 0), "it has no frames yet"),
        (lambda file: file.__delitem__("VTKHDF/Steps/Values"), "it is damaged .*Values"),
    ):
        path = shutil.copy(files["stack"], tmp_path / "changed.vtkhdf")
        with h5py.File(path, "r+") as file:
            change(file)
        with pytest.raises(FileError, match=words):
            read(path)


@pytest.mark.parametrize(
    ("name", "damage", "words"),
    [
        ("Offsets", lambda old: old[:0], "wrong shape"),
        ("Offsets", lambda old: old[..., None], "wrong shape"),
        ("Offsets", lambda old: old[::-1], "out of range"),
        ("Offsets", lambda old: old.astype(float), "wrong shape or type"),
        ("Connectivity", lambda old: old - 1, "out of range"),
        ("Connectivity", lambda old: old + len(old), "out of range"),
        ("Points", lambda old: old[:1], "wrong shape"),
    ],
)
def test_damaged_outlines(tmp_path, files, name, damage, words):
    path = shutil.copy(files["stack"], tmp_path / "damaged.vtkhdf")
    with h5py.File(path, "r+") as file:
        old = file["VTKHDF"][name][()]
        del file["VTKHDF"][name]
        file["VTKHDF"][name] = damage(old)
    with read(path) as results, pytest.raises(FileError, match=f"{name} .*{words}"):
        results[0].to_geojson()


@pytest.mark.parametrize("name", ["Fixed", "BlockNumber", "Velocity"])
def test_missing_arrays(tmp_path, files, name):
    path = shutil.copy(files["stack"], tmp_path / "damaged.vtkhdf")
    with h5py.File(path, "r+") as file:
        file["VTKHDF/Steps/CellDataOffsets"][name].resize((0,))
    with read(path) as results:
        with pytest.raises(FileError, match=f"frame 0 has no {name}"):
            results[0][name]
        with pytest.raises(KeyError):
            results[0]["speed of light"]


@pytest.mark.parametrize("name", ["BLOCKS/steps", "VTKHDF/Steps/Values"])
@pytest.mark.parametrize("damage", [lambda old: old[..., None], lambda old: old[:0], lambda old: old.astype("S8")])
def test_damaged_times(tmp_path, files, name, damage):
    path = shutil.copy(files["stack"], tmp_path / "damaged.vtkhdf")
    with h5py.File(path, "r+") as file:
        old = file[name][()]
        del file[name]
        file[name] = damage(old)
    with pytest.raises(FileError, match="it is damaged"):
        read(path)


def make_external(file, path, place):
    old = file[path]
    shape, dtype = old.shape, old.dtype
    del file[path]
    file.create_dataset(path, shape, dtype, external=[(str(place), 0, h5py.h5f.UNLIMITED)])


def make_virtual(file, path, place):
    old = file[path]
    layout = h5py.VirtualLayout(old.shape, old.dtype)
    layout[...] = h5py.VirtualSource(str(place), "x", old.shape)
    del file[path]
    file.create_virtual_dataset(path, layout)


def make_link(file, path, place):
    del file[path]
    file[path] = h5py.ExternalLink(str(place), "/x")


def make_soft(file, path, place):
    del file[path]
    file[path] = h5py.SoftLink("/BLOCKS/title")


@pytest.mark.parametrize("change", [make_external, make_virtual, make_link, make_soft])
def test_data_of_other_files(tmp_path, files, change):
    os.mkfifo(tmp_path / "fifo")
    with pytest.raises(FileError, match="not a regular file"):
        read(tmp_path / "fifo")
    for place in ("VTKHDF/CellData/Material", "BLOCKS/contacts/Corner", "VTKHDF/Points"):
        path = shutil.copy(files["stack"], tmp_path / "changed.vtkhdf")
        with h5py.File(path, "r+") as file:
            change(file, place, tmp_path / "fifo")
        with pytest.raises(FileError, match=f"{place} is (stored in another file|a link)"):
            read(path)


@pytest.mark.parametrize("name", ["CornerBlock", "Corner", "EdgeBlock", "Edge"])
@pytest.mark.parametrize("value", [-(2**31), -1, 0, 99, 2**31 - 1])
def test_contacts_out_of_range(tmp_path, files, name, value):
    if (name, value) == ("EdgeBlock", 0):
        return  # a symmetry plane
    path = shutil.copy(files["stack"], tmp_path / "changed.vtkhdf")
    with h5py.File(path, "r+") as file:
        file["BLOCKS/contacts/" + name][...] = value
    with read(path) as results, pytest.raises(FileError, match=f"contacts/{name} is out of range"):
        results[-1].contacts


def test_a_truncated_file(tmp_path, files):
    data = files["stack"].read_bytes()
    short = tmp_path / "short.vtkhdf"
    short.write_bytes(data[: len(data) // 2])
    said = run("plot", short, "-o", tmp_path / "x.png", check=False).stderr
    with pytest.raises(FileError, match="it is truncated, it has .* bytes") as caught:
        read(short)
    assert str(caught.value).splitlines()[0] in said
