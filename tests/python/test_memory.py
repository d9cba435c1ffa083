"""Nothing leaks, and no view outlives its memory. Also run under the address sanitizer."""

import gc
import resource

import numpy as np

import blocks
from conftest import PRELOADED


def resident():
    """Returns the memory in use, MiB."""
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * resource.getpagesize() / 2**20


def test_ten_thousand_simulations_leak_nothing(fall):
    def one(i):
        sim = blocks.Simulation(fall)
        views = [sim.corners, sim.velocity, sim.stress]
        sim.step(2, read=True)
        contacts = sim.contacts
        if i % 3 == 0:
            sim.cards("CREATE, 4, 1\n5, 5, 6, 6\n1, 2, 2, 1\n")
        if i % 2 == 0:
            del sim
        return sum(float(view.sum()) for view in views) + len(contacts)

    runs = 300 if PRELOADED else 10_000
    for i in range(100):
        one(i)
    gc.collect()
    before = resident()
    for i in range(runs):
        one(i)
    gc.collect()
    # One simulation takes about 50 kB.
    assert PRELOADED or resident() - before < 8


def test_views_of_every_column_outlive_everything(fall):
    names = [name for name in dir(blocks.Simulation)
             if isinstance(getattr(blocks.Simulation, name), property)]
    sim = blocks.Simulation(fall)
    sim.step(100)
    views = {name: value for name in names if isinstance(value := getattr(sim, name), np.ndarray)}
    assert {"corners", "velocity", "stress", "first_corner", "material"} <= set(views)
    copies = {name: view.copy() for name, view in views.items()}
    parts = {name: view[1:] for name, view in views.items()}
    sim.cards("CREATE, 4, 1\n5, 5, 6, 6\n1, 2, 2, 1\n")
    sim.step(100)
    del sim, views
    gc.collect()
    for name, part in parts.items():
        np.testing.assert_array_equal(part, copies[name][1:], err_msg=name)
