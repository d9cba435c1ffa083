"""Decks built in Python, checked and run."""

import inspect
import json
import os
import pickle
import signal
import subprocess
import sys
import time
import warnings

import numpy as np
import pytest

import blocks
from conftest import PRELOADED


def two_boxes():
    deck = blocks.Deck(name="boxes")
    deck.start(10, 4, lines=["TWO BOXES"])
    deck.xlimits(-2, 12).ylimits(-2, 12).boxes(14, 14, 0.25).stiff(1e8, 1e8).fraction(0.05)
    deck.material(1, 1e9, 4e8, 2500).rigid().end()
    deck.create(4, 1, 1, lines=[(0, 0, 10, 10), (-1, 0, 0, -1)])
    deck.create(4, 1, lines=[np.array([2, 2, 3, 3]), np.array([0.1, 1.1, 1.1, 0.1])])
    return deck.gravity(0, -9.81).frictn(fric=0.5).damping(0.2)


def test_every_card_is_a_method_with_its_help():
    for card in blocks.card_table():
        method = getattr(blocks.Deck, card["name"].lower())
        assert card["summary"] in inspect.getdoc(method)
        names = list(inspect.signature(method).parameters)
        assert len(names) == 1 + len(card["fields"]) + bool(card["lines"]), card["name"]
        for field in card["fields"]:
            assert field["help"] in inspect.getdoc(method)


def test_cards_keep_every_digit():
    deck = blocks.Deck().frictn(0.1 + 0.2).gravity(np.float64(1) / 3, np.int64(-9))
    assert deck.text == "FRICTN, 0.30000000000000004\nGRAVITY, 0.3333333333333333, -9\n"
    assert str(blocks.Deck().card("motion", None, 2)) == "MOTION, , 2\n"
    assert blocks.Deck().plots(0.1, 0.2, 0.5).text == "PLOTS, 0.1, 0.2, 0.5\n"
    with pytest.raises(TypeError):
        blocks.Deck().frictn(0.1, 2, 3, 4, 5, 6)
    with pytest.raises(TypeError, match="colour"):
        blocks.Deck().frictn(colour=1)
    with pytest.raises(TypeError, match="a field of a card"):
        blocks.Deck().frictn([1])
    assert blocks.Deck().start(9, 4, lines="ONE LINE").create(4, 1, np.bool_(True)).text.splitlines() == [
        "START, 9, 4", "ONE LINE", "CREATE, 4, 1, 1"]


@pytest.mark.parametrize("name", [
    "hard rock", "x$y", "x!y", "a,b", '"x"', "'x'", "it's", 'say "go"', "\u00e9t\u00e9 \u2028", " x ", "a\tb"])
def test_texts_are_one_field_whatever_they_contain(name):
    deck = two_boxes()
    deck.insert("RIGID", blocks.Deck().material(2, 1e9, 4e8, 2500, name))
    assert blocks.check(deck.create(4, 2, lines=[(5, 5, 6, 6), (2, 3, 3, 2)]).cycle(1)).materials == {2: name}
    assert blocks.Deck(deck.text).text == deck.text


@pytest.mark.parametrize("text", ["x\nRIGID", "x\r", "x\0y", "\x1b[1m", "'a' \"b\""])
def test_texts_that_a_card_cannot_have_are_refused(text):
    deck = blocks.Deck()
    with pytest.raises(ValueError):
        deck.material(1, 1e9, 4e8, 2500, text)
    with pytest.raises(ValueError, match="one word"):
        deck.card(text + "\n")
    if "'" not in text:
        with pytest.raises(ValueError):
            deck.start(10, 4, lines=[text])
    assert len(deck) == 0


def test_a_deck_runs_as_its_text_does(program, tmp_path):
    deck = two_boxes().plots(0.1).history(0.01, "y:2", "kinetic_energy").motion(0.5).stop()
    path = deck.write(tmp_path / "boxes.deck")
    subprocess.run([program, "run", path, "-o", tmp_path / "cli", "-q"], check=True)
    hashes = {json.loads((tmp_path / "cli.summary.json").read_text())["state_hash"]}
    for i, one in enumerate([deck, deck.text, path, str(path)]):
        run = blocks.run(one, tmp_path / f"run{i}", threads=i)
        hashes.add(run.summary["state_hash"])
        assert run.status == "done" and repr(run).endswith(f"{run.summary['steps']} steps, time {run.results.times[-1]:g}>")
    assert len(hashes) == 1
    assert len(run.results) == 6 and "y:2" in run.results.history
    assert "TWO BOXES" in run.listing


