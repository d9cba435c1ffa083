#!/usr/bin/python3
"""How far may the constants of the contact rule be changed until something fails?

sweep_constants.py [FRAMES] builds a copy of the program that takes the constants of
geometry/contact_constants.hpp from the environment, runs the study of contact detection for each
value, and writes CONSTANTS.csv here and docs/images/constants.svg. 10 frames take half an hour on
two cores. The chart is drawn again from the table with --draw.
"""

import csv
import itertools
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
TABLE, FIGURE = HERE / "CONSTANTS.csv", ROOT / "docs/images/constants.svg"

sys.path.insert(0, str(HERE.parent / "problems"))
from suite.chart import Chart  # noqa: E402

SLACK = 2**-18
CONSTANTS = {
    "slack": [1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 0.7 * SLACK, SLACK, 1.3 * SLACK, 1e-5, 1e-4, 1e-3,
              1e-2, 1e-1],
    "degrees": [1, 3, 5, 7, 10, 13, 15, 20, 30, 45, 60, 80],
    "successor": [0.0, 0.5, 0.665, 0.8, 0.9, 0.95, 0.98, 0.9999, 1.1],
    "deepest": [1.25, 1.5, 2, 3, 6],
    "joint": [0.5, 1, 2, 4, 8],
    "widest": [1 / 256, 1 / 64, 1 / 32, 1 / 16, 1 / 4],
    "reach": [0.0, 1 / 1024, 1 / 256, 1 / 128, 1 / 64, 1 / 16],
    "way": [1, 2, 4, 8, 100],
    "remaining": [1e-12, 0.005, 0.02, 0.1, 0.3],
    "overlap": [0.0, 1 / 16, 0.0875, 1 / 8, 0.1625, 1 / 4, 1 / 2],
    "renewal": [0.0, 1 / 32, 0.0875, 1 / 8, 0.1625, 1 / 2],
    "arm": [0.0, 7e-4, 1e-3, 1.3e-3, 1e-2],
    "factor": [1.125, 1.4, 2, 2.6, 16, 1e9],
    "sign": [0.0, 0.7 * 2**-28, 2**-28, 1.3 * 2**-28, 2**-25, 2**-21]}
# These constants are about joints, so `cut` is run for them alone, with 500 times as many frames.
OF_JOINTS = ("deepest", "joint", "widest", "reach", "way", "remaining", "overlap", "renewal", "arm",
             "factor", "sign")
MAY_FAIL = ("stake", "toe", "bricks", "triangles", "cut", "bonded")
DRAWN = ("stake", "toe")

FROM_ENVIRONMENT = """
#include <cmath>
#include <cstdlib>
namespace blocks::geometry {
inline double from_environment(const char* name, double otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtod(text, nullptr) : otherwise;
}
inline const double contact_slack = from_environment("SWEEP_SLACK", 0x1p-18);
inline const double facing_angle = from_environment("SWEEP_DEGREES", 10);
inline const double facing_sine = std::sin(facing_angle * 3.14159265358979323846 / 180);
inline const double facing_sine_squared = facing_sine * facing_sine;
inline const double facing_cosine_squared = 1.0 - facing_sine_squared;
inline const double deepest_share = from_environment("SWEEP_DEEPEST", 2.0);
inline const double joint_width = from_environment("SWEEP_JOINT", 2.0);
inline const double widest_joint = from_environment("SWEEP_WIDEST", 1.0 / 32.0);
inline const double third_reach = from_environment("SWEEP_REACH", 1.0 / 128.0);
inline const double longest_way = from_environment("SWEEP_WAY", 4.0);
inline const double remaining_share = from_environment("SWEEP_REMAINING", 0.02);
inline const double remaining_overlap = from_environment("SWEEP_OVERLAP", 0.125);
inline const double renewal_share = from_environment("SWEEP_RENEWAL", 0.125);
inline const double renewal_of_arm = from_environment("SWEEP_ARM", 1e-3);
inline const double renewal_factor = from_environment("SWEEP_FACTOR", 2.0);
inline const double renewal_of_sign = from_environment("SWEEP_SIGN", 0x1p-28);
inline const double successor_cosine = from_environment("SWEEP_SUCCESSOR", 0.95);
inline constexpr double face_cosine = 0.95;
}
"""
CHANGES = {
    "geometry/exact/contact_predicates_exact.cpp": [
        ("  const Number a2 = a * a;\n",
         "  return sign(a - Number(facing_sine_squared) * q) <= 0;\n"
         "  const Number a2 = a * a;\n")],
    "src/dynamics/kernels/face_questions_body.hpp": [
        ("constexpr double slack =", "const double slack ="),
        ("constexpr double facing_sine =", "const double facing_sine ="),
        ("constexpr double widest_joint =", "const double widest_joint =")],
    "src/dynamics/rules/kept_depths.hpp": [
        ("static constexpr double share =", "static inline const double share ="),
        ("static constexpr double sign_per_slack =", "static inline const double sign_per_slack =")],
    "src/dynamics/search/near_pairs.cpp": [
        ("constexpr double part_of_extents =", "const double part_of_extents =")],
    "src/dynamics/rules/block_parts.cpp": [("constexpr double slack =", "const double slack =")]}


