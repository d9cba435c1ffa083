"""Waves at quiet sides: reflection by frequency, a free top, the reaction that stays, energy."""

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines
from suite.numbers import bisect

LENGTH = "long"
N, RHO, C11, G = 40, 2500.0, 3e10, 1e10
FRAMES = ((0, (0, 0)), (30, (0, 0)), (215, (700, -300)))
SPEED = {"P": np.sqrt(C11 / RHO), "S": np.sqrt(G / RHO)}
# A deformable square has a mass M (1/2 - b) at either side and a coupling M b between both.
COUPLING = {"P": 0.0, "S": 1 / 12}
STIFFER = 2000  # stiffness of the contacts between deformable blocks, relative to the blocks


def gauss(width, middle, height=1.0):
    """Returns FUNCTION of a pulse, and the pulse as a function of time."""
    t = np.linspace(0, 2 * middle, 81)
    p = height * np.exp(-((t - middle) / width) ** 2)
    p[0] = p[-1] = 0
    lines = "\n".join(f"{a:.15g}, {b:.15g}" for a, b in zip(t, p))
    return f"FUNCTION, {len(t)}\n{lines}"


def chain(case, wave, rigid, width=3.0):
    """Returns the deck of the chain for a wave, P or S."""
    c = SPEED[wave]
    kn, ks = (C11, G) if rigid else (STIFFER * C11, STIFFER * G)
    wall = STIFFER * C11
    # The walls hold the chain against motion at right angles to that of the wave.
    normal, shear = (10., wall) if wave == "S" else (wall, 10.)
    text = case.text("chain.deck")
    text = text.replace("FUNCTION, 2\n0, 0\n1, 0", gauss(width / c, 4 * width / c))
    text = with_lines(text, **{
        "JOINT, 1": f"JOINT, 1, 0, 1.E12, 1.E12, 0, 0, 0, , , {kn:.15g}, {ks:.15g}",
        "JOINT, 2": f"JOINT, 2, 0, 1.E12, 1.E12, 0, 0, 0, , , {normal:.15g}, {shear:.15g}",
        "PLOTS": f"PLOTS, {0.5 / c:.15g}", "MOTION": f"MOTION, {170 / c:.15g}",
        "PRESSBC": "PRESSBC, 1, 1, 2., 2., 0" if wave == "P" else "FORCE, 1, 0, 2."})
    if rigid:
        text = text.replace("\nEND\n", "\nRIGID\nEND\n")
        speeds = f"{SPEED['P']:.15g}, {SPEED['S']:.15g}"
        text = with_lines(text, FRACTION="FRACTION, 0.05",
                          **{"QUIET, 1, 1": f"QUIET, 1, 1, {speeds}",
                             "QUIET, 40, 3": f"QUIET, 40, 3, {speeds}"})
    return text


def spectrum(results, w, along):
    """Returns the spectra of the blocks' velocities in a direction, shape (w, blocks)."""
    t = results.times
    v = results.all("Velocity")[:, :N, :2] @ along
    return np.exp(1j * np.outer(w, t)) * np.gradient(t) @ v


def wave_in_chain(wave, rigid, w, dt):
    """Returns the phase q from block to block and the reflection R of the chain, with its contacts
    and time steps. Contacts of stiffness kc join the sides of blocks."""
    mass, modulus = RHO, C11 if wave == "P" else G
    # u = exp(-i w t); the differences of a step replace w^2 and -i w.
    w2 = (2 / dt * np.sin(w * dt / 2)) ** 2
    drag = RHO * SPEED[wave] * (1 - np.exp(1j * w * dt)) / dt
    if rigid:
        q = np.arccos(1 - mass * w2 / modulus / 2)
        end = -mass * w2 + drag + modulus
        forth, back = (end - modulus * np.exp(s * 1j * q) for s in (-1, 1))
        return q, -forth / back
    b = COUPLING[wave]
    k, kc = modulus + b * mass * w2, STIFFER * modulus
    side = modulus - (0.5 - b) * mass * w2
    q = np.arccos(((side + kc) ** 2 - k ** 2 - kc ** 2) / (2 * k * kc))
    forth, back = ((side + drag) * (k + kc * np.exp(s * 1j * q)) / (side + kc) - k for s in (1, -1))
    return q, -forth / back


def at_phase(wave, rigid, q, dt):
    """Returns the frequency at which the chain has a phase q from block to block."""
    c = SPEED[wave]
    return bisect(lambda w: wave_in_chain(wave, rigid, w, dt)[0] < q, 0.5 * q * c, 1.2 * q * c,
                  1e-12 * c)


def reflection(results, wave, w, q, degrees):
    """|R| by frequency: the spectra of blocks 7 to 34 are the sum of two waves."""
    angle = np.radians(degrees + (90 if wave == "S" else 0))
    v = spectrum(results, w, np.array([np.cos(angle), np.sin(angle)]))
    n = np.arange(6, 34)
    found = []
    for k, phase in enumerate(q):
        both = np.array([np.exp(1j * phase * n), np.exp(-1j * phase * n)]).T
        forth, back = np.linalg.lstsq(both, v[k, n], rcond=None)[0]
        found.append(abs(back / forth))
    return np.array(found)


