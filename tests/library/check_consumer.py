#!/usr/bin/python3
"""An installed BLOCKS is found, linked and correct: check_consumer.py CMAKE BUILD SOURCE
GENERATOR COMPILER FLAGS."""

import re
import subprocess
import sys
import tempfile
from pathlib import Path


def run(*words):
    done = subprocess.run(list(map(str, words)), text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        sys.exit(f"exit code {done.returncode}: {' '.join(map(str, words))}\n{done.stdout}")
    return done.stdout


def check_layer(printed):
    """At rest the floor carries the weight, and every contact obeys the Coulomb limit."""
    carried, weight = map(float, re.search(r"carries (\d+) N of (\d+) N", printed).groups())
    assert weight == 245250 and abs(carried - weight) < 1e-3 * weight, printed
    rows = [line.split() for line in printed.splitlines() if re.match(r" *\d+ ", line)]
    assert len(rows) >= 22, printed  # Each of 11 blocks on the floor has two contacts.
    for *_, normal, shear in rows:
        assert float(normal) >= 0 and abs(float(shear)) <= 0.6 * float(normal) + 0.1, printed


def check_servo(printed, results):
    """The force reaches its required value, and the floor carries it and the weight."""
    plate, floor = (tuple(map(float, re.findall(r"([\d.]+) N", line))) for line in printed.splitlines()[-2:])
    assert plate[1] == 5e5 and abs(plate[0] - plate[1]) < 1e-3 * plate[1], printed
    # There are 18 m2 of bricks with 2500 kg/m3 under the plate.
    assert abs(floor[1] - 5e5 - 9.81 * 2500 * 18) < 0.1 and abs(floor[0] - floor[1]) < 1e-3 * floor[1], printed
    assert results.stat().st_size > 0


def write_page_example(page, folder):
    """Extracts the project and the program of the page."""
    text = page.read_text()
    folder.mkdir()
    for kind, name in (("cmake", "CMakeLists.txt"), ("cpp", "mine.cpp")):
        (folder / name).write_text(re.search(rf"^```{kind}\n(.*?)^```$", text, re.M | re.S)[1])
    return folder


def main():
    cmake, build, source, generator, compiler, flags = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        prefix, out, mine = (Path(folder, name) for name in ("installed", "build", "mine"))
        run(cmake, "--install", build, "--prefix", prefix, "--component", "library")

        def make(project, binaries):
            run(cmake, "-S", project, "-B", binaries, "-G", generator, f"-DCMAKE_PREFIX_PATH={prefix}",
                f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}")
            run(cmake, "--build", binaries)

        make(write_page_example(Path(source, "../../docs/library.md"), mine), mine / "build")
        assert re.search(r"^2 on 1: \d+", run(mine / "build/mine"), re.M)
        make(source, out)
        check_layer(run(out / "layer"))
        results = Path(folder, "servo.vtkhdf")
        check_servo(run(out / "servo", "5e5", results), results)


main()