def test_write_keeps_other_files(tmp_path):
    deck, path = two_boxes(), tmp_path / "boxes.deck"
    precious = tmp_path / "precious"
    precious.write_text("mine")
    os.link(precious, path)
    deck.write(path)
    assert precious.read_text() == "mine" and path.read_text() == deck.text
    backup = tmp_path / "boxes.deck.bak"
    assert backup.read_text() == "mine"
    deck.write(path)
    assert backup.read_text() == "mine"  # nothing has changed
    path.unlink()
    path.symlink_to(precious)
    with pytest.raises(blocks.FileError, match="it is a link"):
        deck.write(path)
    path.unlink()
    os.mkfifo(path)
    with pytest.raises(blocks.FileError, match="not a regular file"):
        deck.write(path)
    assert precious.read_text() == "mine"


def test_values_replace_fields(tmp_path):
    deck = two_boxes().motion(0.1).stop()
    plain = blocks.run(deck, tmp_path / "a")
    changed = blocks.run(deck, tmp_path / "b", set={"GRAVITY.gravy": -1.5}, until=0.05)
    assert changed.summary["state_hash"] != plain.summary["state_hash"]
    assert changed.results.times[-1] == pytest.approx(0.05, rel=0.02)
    with pytest.raises(blocks.DeckError, match="FRICTION"):
        blocks.run(deck, tmp_path / "c", set={"FRICTION.fric": 1})
    with pytest.raises(ValueError, match="CARD.field"):
        blocks.run(deck, tmp_path / "c", set={"fric": 1})
    assert not (tmp_path / "c.out").exists()


def test_errors_print_as_on_the_command_line(program, tmp_path):
    path = two_boxes().frictn(-1).card("MOTON", 2).write(tmp_path / "bad.deck")
    printed = subprocess.run([program, "check", path], check=False, capture_output=True, text=True).stderr
    for function in (blocks.check, blocks.Simulation, lambda deck: blocks.run(deck, tmp_path / "bad")):
        with pytest.raises(blocks.DeckError) as error:
            function(path)
        if function is not blocks.Simulation:
            assert str(error.value) == printed.rstrip("\n")
        first, second = error.value.diagnostics[:2]
        assert (first.card, first.severity, first.file) == ("FRICTN", "error", str(path))
        assert second.hint and second.message and str(second) in printed
    with pytest.raises(OSError, match="absent.deck"):
        blocks.check(tmp_path / "absent.deck")


def test_faults_of_files_have_their_reason(tmp_path):
    for function in (blocks.check, lambda deck: blocks.run(deck, tmp_path / "x")):
        with pytest.raises(blocks.FileError, match="nope.h5") as error:
            function("RESTART, nope.h5\nCYCLE, 5\n")
        assert [one.card for one in error.value.diagnostics] == ["RESTART"]
    with pytest.raises(ValueError, match="empty"):
        blocks.check("")


def test_errors_can_be_pickled(tmp_path):
    with pytest.raises(blocks.DeckError) as error:
        blocks.check(two_boxes().frictn(-1))
    again = pickle.loads(pickle.dumps(error.value))
    assert type(again) is blocks.DeckError and str(again) == str(error.value)
    assert [str(one) for one in again.diagnostics] == [str(one) for one in error.value.diagnostics]


def test_arguments_of_runs(tmp_path):
    deck = two_boxes().motion(0.1)
    for wrong in ({"threads": 50000}, {"threads": -1}, {"until": -1.0}, {"time_limit": float("nan")}, {"audit": -5},
                  {"seed": -5}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            blocks.run(deck, tmp_path / "x", **wrong)


def test_ctrl_c_ends_a_run_at_a_checkpoint(tmp_path):
    """Also twice, and the handlers of Python stay."""
    script = tmp_path / "endless.py"
    deck = two_boxes().motion(1e6).text
    script.write_text("import blocks, signal\n"
                      "before = signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)\n"
                      f"try:\n    print('ready', flush=True)\n    blocks.run({deck!r}, {str(tmp_path / 'x')!r})\n"
                      "except KeyboardInterrupt:\n"
                      "    print('stopped', before == (signal.getsignal(signal.SIGINT), signal.getsignal(signal.SIGTERM)))\n")
    process = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True,
                               env={**os.environ, **PRELOADED})
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=300)[0] == "stopped True\n"
    assert json.loads((tmp_path / "x.summary.json").read_text())["status"] == "interrupted"
    assert (tmp_path / "x.ckpt.h5").exists()


