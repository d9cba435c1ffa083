"""Factors of safety by FOS, against limit equilibrium."""

from itertools import combinations
from math import atan, cos, radians, sin, tan
from types import SimpleNamespace

import numpy as np
from suite.chart import Chart
from suite.deck import turned
from suite.frames import outlines
from suite.numbers import bisect
from suite.spring_statics import section
from suite.toppling import equilibrium

LENGTH = "long"
FRAMES = ((0, (0.0, 0.0)), (17.2, (100.0, 200.0)), (45, (-50.0, 7.0)))
WIDTH = 0.01
KINDS = {"rigid": lambda text: text, "deformable": lambda text: text.replace("\nRIGID\n", "\n")}
MASSES = {"": lambda text: text,
          ", MSCALE": lambda text: text.replace("\nLOCDAMP", "\nMSCALE\nLOCDAMP")}
ARCH_FRICTION = 2.0


def plane():
    return tan(radians(30)) / tan(radians(20))


def slide():
    """A wedge of the height H between a face and a plane."""
    height, face, psi, unit, cohesion, phi = 60, radians(50), radians(35), 26, 100, radians(35)
    weight = unit * height ** 2 / 2 * (1 / tan(psi) - 1 / tan(face))
    return (cohesion * height / sin(psi) + weight * cos(psi) * tan(phi)) / (weight * sin(psi))


def wedges():
    """Two wedges of equal weight. All three sides are at their limit."""
    first, second, phi = radians(50), radians(10), radians(35)

    def stands(factor):
        p = atan(tan(phi) / factor)
        return sin(first - p) * cos(second - 2 * p) < sin(p - second) * cos(first - 2 * p)
    return bisect(stands, 1, 2, 1e-9)


def toppling():
    """The slope of Goodman and Bray with a friction angle of 45 degrees."""
    return 1 / tan(radians(bisect(lambda phi: equilibrium(phi)[0][1] > 0, 35, 42, 1e-6)))


class Arch:
    """Equilibrium of the voussoirs of a deck. The unknowns are the thrust (H, V) and its moment M
    about the origin at the left springing."""

    def __init__(self, text):
        blocks = outlines(text)[2:]
        sections = [section(block) for block in blocks]
        weights = np.array([area for area, _ in sections])
        moments = np.array([area * centre[0] for area, centre in sections])
        self.weight, self.joints = weights.sum(), []
        for j, angle in enumerate(np.linspace(np.pi, 0, len(blocks) + 1)):
            axis = np.array([cos(angle), sin(angle)])
            radii = [sorted(np.linalg.norm(p) for p in block
                            if np.linalg.norm(p - axis * np.linalg.norm(p)) < 1e-6)
                     for block in blocks[max(j - 1, 0):j + 1]]
            inner, outer = max(r[0] for r in radii), min(r[1] for r in radii)
            left = np.array([0, weights[:j].sum(), moments[:j].sum()])
            self.joints.append((inner * axis, outer * axis, left))

    def stands(self, friction):
        """Whether a state exists in which no joint has tension or more shear than its friction. The
        linear inequalities in (H, V, M) are tested at all corners of their polyhedron."""
        rows = []
        for inner, outer, left in self.joints:
            for (x, y), sign in ((outer, 1), (inner, -1)):
                rows.append(sign * np.array([y, -x, 1, left @ (y, -x, 1)]))
            along = outer / np.linalg.norm(outer)
            for sign in (1, -1):
                row = friction * np.array([along[1], -along[0]]) - sign * along
                rows.append(np.array([*row, 0, left[:2] @ row]))
        rows = np.array(rows)
        three = rows[np.array(list(combinations(range(len(rows)), 3)))]
        three = three[np.abs(np.linalg.det(three[:, :, :3])) > 1e-9]
        corners = np.linalg.solve(three[:, :, :3], three[:, :, 3:])[:, :, 0]
        return (corners @ rows[:, :3].T - rows[:, 3]).min(axis=1).max() >= -1e-9 * self.weight

    def factor(self):
        return ARCH_FRICTION / bisect(lambda mu: not self.stands(mu), 0.2, 1, 1e-5)


def reduced(text, factor):
    """Returns the cards before FOS, and then those that divide the strength by a factor."""
    before = text[:text.index("\nFOS")].splitlines()
    last = {}
    for line in before:
        words = [word.strip() for word in line.split(",")]
        if words[0] in ("FRICTN", "JOINT"):
            first, end = (1, 2) if words[0] == "FRICTN" else (2, 8)
            words[first:end] = [f"{float(word) / factor:.15g}" if word else ""
                                for word in words[first:end]]
            last[words[0]] = ", ".join(words)
    return "\n".join([*before, *last.values()])


