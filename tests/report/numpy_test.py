#!/usr/bin/python3
"""The statistics of `blocks report` against NumPy and formulas: numpy_test.py PROGRAM.

The folder of a sweep has invented outcomes: several distributions, values far from 0, missing values
and failed runs. Student's distribution is integrated here, and binomial sums are exact. It is skipped
(77) without NumPy.
"""

import csv
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
from fractions import Fraction

try:
    import numpy as np
except ImportError:
    sys.exit(77)

LAYERS = 57
Z = statistics.NormalDist().inv_cdf(0.975)


def student_quantile(freedom):
    """Returns t with P(|T| <= t) = 0.95, by Simpson's rule and bisection."""
    scale = math.exp(math.lgamma((freedom + 1) / 2) - math.lgamma(freedom / 2)) / math.sqrt(freedom * math.pi)

    def inside(t):
        x = np.linspace(0, t, 20001)
        y = scale * (1 + x * x / freedom) ** (-(freedom + 1) / 2)
        return 2 * t / 20000 / 3 * (y[0] + y[-1] + 4 * y[1:-1:2].sum() + 2 * y[2:-1:2].sum())

    low, high = 0.0, 20.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if inside(middle) < 0.95 else (low, middle)
    return (low + high) / 2


def ranks(n, p):
    """Returns the ranks j and k of the interval of a quantile; 0 and n + 1 mean that there is none."""
    p = Fraction(p).limit_denominator(100)
    terms = [math.comb(n, i) * p**i * (1 - p) ** (n - i) for i in range(n + 1)]
    tail = Fraction(1, 40)
    below = max(j for j in range(n + 1) if sum(terms[:j]) <= tail)
    above = min(k for k in range(1, n + 2) if sum(terms[k:]) <= tail)
    return below, above


def wilson(k, n):
    centre, half = k + Z * Z / 2, Z * math.sqrt(k * (n - k) / n + Z * Z / 4)
    return (centre - half) / (n + Z * Z), (centre + half) / (n + Z * Z)


def near(found, expected, what):
    assert math.isclose(float(found), expected, rel_tol=1e-9, abs_tol=1e-9 * abs(expected) + 1e-15), (what, found, expected)


def make_sweep(folder):
    """Writes plan and outcomes; returns the values of the runs that are done, by group and name."""
    random = np.random.default_rng(7)
    runs, kept = [], {}
    head = {"blocks_sweep": 1, "kind": "check", "deck": "/somewhere/layer.deck", "deck_hash": "0" * 16, "version": "1",
            "numerics": "binary64", "name": "layer", "until": None, "audit": 0, "variants": [], "axes": ["seed", "ORIENT.max"]}
    for group in ("5", "10"):
        for seed in range(1, LAYERS + 1):
            runs.append({"id": len(runs) + 1, "seed": seed, "set": [f"ORIENT.max={group}"]})
    head["number"] = len(runs)
    folder.mkdir()
    (folder / "sweep.json").write_text(json.dumps(head)[:-1] + ', "runs": [\n' + ",\n".join(map(json.dumps, runs)) + "\n]}\n")
    for run in runs:
        group, place = run["set"][0].split("=")[1], folder / "runs" / "000" / f"{run['id']:06}"
        place.mkdir(parents=True)
        values = {"far": 1e9 + random.normal(), "skew": float(random.lognormal()), "whole": int(random.integers(0, 4)),
                  "sound": bool(random.random() < 0.9)}
        if run["id"] % 9 == 4:
            del values["skew"]
        failed = run["id"] % 13 == 5
        outcome = {"code": 3, "status": "deck error", "message": "no"} if failed else \
            {"code": 0, "status": "done", "message": "", "layers": {**values, "angle": {"min": values["far"] / 3}}}
        (place / "outcome.json").write_text(json.dumps(outcome))
        for name in ("far", "skew", "whole", "sound"):
            kept.setdefault((group, name), {})[run["seed"]] = math.nan if failed else values.get(name, math.nan)
        kept.setdefault((group, "angle:min"), {})[run["seed"]] = math.nan if failed else values["far"] / 3
    return kept