def build(folder):
    """The program with constants from the environment."""
    left_out = shutil.ignore_patterns("build", ".git")
    shutil.copytree(ROOT, folder, dirs_exist_ok=True, ignore=left_out)
    constants = folder / "geometry/contact_constants.hpp"
    others = re.search(r"^struct Certainty \{.*?^\};\n", constants.read_text(), re.M | re.S)[0]
    constants.write_text(
        f"#pragma once\n{FROM_ENVIRONMENT}namespace blocks::geometry {{\n{others}}}\n")
    for name, changes in CHANGES.items():
        text = (folder / name).read_text()
        for old, new in changes:
            if text.count(old) != 1:
                raise SystemExit(f"{name}: {text.count(old)} times instead of once: {old}")
            text = text.replace(old, new)
        (folder / name).write_text(text)
    subprocess.run(["cmake", "-S", folder, "-B", folder / "build", "-G", "Ninja",
                    "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder / "build", "--target", "blocks"], check=True,
                   stdout=subprocess.DEVNULL)
    return folder / "build/src/blocks"


def study(program, scene, frames, **constants):
    """Rows of a scene, or of all, with these constants."""
    with tempfile.NamedTemporaryFile(suffix=".csv") as table:
        environment = os.environ | {f"SWEEP_{k.upper()}": repr(v) for k, v in constants.items()}
        subprocess.run([program, "study", "contacts", scene, "--variants", "default", "--frames",
                        str(frames), "-j", str(os.cpu_count()), "--csv", table.name], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       env=environment)
        with open(table.name, newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def sweep(frames):
    """The table of all values, written after each one."""
    columns = ["constant", "value", "scene", "frames", "hang_ups", "fall_throughs"]
    with tempfile.TemporaryDirectory() as folder, open(TABLE, "w", encoding="utf-8") as file:
        program = build(Path(folder))
        out = csv.writer(file, lineterminator="\n")
        out.writerow(columns)
        for constant, values in CONSTANTS.items():
            runs = [("all", frames)]
            if constant in OF_JOINTS:
                runs = [("cut", 500 * frames)] + [("toe", 20 * frames)] * (constant in ("renewal", "arm", "factor", "sign"))
            for value, (scene, count) in itertools.product(values, runs):
                for row in study(program, scene, count, **{constant: value}):
                    out.writerow([constant, value, row["scene"], count,
                                  row["hang_ups_count"] or 0, row["fall_throughs_count"] or 0])
                file.flush()
                print(constant, value, scene, flush=True)


def charts():
    """Share of the frames that fail against each constant."""
    with open(TABLE, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    groups = [("scenes that must pass", lambda scene: scene not in MAY_FAIL)] + [
        (scene, lambda name, scene=scene: name == scene) for scene in DRAWN]
    labels = {"slack": ("Slack: 2^-18 in the rule", "slack, part of an edge's length"),
              "degrees": ("Facing sides: ten degrees in the rule",
                          "largest angle between them, degrees")}
    for constant, values in CONSTANTS.items():
        if constant not in labels:
            continue  # The others change nothing that a chart would show.
        chart = Chart(*labels[constant], "frames that fail, per cent",
                      log="x" if constant == "slack" else "")
        for label, belongs in groups:
            share = []
            for value in values:
                mine = [r for r in rows if r["constant"] == constant and float(r["value"]) == value
                        and belongs(r["scene"])]
                failed = sum(int(r["hang_ups"]) + int(r["fall_throughs"]) for r in mine)
                share.append(100.0 * failed / max(1, sum(int(r["frames"]) for r in mine)))
            chart.ours(values, share, label, line=True)
        yield chart


def draw():
    """The charts one below the other."""
    pictures = [chart.svg() for chart in charts()]
    height = 400
    body = "".join(f'<g transform="translate(0 {i * height})">{picture}</g>'
                   for i, picture in enumerate(pictures))
    FIGURE.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 640 {len(pictures) * height}" '
                      f'width="640" height="{len(pictures) * height}">{body}</svg>\n', encoding="utf-8")


if __name__ == "__main__":
    arguments = sys.argv[1:]
    if arguments != ["--draw"]:
        sweep(int(arguments[0]) if arguments else 10)
    draw()