def goes_on(case, text, trial, dt):
    """Returns how a trial goes on for many more steps, and how far blocks have moved then."""
    steps = max(min(10 * trial["steps"], trial["steps"] + 200000), 2000)
    run = case.run("by_hand", text=f"{reduced(text, trial['factor'])}\n"
                   f"HISTORY, {steps * dt / 200:.15g}, speed:max, displacement:max\n"
                   f"CYCLE, {steps}\nSTOP\n")
    _, speed = run.history("speed:max")
    _, moved = run.history("displacement:max")
    return "fails" if speed[100:].mean() > 0.1 * speed[:20].mean() else "stands", moved[-1] - moved[0]


def outside(bracket, known):
    """Returns how far the known factor is outside a bracket, of the factor; infinite without one."""
    low, high = bracket
    if low is None or high is None:
        return float("inf")
    return max(low - known, known - high, 0) / known


def widest_gap(found):
    """The largest part of a bracket between neighbouring factors. Some may be undecided."""
    if found["lower"] is None or found["upper"] is None:
        return np.inf
    tried = sorted(trial["factor"] for trial in found["trials"]
                   if found["lower"] <= trial["factor"] <= found["upper"])
    return max(b - a for a, b in zip(tried, tried[1:]))


def compare(case, what, text, known):
    """Adds the rows of one problem, and returns the trials of the first run."""
    decks = [(kind, masses, *frame) for kind in KINDS for masses in MASSES for frame in FRAMES]
    runs = case.run_all([("fos", (), turned(MASSES[masses](KINDS[kind](text)), *frame))
                         for kind, masses, *frame in decks])
    found = [run.summary["factor_of_safety"] for run in runs]
    for kind in KINDS:
        for masses in MASSES:
            mine = [one for deck, one in zip(decks, found) if deck[:2] == (kind, masses)]
            brackets = [(one["lower"], one["upper"]) for one in mine]
            case.at_most(f"{what}, {kind}{masses}: distance of {known:.5g} from the bracket, worst "
                         "of three frames", 0.01, max(outside(one, known) for one in brackets),
                         "blocks settle on springs, and slip a little before the limit")
            case.at_most(f"{what}, {kind}{masses}: gap between factors tried in the bracket, worst "
                         "of three frames", WIDTH, max(widest_gap(one) for one in mine),
                         "of the card")
            case.measured(f"{what}, {kind}{masses}: brackets", "; ".join(
                f"{low} to {high}" for low, high in brackets), "three frames")
    for end, outcome in (("lower", "stands"), ("upper", "fails")):
        trial = next(one for one in found[0]["trials"] if one["factor"] == found[0][end])
        dt = runs[0].summary["solves"][-1]["time_step"]
        ours, moved = goes_on(case, text, trial, dt)
        case.same(f"{what}: strength / {trial['factor']:g} by hand, for ten times as many steps",
                  outcome, ours, f"blocks moved by {moved:.2g} m; the trial had {trial['steps']} steps")
    return runs[0]


def check(case):
    columns = case.text("validation/problems/goodman_bray/goodman_bray.deck")
    columns = columns[:columns.index("FRICTN")].replace("FRACTION, 0.03", "FRACTION") + \
        "FRICTN, 2\nLOCDAMP, .8\nSOLVE\nFRICTN, 1\nSOLVE\nFOS\nSTOP\n"
    problems = (("block on a plane", case.text("plane.deck"), plane()),
                ("plane slide", case.text("slide.deck"), slide()),
                ("two wedges", case.text("wedges.deck"), wedges()),
                ("toppling columns", columns, toppling()),
                ("arch", case.text("arch.deck"), Arch(case.text("arch.deck")).factor()))
    chart = Chart("Trials, rigid blocks, as drawn", "trial", "factor, of the known one")
    for what, text, known in problems:
        run = compare(case, what, text, known)
        factors = [trial["factor"] / known for trial in run.summary["factor_of_safety"]["trials"]]
        chart.ours(range(1, len(factors) + 1), factors, what)
        if what == "two wedges":
            failing = run.path.with_name(run.path.stem + ".failing.vtkhdf")
    chart.expected([1, 18], [1, 1], "known")
    case.chart(chart)
    case.picture(SimpleNamespace(path=failing), "--colour", "displacement", "--arrows",
                 "displacement", "--zoom", "-18,20,-8,20")