def check_quantity(row, by_seed):
    seeds = [s for s, v in by_seed.items() if not math.isnan(v)]
    x = np.array([by_seed[s] for s in seeds], float)
    n = len(x)
    assert int(row["n"]) == n, row
    near(row["mean"], x.mean(), "mean")
    if row["interval"] == "wilson":
        assert int(row["count"]) == x.sum()
        for end, expected in zip(("mean_low", "mean_high"), wilson(x.sum(), n)):
            near(row[end], expected, end)
        return
    half = student_quantile(n - 1) * x.std(ddof=1) / math.sqrt(n)
    near(row["sd"], x.std(ddof=1), "sd")
    near(float(row["mean_high"]) - float(row["mean_low"]), 2 * half, "half width") if x.mean() < 1e6 else None
    ordered = np.sort(x)
    for name, p in (("p5", 0.05), ("p50", 0.5), ("p95", 0.95)):
        near(row[name], np.quantile(x, p), name)
        j, k = ranks(n, p)
        assert row[name + "_low"] == "" if j == 0 else float(row[name + "_low"]) == ordered[j - 1], (name, row, j)
        assert row[name + "_high"] == "" if k > n else float(row[name + "_high"]) == ordered[k - 1], (name, row, k)
    assert float(row["min"]) == x.min() and int(row["min_seed"]) == seeds[int(x.argmin())]
    assert float(row["max"]) == x.max() and int(row["max_seed"]) == seeds[int(x.argmax())]
    enough = next(m for m in range(2, 10**6) if m > 1000 or student_quantile(m - 1) * x.std(ddof=1) / math.sqrt(m) <= 0.2 * abs(x.mean()))
    assert int(row["runs_needed"]) == enough, (row, enough)


def check_difference(row, first, second):
    d = np.array([second[s] - first[s] for s in first])
    d = d[np.isfinite(d)]
    assert int(row["n"]) == len(d)
    near(row["mean"], d.mean(), "difference")
    near(row["sd"], d.std(ddof=1), "sd of differences")
    near(float(row["mean_high"]) - float(row["mean_low"]), 2 * student_quantile(len(d) - 1) * d.std(ddof=1) / math.sqrt(len(d)), "interval")


def main(program):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        values = make_sweep(folder / "layers")
        subprocess.run([program, "report", "layers", "-q", "far,skew,whole,sound,angle:min", "--precision", "20%", "--quiet",
                        "-o", "table.csv,table.json", "--run-table", "runs.csv"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        with open(folder / "table.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        quantities = [r for r in rows if r["kind"] == "quantity"]
        assert len(quantities) == 10
        for row in quantities:
            check_quantity(row, values[row["ORIENT.max"], row["name"]])
        differences = [r for r in rows if r["kind"] == "difference"]
        assert {r["ORIENT.max"] for r in differences} == {"10"} and len(differences) == 5
        for row in differences:
            check_difference(row, values["5", row["name"]], values["10", row["name"]])
        failed = next(r for r in rows if r["kind"] == "outcome" and r["name"] == "failed")
        ended = [v for v in values["5", "far"].values()]
        count = sum(map(math.isnan, ended))
        assert int(failed["count"]) == count and int(failed["n"]) == LAYERS
        for end, expected in zip(("mean_low", "mean_high"), wilson(count, LAYERS)):
            near(failed[end], expected, end)
        with open(folder / "runs.csv", newline="") as file:
            runs = list(csv.DictReader(file))
        assert len(runs) == 2 * LAYERS
        for run in runs:  # every number can be read back exactly
            expected = values[run["ORIENT.max"], "far"][int(run["seed"])]
            assert (run["far"] == "" and math.isnan(expected)) or float(run["far"]) == expected
        table = json.loads((folder / "table.json").read_text())
        for group in table["groups"]:
            for one in group["quantities"]:
                row = next(r for r in quantities if r["name"] == one["name"] and r["ORIENT.max"] == group["parameters"]["ORIENT.max"])
                assert float(row["mean"]) == one.get("mean", one.get("share")) and float(row["mean_low"]) == one["interval"][0]


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
