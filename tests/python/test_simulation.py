"""A model driven step by step."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time
import weakref

import numpy as np
import pytest

import blocks
from conftest import PRELOADED

BEAM = "beam/beam.deck"


def test_same_bits_as_the_command_line(fall, program, tmp_path):
    """Steps one by one, in calls of any size and with any reading end in the state of `blocks run`."""
    deck = tmp_path / "fall.deck"
    deck.write_text(fall + "CYCLE, 3000\nSTOP\n")
    subprocess.run([program, "run", deck, "-o", tmp_path / "fall", "-q"], check=True)
    last = blocks.read(tmp_path / "fall.vtkhdf")[-1]
    one = blocks.Simulation(fall)
    one.step(3000)
    many = blocks.Simulation(fall, threads=2)
    for part in (1, 7, 992, 2000):
        many.step(part, read=part == 7)
    for simulation in (one, many):
        assert simulation.steps == 3000
        np.testing.assert_array_equal(simulation.corners, last.corners)
        np.testing.assert_array_equal(simulation.velocity, last.velocity)


def test_arrays_are_views_of_the_present_state(fall):
    sim = blocks.Simulation(fall)
    centroid, corners = sim.centroid, sim.corners
    before = centroid.copy()
    sim.step(10)
    assert np.shares_memory(centroid, sim.centroid)
    assert centroid[1, 1] < before[1, 1]
    np.testing.assert_array_equal(corners, sim.corners)
    assert corners.shape == (12, 2) and sim.first_corner.tolist() == [0, 4, 8, 12]
    assert [len(outline) for outline in sim.polygons] == [4, 4, 4]
    for name in ("corners", "centroid", "mass", "stress", "first_corner", "force", "angle"):
        with pytest.raises(ValueError, match="read-only"):
            getattr(sim, name)[...] = 0


def test_velocities_can_be_written_to(fall):
    """A write to the view counts from the next step on, also if the view has been dropped."""
    sims = [blocks.Simulation(fall) for _ in range(3)]
    sims[0].velocity[1] = (2.0, 0.5)
    sims[0].spin[1] = 0.25
    sims[1].set_velocity(1, (2.0, 0.5), 0.25)
    velocity = np.zeros((3, 2))
    velocity[1] = 2.0, 0.5
    sims[2].velocity = velocity
    sims[2].spin = [0, 0.25, 0]
    for sim in sims:
        sim.step(200)
    for sim in sims[1:]:
        np.testing.assert_array_equal(sim.corners, sims[0].corners)
    assert sims[0].velocity[1, 0] == 2.0
    kept = sims[0].velocity
    sims[0].step(5)
    kept[1, 0] = -1.0
    sims[0].step()
    assert sims[0].velocity[1, 0] == -1.0


def test_velocities_that_are_not_possible_are_refused(fall):
    sim = blocks.Simulation(fall)
    sim.velocity[0] = 1.0
    with pytest.raises(ValueError, match="block 0 is not free"):
        sim.step()
    assert (sim.velocity == 0).all() and sim.steps == 0
    with pytest.raises(ValueError, match="not finite"):
        sim.velocity = np.full((3, 2), np.nan)
    with pytest.raises(IndexError, match="block 3 is not in range 0 to 2"):
        sim.set_velocity(3, (0, 0))
    sim.step()


def test_forces_act_until_they_are_replaced(fall):
    """A force equal to the weight holds a block in the air."""
    sim = blocks.Simulation(fall)
    weight = 9.81 * sim.mass[1]
    sim.set_force(1, (0, weight))
    place = sim.centroid[1].copy()
    sim.step(100)
    np.testing.assert_allclose(sim.centroid[1], place, atol=1e-12)
    sim.set_force(1, (0, 0))
    time, dt = sim.time, sim.time_step
    sim.step(10)
    fallen = 9.81 * dt * dt * sum(range(1, 11))
    np.testing.assert_allclose(place[1] - sim.centroid[1, 1], fallen, rtol=1e-9)
    assert sim.time == pytest.approx(time + 10 * dt)


def test_contacts_carry_the_weight(fall):
    sim = blocks.Simulation(fall)
    sim.run_until(3.0)
    contacts = sim.contacts
    weights = 9.81 * sim.mass
    on_floor = contacts[contacts["edge_block"] == 0]
    assert set(on_floor["corner_block"]) == {1}
    np.testing.assert_allclose(on_floor["force"].sum(axis=0), [0, weights[1] + weights[2]], rtol=1e-3, atol=1)
    np.testing.assert_allclose(sim.contact_force[2], [0, weights[2]], rtol=1e-3, atol=1)
    np.testing.assert_array_equal(contacts["point"], sim.corners[contacts["corner"]])
    np.testing.assert_allclose(np.linalg.norm(contacts["normal"], axis=1), 1)


def test_contacts_of_a_step_that_was_not_read_are_not_known(fall):
    sim = blocks.Simulation(fall)
    assert len(sim.contacts) == 0
    sim.step()
    assert sim.is_read  # because contacts were asked for
    sim.step()
    with pytest.raises(blocks.NotReadError, match="step 2"):
        sim.contacts
    sim.step()
    sim.contacts
    sim.step(1, read=False)
    with pytest.raises(blocks.NotReadError):
        sim.contact_force
    sim.step(100)
    sim.contacts


def test_callbacks(fall):
    sim = blocks.Simulation(fall)
    seen = []
    sim.step(25, every=10, callback=lambda s: seen.append(s.steps))
    assert seen == [10, 20] and sim.steps == 25
    sim.step(100, every=5, callback=lambda s: s.steps >= 40)
    assert sim.steps == 40
    calls = []
    blocks.Simulation(fall).step(3, callback=lambda s: calls.append(len(s.contacts)))
    assert len(calls) == 3
    blocks.Simulation(fall).step(3, callback=lambda s: [])

    def fails(_):
        raise KeyError("of the callback")

    with pytest.raises(KeyError, match="of the callback"):
        sim.step(100, every=1, callback=fails)
    assert sim.steps == 41
    sim.step(3, every=1, callback=lambda s: s.velocity.__setitem__((1, 0), 1.0))
    assert sim.velocity[1, 0] == 1.0


def test_cards_and_their_errors(fall):
    sim = blocks.Simulation(fall)
    before = sim.centroid
    kept = before.copy()
    sim.cards("CREATE, 4, 1\n5, 5, 6, 6\n1, 2, 2, 1\n")
    assert len(sim) == 4 and sim.centroid.shape == (4, 2)
    sim.step(50)
    np.testing.assert_array_equal(before, kept)  # a view of the blocks before the card
    with pytest.raises(blocks.DeckError) as error:
        sim.cards("FIX, 2\nFIX, 17\nFRICTN, -1\n")
    assert [(d.line, d.card, d.severity) for d in error.value.diagnostics] == [(2, "FIX", "error"),
                                                                              (3, "FRICTN", "error")]
    assert "cards:2:6: error: FIX" in str(error.value) and "hint" in str(error.value)
    assert len(sim) == 4
    more = blocks.Deck().frictn(0.1)
    sim.cards(more)
    with pytest.raises(blocks.DeckError):
        blocks.Simulation(fall.replace("STIFF", "STUFF"))


def test_unsound_runs_can_still_be_seen(fall):
    sim = blocks.Simulation(fall)
    sim.step(10)
    sim.velocity[1] = 0, -1e7
    with pytest.raises(blocks.UnsoundRun):
        sim.step(10)
    assert sim.steps == 11 and len(sim.polygons) == 3
    with pytest.raises(blocks.UnsoundRun):
        sim.step()


def test_blocks_that_split(decks):
    """Views of before a crack keep their values, and the arrays grow."""
    sim = blocks.Simulation((decks / BEAM).read_text().split("GRAVITY")[0] + "GRAVITY, 0., -9.81, .2\n")
    before = sim.corners
    blocks_before = len(sim)
    sim.run_until(0.4, every=200, callback=lambda s: len(s) > blocks_before)
    assert len(sim) > blocks_before
    assert len(before) < len(sim.corners) == sim.first_corner[-1]
    assert np.isfinite(before).all()
    cracks = sim.cracks
    assert len(cracks) == len(sim) - blocks_before
    np.testing.assert_array_equal(cracks["child"], blocks_before + np.arange(len(cracks)))
    assert (cracks["parent"] < cracks["child"]).all()


def test_views_of_callbacks_outlive_cracks(decks):
    """Views that a callback takes keep their memory when blocks split in the next steps."""
    sim = blocks.Simulation((decks / BEAM).read_text().split("GRAVITY")[0] + "GRAVITY, 0., -9.81, .2\n")
    kept = []
    sim.run_until(0.4, every=20, callback=lambda s: kept.append((len(s), s.corners, s.velocity)))
    assert kept[0][0] < kept[-1][0] == len(sim)
    for count, corners, velocity in kept:
        assert np.isfinite(corners).all() and len(velocity) == count
        velocity[:] += 0.0
    np.testing.assert_array_equal(kept[-1][1], sim.corners)


def test_views_stay_when_cards_add_no_blocks(fall):
    sim = blocks.Simulation(fall)
    velocity = sim.velocity
    sim.cards("FRICTN, 0.4")
    velocity[1] = 3.0, 0.0
    sim.step(2)
    assert sim.velocity[1, 0] == 3.0 and np.shares_memory(velocity, sim.velocity)


def test_one_thread_at_a_time(fall):
    """While a call of step is in its callback, no other thread gets at the simulation."""
    sim = blocks.Simulation(fall)
    inside, ends = threading.Event(), threading.Event()

    def waits(s):
        s.step(1)  # the same thread may
        inside.set()
        ends.wait(10)

    thread = threading.Thread(target=lambda: sim.step(2, every=1, callback=waits))
    thread.start()
    inside.wait(10)
    try:
        for use in (sim.step, lambda: sim.corners, lambda: sim.cards("FRICTN, 0.4"), lambda: sim.velocity):
            with pytest.raises(RuntimeError, match="another thread"):
                use()
        assert "another thread" in repr(sim)
    finally:
        ends.set()
        thread.join()
    sim.step()


def shuffled_boxes(count=4500):
    """Returns a deck whose numbers jump about, so that the steps use another order."""
    places = np.random.default_rng(1).permutation(count)
    cards = [f"START, {count}, 4", "BOXES AT RANDOM", "XLIMITS, -2, 200", "YLIMITS, -9, 200", "BOXES, 90, 90, .05",
             "STIFF, 1.E8, 1.E8", "FRACTION, .05", "MATERIAL, 1, 1.E9, 4.E8, 2500", "RIGID", "END"]
    for place in places:
        x, y = 1.5 * (place % 70), 1.5 * (place // 70)
        cards += ["CREATE, 4, 1", f"{x}, {x}, {x + 1}, {x + 1}", f"{y}, {y + 1}, {y + 1}, {y}"]
    return "\n".join([*cards, "GRAVITY, 0, -9.81", ""])


def test_writes_in_a_model_with_an_order_of_its_own():
    sim = blocks.Simulation(shuffled_boxes())
    sim.step(3)
    sim.velocity[4000] = 5.0, 5.0
    sim.velocity[4000]
    sim.spin[4000] = 0.5
    falling = sim.velocity[4000, 1]
    sim.step(1)
    assert sim.velocity[4000, 0] == 5.0 and sim.spin[4000] == 0.5
    assert sim.velocity[4000, 1] == pytest.approx(falling - 9.81 * sim.time_step)
    kept = sim.velocity
    sim.step(2)
    np.testing.assert_array_equal(kept, sim.velocity)


def test_an_exception_of_a_signal_leaves_a_sound_model(decks):
    """Steps that end by an exception are no writes of Python, also if blocks have split."""
    sim = blocks.Simulation((decks / BEAM).read_text().split("GRAVITY")[0] + "GRAVITY, 0., -9.81, .2\n")
    velocity = sim.velocity

    def stops(number, frame):
        raise InterruptedError

    before = signal.signal(signal.SIGALRM, stops)
    try:
        for _ in range(5):
            signal.setitimer(signal.ITIMER_REAL, 0.05)
            with pytest.raises(InterruptedError):
                sim.step(10**9)
            sim.step(2)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert sim.steps > 10 and np.isfinite(velocity).all()


def test_a_checkpoint_keeps_forces(fall, tmp_path):
    sim = blocks.Simulation(fall)
    sim.set_force(1, (300, 100))
    sim.step(20)
    sim.write_checkpoint(tmp_path / "pushed.ckpt.h5")
    again = blocks.Simulation(f"RESTART, {tmp_path / 'pushed.ckpt.h5'}\n")
    for one in (sim, again):
        one.step(50)
    np.testing.assert_array_equal(again.corners, sim.corners)
    again.set_force(1, (0, 0))
    with pytest.raises(ValueError, match="not free"):
        sim.set_force(0, (1, 0))


def test_views_outlive_their_simulation(fall):
    sim = blocks.Simulation(fall)
    sim.step(5)
    corners, velocity = sim.corners, sim.velocity
    values = corners.copy()
    died = weakref.ref(sim)
    del sim
    gc.collect()
    assert died() is None
    others = [blocks.Simulation(fall) for _ in range(20)]  # would reuse the memory
    np.testing.assert_array_equal(corners, values)
    velocity[...] = 1.0
    assert len(others) == 20 and corners.base is not None


def test_solve_tells_how_it_ended(fall):
    sim = blocks.Simulation(fall + "LOCDAMP, 0.8\n")
    before = sim.steps
    short = sim.solve(1e-9, nmax=30)
    assert short == (30, sim.unbalanced_ratio, False, 1e-9, sim.time, short.local, 100 * 1e-9, short.block)
    assert short.local > 0 and sim.is_free[short.block]
    assert sim.solutions == [short] and sim.warnings
    well = sim.solve(1e-3)
    assert well.converged and well.ratio <= 1e-3 == well.wanted
    assert well.local <= 0.01 == well.wanted_local
    assert sim.solve(1e-3, local=1.0).wanted_local == 1.0
    assert sim.steps == before + 30 + well.steps + sim.solutions[-1].steps
    sim.cards("SOLVE, 1.D-3, 50")
    assert len(sim.solutions) == 4
    with pytest.raises(blocks.DeckError):
        sim.solve(-1)
    with pytest.raises(TypeError):
        sim.solve(1e-3, 2.5)


def test_run_until_goes_to_the_same_time_twice(fall):
    sim = blocks.Simulation(fall)
    sim.run_until(0.1)
    steps = sim.steps
    sim.run_until(0.1)
    assert sim.steps == steps


def test_frames_and_checkpoints(fall, tmp_path):
    sim = blocks.Simulation(fall)
    for _ in range(3):
        sim.step(10)
        sim.write_frame(tmp_path / "sim.vtkhdf")
    results = blocks.read(tmp_path / "sim.vtkhdf")
    assert len(results) == 3
    np.testing.assert_array_equal(results[-1].corners, sim.corners)
    sim.write_checkpoint(tmp_path / "sim.ckpt.h5")
    again = blocks.Simulation(f"RESTART, {tmp_path / 'sim.ckpt.h5'}\n")
    sim.step(500)
    again.step(500)
    np.testing.assert_array_equal(again.corners, sim.corners)
    with pytest.raises(blocks.FileError):
        sim.write_frame(tmp_path / "absent" / "sim.vtkhdf")


def test_checkpoints_of_other_programs_are_kept(fall, tmp_path):
    (tmp_path / "sim.ckpt.h5").write_text("mine")
    sim = blocks.Simulation(fall)
    for _ in range(3):
        sim.write_checkpoint(tmp_path / "sim.ckpt.h5")
    assert (tmp_path / "sim.ckpt.h5.bak").read_text() == "mine"


def test_other_threads_run_meanwhile(fall):
    sim = blocks.Simulation(fall)
    sim.run_until(1.0)
    count, ends = [0], threading.Event()

    def counts():
        while not ends.is_set():
            count[0] += 1

    thread = threading.Thread(target=counts)
    thread.start()
    try:
        sim.step(20000)
    finally:
        ends.set()
        thread.join()
    assert count[0] > 100


def test_laws_of_joints_by_name_are_those_of_cards(fall):
    text, named = blocks.Simulation(fall), blocks.Simulation(fall)
    text.cards("JOINT, 4, 0.7, 2E5, , , , , , , 1E9\nJPAIR, 1, 1, 4\nGRAVITY, 1, -9.81")
    assert named.cards.joint(4, fric=0.7, coh=2e5, kn=1e9).jpair(1, 1, id=4).gravity(1, -9.81) is not None
    for sim in (text, named):
        sim.step(3000)
    assert (named.corners == text.corners).all() and (named.contacts == text.contacts).all()
    assert set(named.contacts["law"].tolist()) == {4} and (named.contacts["length"] > 0).any()
    with pytest.raises(blocks.DeckError, match="no JOINT card above has the id 5"):
        named.cards.bond(5)
    with pytest.raises(TypeError, match="frc"):
        named.cards.joint(4, frc=0.7)


def test_cards_by_name_bond_and_free(decks):
    sim = blocks.Simulation(decks / "stack" / "stack.deck", moves=False)
    assert sim.is_free.sum() == 12
    sim.cards.joint(1, fric=0.7, coh=1e5, ten=1e4).jpair(1, 1, 1).bond(1).fix(13)
    sim.step(100)
    assert sim.is_free.sum() == 11 and sim.contacts["bonded"].any()


def test_every_card_of_a_simulation_can_be_given_alone():
    names = {card["name"].lower() for card in blocks.card_table() if hasattr(blocks.SimulationCards, card["name"].lower())}
    assert {"joint", "walton", "barton", "jpair", "bond", "frictn", "damping", "force", "motion"} <= names
    assert not names & {"stiff", "end", "outline", "cut", "cloop", "plots", "stop"}
    assert "frictn" in repr(blocks.SimulationCards(print))


@pytest.mark.parametrize("endless", ["sim.step(10**12)", "sim.cards('MOTION, 1E9')", "sim.run_until(1e9)"])
def test_ctrl_c_stops_after_a_step(fall, tmp_path, endless):
    script = tmp_path / "endless.py"
    script.write_text("import blocks, sys\n"
                      f"sim = blocks.Simulation({fall!r})\n"
                      f"try:\n    print('ready', flush=True)\n    {endless}\n"
                      "except KeyboardInterrupt:\n    sim.step(3)\n    print('stopped', sim.steps > 3)\n")
    process = subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True, env={**os.environ, **PRELOADED})
    assert process.stdout.readline() == "ready\n"
    time.sleep(0.3)  # so that steps have begun
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=300)[0] == "stopped True\n"


def test_decks_with_motions(fall):
    """A deck makes its steps, or is executed up to the first of them."""
    deck = fall + "CYCLE, 20\nREMOVE, 3\nCYCLE, 10\nSTOP\n"
    assert blocks.Simulation(deck).steps == 30
    sim = blocks.Simulation(deck, moves=False)
    assert sim.steps == 0 and not sim.is_removed.any()
    sim.step(20)
    sim.cards("REMOVE, 3")
    sim.step(10)
    assert sim.is_removed.tolist() == [False, False, True]
    np.testing.assert_array_equal(sim.corners, blocks.Simulation(deck).corners)


def test_arguments(fall):
    sim = blocks.Simulation(fall)
    with pytest.raises(ValueError, match="not in range 0"):
        sim.step(-1)
    with pytest.raises(TypeError):
        sim.step(1.5)
    with pytest.raises(ValueError, match="threads is not in range 1 to 1024"):
        blocks.Simulation(fall, threads=1025)
    with pytest.raises(ValueError, match="not in range"):
        sim.step(10**30)
    with pytest.raises(ValueError, match="too many steps"):
        sim.run_until(1e300)
    with pytest.raises(ValueError, match="two components"):
        sim.set_velocity(1, (1, 2, 3))
    with pytest.raises(ValueError, match="not a finite"):
        sim.run_until(float("nan"))
    with pytest.raises(ValueError, match="the time -1 has passed: it is 0"):
        sim.run_until(-1.0)
    sim.run_until(0.0)
    assert sim.steps == 0
    with pytest.raises(ValueError, match="block 0 is not free"):
        sim.set_velocity(0, (1, 0))
    with pytest.raises(ValueError, match="no blocks"):
        blocks.Simulation(fall.split("CREATE")[0]).step()
    assert repr(sim).startswith("<Simulation 'BOXES FALL ON A FLOOR': 3 blocks, step 0, time 0, time step")


def test_displacement_and_rotation(fall, tmp_path):
    """Both are those that HISTORY records, in its units."""
    sim = blocks.Simulation(fall)
    assert not sim.displacement.any()
    before = sim.centroid.copy()
    sim.spin[1] = 0.5
    sim.step(100)
    assert np.array_equal(sim.displacement, sim.centroid - before) and sim.displacement[1, 1] < 0.0
    assert np.array_equal(sim.rotation, np.degrees(sim.angle)) and sim.rotation[1] > 0.0
    sim.cards("CREATE, 4, 1\n5, 5, 6, 6\n5, 6, 6, 5")
    assert not sim.displacement[-1].any()
    sim.step(10)
    assert sim.displacement[-1, 1] < 0.0 and len(sim.displacement) == len(before) + 1


def test_pieces_have_no_displacement(decks):
    sim = blocks.Simulation(decks / "beam/beam.deck", moves=False)
    count = len(sim)
    while len(sim) == count and sim.steps < 40_000:
        sim.step(200)
    assert len(sim) > count
    assert np.isnan(sim.displacement[count:]).all() and np.isfinite(sim.displacement[:count]).all()


def test_fos_is_that_of_a_run(tmp_path):
    """A square on a floor, under gravity inclined by 20 degrees, with friction 30 degrees."""
    deck = (
        "START, 9, 9\nBLOCK ON A PLANE\nXLIMITS, -9, 9\nYLIMITS, -9, 9\nBOXES, 4, 4, .02\nSTIFF, 1.E7, 1.E7\nFRACTION\n"
        "MATERIAL, 1, 1.E9, 4.E8, 1000\nRIGID\nEND\nCREATE, 4, 1, 1\n-5, -5, 5, 5\n-1, 0, 0, -1\n"
        "CREATE, 4, 1\n0, 0, 1, 1\n0, 1, 1, 0\nGRAVITY, 3.355218, -9.218385\nFRICTN, .57735026919\nLOCDAMP\nSOLVE\n"
    )
    known = np.tan(np.radians(30)) / np.tan(np.radians(20))
    sim = blocks.Simulation(deck, threads=2)
    place, steps = sim.centroid.copy(), sim.steps
    found = sim.fos(0.01)
    assert found.lower < known < found.upper <= found.lower + 0.01
    assert [trial.outcome for trial in found.trials[:2]] == ["stable", "failing"]
    assert found.trials[1].moved > found.trials[0].moved and found.trials[1].block == 1
    np.testing.assert_array_equal(sim.centroid, place)
    assert sim.steps == steps and not sim.warnings
    run = blocks.run(blocks.Deck(deck + "FOS, .01\nSTOP\n"), tmp_path / "a")
    told = run.summary["factor_of_safety"]
    assert (told["lower"], told["upper"]) == found[:2]
    assert [trial["steps"] for trial in told["trials"]] == [trial.steps for trial in found.trials]
    below = sim.fos(lower=2.0)
    assert below.lower is None and below.upper == 2.0 and "lower bound" in sim.warnings[-1]
    assert sim.factors_of_safety == [found, below]
    with pytest.raises(blocks.DeckError, match="no SOLVE or INSITU"):
        blocks.Simulation(deck.replace("SOLVE\n", "")).fos()


def test_selectors_find_what_the_cards_find(fall):
    """Numbers of selectors count from 0; those of cards count from 1."""
    sim = blocks.Simulation(fall)
    for b in range(3):
        x, y = sim.centroid[b]
        assert sim.block_at(x, y) == b
        assert sim.blocks_in(x - 1e-3, y - 1e-3, x + 1e-3, y + 1e-3).tolist() == [b]
        corner = sim.corners[sim.first_corner[b] + 1]
        next_corner = sim.corners[sim.first_corner[b] + 2]
        assert [b, 1] in sim.sides_on(*corner, *next_corner).tolist()
    assert sim.blocks_of_material(int(sim.material[0])).tolist() == np.flatnonzero(sim.material == sim.material[0]).tolist()
    assert sim.sides_of_joint(77).shape == (0, 2)
    assert sim.nearest_corner(1e6, 1e6)[0] in range(3)
    with pytest.raises(LookupError, match="no block contains the point"):
        sim.block_at(1e6, 1e6)
    with pytest.raises(LookupError, match="no material has the name 'none'"):
        sim.blocks_of_material("none")
    x, y = sim.centroid[2]
    sim.cards.fix(f"at({float(x)!r}, {float(y)!r})")
    assert not sim.is_free[2]
    assembly = blocks.check(fall)
    assert assembly.block_at(*assembly.centroid[1]) == 1
