"""The trough of decks/subsidence_solve against that of a run in time with the same fall."""

import numpy as np
from suite import trough
from suite.chart import Chart
from suite.deck import with_lines

LENGTH = "long"
IN_TIME = "decks/subsidence/subsidence.deck"
BY_SOLVE = "decks/subsidence_solve/subsidence_solve.deck"
SEEDS = (1, 2, 3, 4, 5)
FALL = "DAMPING, 0.2\nMOTION, 1.25\n"  # the cards of the fall in the deck with SOLVE


def measure(run):
    """Returns x and the subsidence minus that of the far field."""
    x, s = trough.surface(run, 49.9)
    return x, s - np.median(s[x > 70])


def difference(ours, reference):
    """Returns the largest difference of two troughs, of the depth of the second."""
    return np.abs(ours[1] - reference[1]).max() / reference[1].max()


def check(case):
    shipped, by_solve = (with_lines(case.text(deck), PLOTS="PLOTS, 20")
                         for deck in (IN_TIME, BY_SOLVE))
    in_time = with_lines(shipped, DAMPING="DAMPING, 0.2", FRACTION="FRACTION, 0.06")
    fall = by_solve.replace(FALL, "")
    assert fall != by_solve
    decks = {
        "in time": in_time, "by SOLVE": by_solve,
        "in time, FRACTION 0.05": with_lines(in_time, FRACTION="FRACTION, 0.05"),
        "decks/subsidence, DAMPING 0.5": shipped,
        "LOCDAMP 0.8 from the start": fall,
        "LOCDAMP 0.3 from the start": with_lines(fall, LOCDAMP="LOCDAMP, 0.3"),
        "LOCDAMP 0.1 from the start": with_lines(fall, LOCDAMP="LOCDAMP, 0.1"),
        "KINDAMP after the fall": with_lines(by_solve, LOCDAMP="KINDAMP"),
        **{f"gravity grows in {ramp:g} s": with_lines(
            by_solve, GRAVITY=f"GRAVITY, 0, -9.81, {ramp:g}", MOTION=f"MOTION, {1.25 + ramp}")
           for ramp in (0.5, 1, 2)}}
    runs = dict(zip(decks, case.run_all([(f"subsidence_{k}", (), deck)
                                         for k, deck in enumerate(decks.values())])))
    steps = {name: run.summary["steps"] for name, run in runs.items()}
    troughs = {name: measure(run) for name, run in runs.items()}
    reference, ours = troughs["in time"], troughs["by SOLVE"]
    case.at_most("steps by SOLVE, of those of decks/subsidence", 0.2,
                 steps["by SOLVE"] / steps["decks/subsidence, DAMPING 0.5"], "a fifth")
    case.at_most("largest difference of the trough, of its depth", 0.01,
                 difference(ours, reference), "1 %")
    case.equal("depth of the trough", reference[1].max(), ours[1].max(), 0.01, "1 %", "m")
    case.equal("area of the trough", np.trapz(reference[1], reference[0]),
               np.trapz(ours[1], ours[0]), 0.01, "1 %", "m2")
    for name in list(decks)[2:]:
        x, s = troughs[name]
        case.measured(f"{name}: steps; depth; largest difference, of the depth; half width at half "
                      "the depth", f"{steps[name]}; {s.max():.3f} m; "
                      f"{100 * difference(troughs[name], reference):.1f} %; "
                      f"{trough.reach(x, s, s.max() / 2):.1f} m",
                      f"in time: {steps['in time']}; {reference[1].max():.3f} m; "
                      f"{trough.reach(*reference, reference[1].max() / 2):.1f} m")
    others = case.run_all([(f"seed_{seed}_{k}", ("--seed", seed), deck) for seed in SEEDS
                           for k, deck in enumerate((in_time, by_solve))])
    for seed, slow, fast in zip(SEEDS, others[::2], others[1::2]):
        case.measured(f"layering {seed}: steps in time and by SOLVE; depths; largest difference, of "
                      "the depth", f"{slow.summary['steps']}, {fast.summary['steps']}; "
                      f"{measure(slow)[1].max():.3f} m, {measure(fast)[1].max():.3f} m; "
                      f"{100 * difference(measure(fast), measure(slow)):.1f} %", "--seed")
    chart = Chart("Subsidence trough, in time and by SOLVE", "x, m", "subsidence, m")
    near = reference[0] < 40
    for name in ("by SOLVE", "gravity grows in 2 s", "LOCDAMP 0.1 from the start",
                 "LOCDAMP 0.8 from the start"):
        chart.ours(troughs[name][0][near], -troughs[name][1][near], name)
    chart.expected(reference[0][near], -reference[1][near], "in time")
    case.chart(chart)