def in_limit(wave, rigid, q):
    """|R| of contacts without compliance and of short time steps."""
    if rigid:
        return np.tan(q / 4)
    b = COUPLING[wave]
    w2 = (1 - np.cos(q)) / (0.5 - b * (1 - np.cos(q)))
    side = np.sin(q) * (1 + b * w2)
    return abs(side - np.sqrt(w2)) / (side + np.sqrt(w2))


def check_reflection(case):
    """Compares the reflection of P and S waves with that of the chain."""
    lengths = np.array([10, 20, 40])
    charts = []
    for rigid in (False, True):
        kind = "rigid" if rigid else "deformable"
        chart = Chart(f"Reflection from a quiet end, {kind} blocks", "blocks per wavelength", "|R|",
                      log="xy")
        for wave in "PS":
            text = chain(case, wave, rigid)
            runs = case.run_all([("chain.deck", (), turned(text, *frame)) for frame in FRAMES])
            for (degrees, _), run in zip(FRAMES, runs):
                q = 2 * np.pi / lengths
                w = np.array([at_phase(wave, rigid, one, run.dt) for one in q])
                exact = abs(wave_in_chain(wave, rigid, w, run.dt)[1])
                ours = reflection(run, wave, w, q, degrees)
                stiff = in_limit(wave, rigid, q)
                name = f"{kind}, {wave}, {degrees} degrees"
                for n, a, b, c in zip(lengths, exact, ours, stiff):
                    case.equal(f"{name}, {n} blocks a wavelength: |R|, with contacts and steps", a, b,
                               5e-4, "short waves are left in the chain", absolute=True)
                    if degrees == 0:
                        case.equal(f"{name}, {n} blocks a wavelength: |R|, formula", c, b, 5e-4,
                                   "contacts are 2000 times as stiff as a block, and dashpots lag "
                                   "by half a time step", absolute=True)
                case.at_most(f"{name}: part of the work of the pulse that has not left", 1e-3,
                             abs(1 - run.summary["energy"]["quiet"] / run.summary["energy"]["loads"]),
                             "short waves are left in the chain")
                if degrees == 0:
                    many = np.geomspace(8, 60, 40)
                    few = 2 * np.pi / np.geomspace(8, 50, 12)
                    at = np.array([at_phase(wave, rigid, one, run.dt) for one in few])
                    chart.expected(many, in_limit(wave, rigid, 2 * np.pi / many), f"{wave}, exact",
                                   "#555555" if wave == "P" else "#bbbbbb")
                    chart.ours(2 * np.pi / few, reflection(run, wave, at, few, 0), f"{wave}, ours")
        charts.append(chart)
    for chart in charts:
        case.chart(chart)


def check_free_top(case):
    """A stress of 2 rho c v at the quiet end gives 2 v at the free end."""
    decks = []
    for rigid in (False, True):
        for wave in "PS":
            text = "".join(line for line in chain(case, wave, rigid, 10.0).splitlines(True)
                           if not line.startswith("QUIET, 40"))
            text = with_lines(text, FRACTION="FRACTION, 0.1",
                              MOTION=f"MOTION, {110 / SPEED[wave]:.15g}")
            decks.append(("chain.deck", (), turned(text, 30)))
    runs = iter(case.run_all(decks))
    for rigid in (False, True):
        for wave in "PS":
            run = next(runs)
            v = np.linalg.norm(run.of("Velocity", N)[:, :2], axis=1).max()
            case.equal(f"{'rigid' if rigid else 'deformable'}, {wave}: peak velocity at the free top / v",
                       2, v * RHO * SPEED[wave], 0.01,
                       "the centroid is half a block below the top, in a pulse of 20 blocks")


def check_rest(case):
    """A column stays at rest when its fixed base becomes free and quiet."""
    for rigid in (False, True):
        text = case.text("rest.deck")
        if rigid:
            text = text.replace("\nEND\n", "\nRIGID\nEND\n")
        runs = case.run_all([("rest.deck", (), turned(text, *frame)) for frame in FRAMES])
        for (degrees, _), run in zip(FRAMES, runs):
            speed = np.linalg.norm(run.all("Velocity")[:, :, :2], axis=2).max(axis=1)
            kind = "rigid" if rigid else "deformable"
            case.same(f"{kind}, {degrees} degrees: the base is free at the end", "True",
                      str(1 in run.free()), "QUIET frees it")
            case.at_most(f"{kind}, {degrees} degrees: largest speed after QUIET on the base",
                         1e-9, speed[run.times > 30.01].max(),
                         f"before QUIET it was {speed[run.times < 30][-1]:.1e} m/s", "m/s")


def check(case):
    check_reflection(case)
    check_free_top(case)
    check_rest(case)
