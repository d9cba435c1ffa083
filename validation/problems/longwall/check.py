"""Deflection of the roof before it caves, against a published continuum answer."""

import numpy as np
from suite.chart import Chart
from suite.roof_continuum import deflection_of_roof

LENGTH = "long"
PUBLISHED = {1: 0.57, 10: 0.23, 100: 0.19}  # ks, GPa/m: m
MIDDLE = 15  # the block of the lowest bed at x = 0


def deflection(run):
    """Returns the times after the roof is released and the deflection of its middle."""
    begin = np.searchsorted(run.times, 8.0)
    y = run.of("Centroid", MIDDLE)[:, 1]
    return run.times[begin:] - run.times[begin], y[begin] - y[begin:]


def caving(t, w):
    """Returns the deflection when the speed is three times that of the first second, interpolated
    between frames."""
    speed = np.gradient(w, t) - 3 * np.interp(1.0, t, w) / 1.0
    fast = np.nonzero((speed > 0) & (t > 1))[0]
    if not len(fast):
        return w.max()
    last, first = fast[0] - 1, fast[0]
    return np.interp(0.0, speed[[last, first]], w[[last, first]])


def mean_speed(t, w):
    """Returns the speed of the roof in the first two seconds without its oscillation, and the
    amplitude of that: a line and a sine of the best period are fitted."""
    first = t <= 2.05
    t, w = t[first], w[first]
    fits = []
    for period in np.arange(0.5, 2.5, 0.02):
        parts = np.stack([np.ones(len(t)), t, np.cos(2 * np.pi * t / period),
                          np.sin(2 * np.pi * t / period)], 1)
        found = np.linalg.lstsq(parts, w, rcond=None)[0]
        fits.append((np.square(parts @ found - w).sum(), found[1], np.hypot(*found[2:])))
    return min(fits)[1:]


def with_laws(deck, bonded):
    """Returns the deck with the published cohesion of bedding, which does not fall. bonded: joints
    within a bed never break, so beds are continuous."""
    beds = deck.split("LAYER,")
    deck = beds[0] + "".join("LAYER," + ",".join([bed.split(",")[0], f" {1 + count % 2}",
                                                   *bed.split(",")[2:]])
                              for count, bed in enumerate(beds[1:]))
    material = "MATERIAL, 1, 8.E9, 3.2E9, 2500\n"
    laws = "JOINT, 1, 0.364, 1.E5, , , 1.E5\nJPAIR, 1, 2, 1\n"
    if bonded:
        laws += "JOINT, 2, 0.364, 1.E9, 1.E9\nJPAIR, 1, 1, 2\nJPAIR, 2, 2, 2\nBOND\n"
    assert material in deck and "FRICTN, 0.364\n" in deck
    return deck.replace(material, material + material.replace("MATERIAL, 1", "MATERIAL, 2")).replace(
        "FRICTN, 0.364\n", "FRICTN, 0.364\n" + laws)


def laws(case, deck):
    """Adds rows for cohesion and for continuous beds."""
    of_ks = [(ks, deck.replace("5.E8", f"{5e8 * ks:g}").replace("MOTION, 9", "MOTION, 8"))
             for ks in PUBLISHED]
    for bonded, what in ((False, "bedding with cohesion"), (True, "and unbreakable beds")):
        runs = case.run_all([("longwall", (), with_laws(text, bonded)) for _, text in of_ks])
        for (ks, _), run in zip(of_ks, runs):
            case.compared(f"ks = {ks} GPa/m, {what}: deflection where caving begins", PUBLISHED[ks],
                          caving(*deflection(run)), "strength does not make the roof cave earlier", "m")


def check(case):
    deck = case.text("longwall.deck")
    runs = case.run_all([("longwall", (), deck.replace("5.E8", f"{5e8 * ks:g}"))
                         for ks in PUBLISHED])
    chart = Chart("Middle of the roof while its support is taken away (0 to 4 s)", "time, s",
                  "deflection, m")
    ours = []
    for (ks, published), run in zip(PUBLISHED.items(), runs):
        t, w = deflection(run)
        ours.append(caving(t, w))
        case.equal(f"ks = {ks} GPa/m: deflection where caving begins", published, ours[-1],
                   0.1, "two digits, read from a figure", "m")
        speed, amplitude = mean_speed(t, w)
        case.compared(f"ks = {ks} GPa/m: mean speed of the roof while half of its support is removed",
                      deflection_of_roof(ks * 1e9, 2.5e6), speed, "elastic finite elements without "
                      f"springs; the roof oscillates by {amplitude:.3f} m about this", "m/s")
        shown = w < 3.2
        chart.ours(t[shown], w[shown], f"ks = {ks} GPa/m", line=True)
    case.at_most("deflection for ks = 10 GPa/m over that for 1 GPa/m", 1.0, ours[1] / ours[0],
                 "stiffer bedding deflects less; continuum 0.40")
    case.at_most("deflection for ks = 100 GPa/m over that for 1 GPa/m", 1.0, ours[2] / ours[0],
                 "stiffer bedding deflects less; continuum 0.33")
    case.at_most("lowest bed sinks at most by", 3.2, max(deflection(run)[1].max() for run in runs),
                 "the seam is 3 m high, blocks deform by centimetres", "m")
    case.chart(chart)
    case.picture(runs[0], "-t", "8,11,13", "--columns", 3, "--mirror", 0, "--colour",
                 "displacement")
    laws(case, deck)
