#!/usr/bin/python3
"""Is a new state of a contact one line of the list of states and its use in a law?

dummy_state.py adds the state `dummy` to BLOCKS_LAW_STATES (src/model/law_state.hpp) in a copy
of the sources, lets the law of JOINT count its steps in it, and builds the program, and the Python
package if CMake finds what it needs. It runs a deck and looks for the state in the checkpoint, the
results, the PVD and CSV files and the tables of Python. It exits with 1 if the state is missing
from one of them, or if they disagree. It takes as long as a build of the program.
"""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parents[2]
LAST_STATE = "  /* L, the part of the faces"
CHANGES = {
    "src/model/law_state.hpp": (
        LAST_STATE, '  STATE(dummy, double, "DummyState", none, not_negative) \\\n' + LAST_STATE),
    "src/dynamics/kernels/coulomb_law.hpp": (
        "  state.offset = state.offset + rise;\n",
        "  state.offset = state.offset + rise;\n  state.dummy = state.dummy + 1.0;\n")}
DECK = ROOT / "decks/direct_shear/direct_shear.deck"
FROM_PYTHON = """
import sys, blocks
with blocks.read(sys.argv[1]) as results:
    print(*results[-1].contacts["dummy_state"].tolist())
simulation = blocks.Simulation(sys.argv[2], moves=False)
simulation.run_until(float(sys.argv[3]))
print(*simulation.contacts["dummy_state"].tolist())
"""


def call(*command, **options):
    """Runs a command and returns its standard output."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))} exits with {done.returncode}\n{done.stdout}")
    return done.stdout


def build(folder):
    """Builds the changed copy. Returns whether it has the Python package."""
    left_out = shutil.ignore_patterns("build", ".git")
    shutil.copytree(ROOT, folder, dirs_exist_ok=True, ignore=left_out)
    for name, (old, new) in CHANGES.items():
        text = (folder / name).read_text()
        if text.count(old) != 1:
            sys.exit(f"{name}: {text.count(old)} times instead of once: {old}")
        (folder / name).write_text(text.replace(old, new))
    call("cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DBUILD_TESTING=OFF")
    targets = call("cmake", "--build", folder / "build", "--target", "help")
    has_package = "blocks_python:" in targets
    call("cmake", "--build", folder / "build", "-j", str(os.cpu_count()), "--target", "blocks",
         *["blocks_python"] * has_package)
    return has_package


def listed(text):
    return [float(word) for word in text.split()]


def places(folder, has_package, time="0.04"):
    """Yields each place of the state, and its values for the contacts of the last frame."""
    program = folder / "build/src/blocks"
    call(program, "run", "-q", "--until", time, "-o", folder / "a", DECK)
    for ending in ("csv", "pvd"):
        call(program, "export", folder / "a.vtkhdf", "-o", folder / f"a.{ending}")

    with h5py.File(folder / "a.ckpt.h5") as file:
        yield "checkpoint", list(file["joint_states/dummy"])
    with h5py.File(folder / "a.vtkhdf") as file:
        contacts = file["BLOCKS/contacts"]
        yield "results", list(contacts["DummyState"][contacts["Offsets"][-1]:])
    with open(folder / "a_contacts.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    yield "CSV", [float(row["dummy_state"]) for row in rows if row["time"] == rows[-1]["time"]]
    last = max((folder / "a_vtu").glob("contacts_*.vtu"))
    yield "names of PVD", [float(b'Name="DummyState"' in last.read_bytes())]
    if has_package:
        environment = os.environ | {"PYTHONPATH": str(folder / "build/python")}
        read, driven = call("/usr/bin/python3", "-c", FROM_PYTHON, folder / "a.vtkhdf", DECK, time,
                            env=environment).splitlines()
        yield "Python, results", listed(read)
        yield "Python, simulation", listed(driven)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = dict(places(folder, build(folder)))
    for place, values in found.items():
        print(f"{place}: {values}")
    names = found.pop("names of PVD")
    expected = [value for value in found["checkpoint"] if value > 0]
    agree = all([value for value in values if value > 0] == expected for values in found.values())
    if not expected or not agree or names != [1.0]:
        sys.exit("the dummy state is not everywhere")


if __name__ == "__main__":
    main()
