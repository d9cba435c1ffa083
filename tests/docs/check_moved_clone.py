"""Checks that ./go builds again in a clone that was copied or moved with its build folder."""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE, CMAKE = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PRESETS = {
    "version": 3,
    "configurePresets": [{"name": "release", "generator": "Ninja",
                          "binaryDir": "${sourceDir}/build/release"}],
    "buildPresets": [{"name": "release", "configurePreset": "release"}],
}
PROJECT = """cmake_minimum_required(VERSION 3.21)
project(tiny NONE)
add_custom_target(blocks
  COMMAND ${CMAKE_COMMAND} -E echo ${PROJECT_SOURCE_DIR} > ${PROJECT_BINARY_DIR}/built)
"""


def make_clone(folder):
    folder.mkdir()
    shutil.copy(SOURCE / "go", folder)
    for name in ("packages.txt", "packages-test.txt", "packages-python.txt"):
        (folder / name).write_text("")
    (folder / "CMakeLists.txt").write_text(PROJECT)
    (folder / "CMakePresets.json").write_text(json.dumps(PRESETS))


def build(folder, told):
    path = f"{CMAKE.parent}{os.pathsep}{os.environ['PATH']}"
    run = subprocess.run([folder / "go", "build"], capture_output=True, text=True, check=False,
                         env={**os.environ, "PATH": path})
    assert run.returncode == 0, run.stderr
    assert ("was made in" in run.stderr) == told, run.stderr
    built = (folder / "build/release/built").read_text().strip()
    assert os.path.samefile(built, folder), f"{built} instead of {folder}"


with tempfile.TemporaryDirectory() as root:
    first, link = pathlib.Path(root, "a clone"), pathlib.Path(root, "link")
    make_clone(first)
    build(first, told=False)
    build(first, told=False)
    link.symlink_to(first)
    build(link, told=False)  # another name of the same folder
    copy = pathlib.Path(root, "copy")
    shutil.copytree(first, copy)
    build(copy, told=True)
    build(first, told=False)
    moved = first.rename(pathlib.Path(root, "moved"))
    build(moved, told=True)