def test_warnings_are_warnings(tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        blocks.check(two_boxes().motion(1))
        blocks.check(two_boxes())  # the program makes the steps
    with pytest.warns(blocks.DeckWarning, match="friction coefficient 35"):
        blocks.check(two_boxes().frictn(35))


def test_unsound_runs_raise_and_keep_their_files(tmp_path):
    deck = two_boxes().setvel(2, 0, -1e7)
    with pytest.raises(blocks.UnsoundRun, match="moved a corner"):
        blocks.run(deck.motion(1), tmp_path / "fast")
    assert (tmp_path / "fast.summary.json").exists()


def test_deck_objects(tmp_path):
    deck = two_boxes()
    assert repr(deck) == f"<Deck boxes: {len(deck)} lines>"
    again = blocks.Deck.read(deck.write(tmp_path / "x.deck"))
    assert again.text == deck.text
    both = blocks.Deck("START, 9, 4\nMOTION OF A BLOCK\nEND\nMOTION, 1\nMOTION, 2\n")
    both.insert("motion", blocks.Deck().history(0.1, "y:1"))
    assert both.text.splitlines()[2:5] == ["END", "HISTORY, 0.1, y:1", "MOTION, 1"]
    with pytest.raises(ValueError, match="no card CYCLE"):
        both.insert("CYCLE", "PLOTS, 1")
    assert blocks.Deck().comment("one\ntwo").text == "$ one\n$ two\n"


def test_layers_and_joints_have_a_certificate():
    layers = blocks.layers([[(0, 0), (0, 1), (10, 1), (10, 0)], [(0, 1), (0, 3), (10, 3), (10, 1)]], [5, 8], seed=7)
    assert len(layers) == 13 and layers.certificate["holds"]
    assert layers.certificate["verdict"] == "no two of 13 blocks overlap"
    assert layers.area.sum() == pytest.approx(30)
    assert blocks.layers([(0, 0), (0, 1), (10, 1), (10, 0)], 4, random=False).area.tolist() == [2.5] * 4
    other = blocks.layers([(0, 0), (0, 1), (10, 1), (10, 0)], 4, seed=8)
    assert (other.area != blocks.layers([(0, 0), (0, 1), (10, 1), (10, 0)], 4, seed=9).area).any()
    cut = blocks.joints([(0, 0), (0, 10), (20, 10), (20, 0)], [{"id": 1, "dip": 30, "space": 2},
                                                            {"id": 2, "dip": 120, "space": 3}])
    assert len(cut) > 10 and cut.certificate["holds"] and set(np.unique(cut.joint)) == {0, 1, 2}
    assert cut.area.sum() == pytest.approx(200, rel=1e-12)
    assert "no two of" in repr(cut) and not cut.corners.flags.writeable
    deck = cut.to_deck(blocks.Deck(), fixed=[0])
    assert deck.text.count("CREATE") == len(cut)
    with pytest.raises(ValueError, match="shape"):
        blocks.layers([(0, 0), (1, 1)], 3)
    with pytest.raises(ValueError, match="number of blocks of a layer"):
        blocks.layers([(0, 0), (0, 1), (10, 1), (10, 0)], -5)
    with pytest.raises(blocks.DeckError):
        blocks.joints([(0, 0), (0, 10), (20, 10), (20, 0)], [{"id": 1, "space": -2}])


def test_predicates_on_a_million_rows():
    rng = np.random.default_rng(1)
    c, p1, p2 = rng.uniform(-1, 1, (3, 1_000_000, 2))
    signs = blocks.predicates.overlap_sign(c, p1, p2)
    e, d = p2 - p1, c - p1
    area = d[:, 0] * e[:, 1] - d[:, 1] * e[:, 0]
    sure = np.abs(area) > 1e-12
    np.testing.assert_array_equal(signs[sure], np.sign(area[sure]))
    # On the line, a third of its length from one end, to the last bit: doubles get many of these wrong.
    k = rng.integers(1, 2**20, 1000)[:, None] * [1.0, 0.0] + [0.0, 7.0]
    a, b = np.zeros((1000, 2)), 3 * k
    assert (blocks.predicates.overlap_sign(k, a, b) == 0).all()
    up = np.nextafter(k[:, 1], 10)
    assert (blocks.predicates.overlap_sign(np.c_[k[:, 0], up], a, b) == -1).all()
    assert blocks.predicates.overlap_sign((0, 1), (0, 0), (1, 0)) == -1
    assert blocks.predicates.between([(0.5, 3), (2, 0)], (0, 0), (1, 0)).tolist() == [True, False]
    with pytest.raises(ValueError, match="p2 has 2 rows"):
        blocks.predicates.overlap_sign(np.zeros((3, 2)), (0, 0), np.ones((2, 2)))
    with pytest.raises(ValueError, match="finite"):
        blocks.predicates.overlap_sign((0, np.nan), (0, 0), (1, 0))


def test_study():
    table = blocks.study(["wedge", "tee"], ["default", "report"], frames=2)
    assert len(table) == 4 and list(table["scene"]) == ["wedge"] * 2 + ["tee"] * 2
    assert (table["frames"] == 2).all() and table["hung"][0] == 0
    with pytest.raises(ValueError, match="no scene 'edge'"):
        blocks.study("edge")
    with pytest.raises(ValueError, match="no variant 'round'"):
        blocks.study("wedge", "round")
    with pytest.raises(ValueError, match="frames"):
        blocks.study("wedge", frames=-1)


def test_sweeps(tmp_path):
    deck = two_boxes().motion(0.1).stop()
    sweep = blocks.sweep(deck, tmp_path / "many", set={"FRICTN.fric": [0.1, 0.5]}, jobs=2)
    assert len(sweep) == 2 and repr(sweep).endswith("2 runs, 2 ended>")
    assert [sweep.outcome(run)["code"] for run in (1, 2)] == [0, 0]
    table = sweep.table("y:2")
    assert len(table) == 2 and list(table["FRICTN.fric"]) == [0.1, 0.5]
    assert sweep.results(2).times[-1] >= 0.1
    assert blocks.Sweep(tmp_path / "many").resume().plan == sweep.plan
    assert "<table" in sweep._repr_html_() or "<pre" in sweep._repr_html_()
    with pytest.raises(blocks.BlocksError, match="FRICTION"):
        blocks.sweep(deck, tmp_path / "none", set={"FRICTION.fric": [1]})
    named = blocks.sweep(deck, tmp_path / "named", set={"MATERIAL.name": ["soft rock", "a!b$c", "x,y"]})
    assert len(named) == 3
    with pytest.raises(blocks.BlocksError, match="another deck"):
        blocks.sweep(deck.frictn(0.2), tmp_path / "many", seeds=[1])
    assert blocks.Sweep(tmp_path / "many").resume().plan == sweep.plan
    with pytest.raises(ValueError, match="no seeds"):
        blocks.sweep(deck, tmp_path / "none", seeds=range(0))
    with pytest.raises(blocks.FileError):
        blocks.Sweep(tmp_path)


def test_assembly_as_geojson_is_that_of_export(decks, program, tmp_path):
    stack = (decks / "stack" / "stack.deck").read_text()
    (tmp_path / "stack.deck").write_text(stack)
    (tmp_path / "removed.deck").write_text(stack.replace("MOTION", "REMOVE, 3\nMOTION"))
    for deck in (tmp_path / "stack.deck", tmp_path / "removed.deck", decks / "slope" / "slope.deck"):
        subprocess.run([program, "export", deck, "-o", tmp_path / "whole.geojson"], check=True)
        whole = (tmp_path / "whole.geojson").read_text()
        assembly = blocks.check(deck)
        assert assembly.to_geojson() == whole
        assembly.to_geojson(tmp_path / "own.geojson")
        assert (tmp_path / "own.geojson").read_text() == whole
    assert assembly.joint.any() and "joints" in whole
    older = len(list(tmp_path.glob("own.geojson.bak*")))
    (tmp_path / "own.geojson").write_text("mine")
    assembly.to_geojson(tmp_path / "own.geojson")
    assert (tmp_path / f"own.geojson.bak{older + 1 if older else ''}").read_text() == "mine"
    with pytest.raises(blocks.FileError):
        assembly.to_geojson(tmp_path / "none" / "own.geojson")


def test_removed_blocks_of_an_assembly_are_left_out():
    deck = two_boxes()
    all_blocks, rest = blocks.check(deck), blocks.check(deck.remove(2))
    assert rest.is_removed.sum() == 1 and len(rest) == len(all_blocks)
    cards = [one.to_deck(blocks.Deck()).text.count("CREATE") for one in (all_blocks, rest)]
    assert cards == [len(rest), len(rest) - 1]
