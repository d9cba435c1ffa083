"""A pulse from the quiet base of a layered column: the spectrum at the top, by frequency."""

import numpy as np
from suite.chart import Chart
from suite.deck import turned, with_lines

LENGTH = "long"
BLOCKS = (8, 12, 16)  # from the base up, each 1 m thick
RHO = (2400.0, 2200.0, 2000.0)
SHEAR = (5.4e9, 1.782e9, 5e8)
WIDTH, MIDDLE = 0.004, 0.016  # of the pulse exp(-((t - middle) / width)^2), s
STIFF = {"P": 3.24e12, "S": 1.08e12}  # of the joints between deformable blocks


def moduli(wave):
    """C11 or G of the layers; C11 = 3 G at Poisson's ratio 1/4."""
    return [(3 if wave == "P" else 1) * g for g in SHEAR]


def speeds(wave):
    return [np.sqrt(m / r) for m, r in zip(moduli(wave), RHO)]


def layers(wave, w):
    """Motion of the top over that of an outcrop of the base (README.md)."""
    up = down = np.full(len(w), 0.5 + 0j)
    c = speeds(wave)
    for k in (2, 1):
        turn = np.exp(1j * w * BLOCKS[k] / c[k])
        ratio = RHO[k] * c[k] / (RHO[k - 1] * c[k - 1])
        up, down = (0.5 * (up * (1 + s * ratio) * turn + down * (1 - s * ratio) / turn)
                    for s in (1, -1))
    return 0.5 / np.abs(up)


def chain(wave, rigid, w, dt):
    """The same of the blocks, with their contacts and time steps: solves their equations of motion.
    Rigid blocks are masses, deformable ones have two (quiet_sides/README.md)."""
    modulus = np.repeat(moduli(wave), BLOCKS)
    mass = np.repeat(RHO, BLOCKS)
    count = len(mass)
    w2 = (2 / dt * np.sin(w * dt / 2)) ** 2
    drag = RHO[0] * speeds(wave)[0] * (1 - np.exp(1j * w * dt)) / dt
    if rigid:
        inertia, stiffness = np.diag(mass), np.zeros((count, count))
        for k in range(count - 1):
            spring = 2 / (1 / modulus[k] + 1 / modulus[k + 1])
            stiffness[k:k + 2, k:k + 2] += spring * np.array([[1, -1], [-1, 1]])
        force = np.eye(count)[0]
    else:
        b = 0 if wave == "P" else 1 / 12
        inertia, stiffness = np.zeros((2 * count, 2 * count)), np.zeros((2 * count, 2 * count))
        for k in range(count):
            own = slice(2 * k, 2 * k + 2)
            inertia[own, own] += mass[k] * np.array([[0.5 - b, b], [b, 0.5 - b]])
            stiffness[own, own] += modulus[k] * np.array([[1, -1], [-1, 1]])
            if k + 1 < count:
                joint = slice(2 * k + 1, 2 * k + 3)
                stiffness[joint, joint] += STIFF[wave] * np.array([[1, -1], [-1, 1]])
        # PRESSBC acts on the side, FORCE at the centroid.
        force = np.zeros(2 * count)
        force[:2] = (1, 0) if wave == "P" else (0.5, 0.5)
    top = []
    for one, dashpot in zip(w2, drag):
        matrix = stiffness - one * inertia + 0j
        matrix[0, 0] += dashpot
        u = np.linalg.solve(matrix, force)
        top.append(u[-1] if rigid else u[-2:].mean())
    # The force Z v gives an outcrop the velocity v.
    return np.abs(np.array(top) * drag)


def deck(case, wave, rigid):
    t = np.linspace(0, 2 * MIDDLE, 81)
    pulse = np.exp(-((t - MIDDLE) / WIDTH) ** 2)
    pulse[0] = pulse[-1] = 0
    text = case.text("column.deck").replace(
        "FUNCTION, 2\n0, 0\n1, 0", f"FUNCTION, {len(t)}\n" +
        "\n".join(f"{a:.15g}, {b:.15g}" for a, b in zip(t, pulse)))
    if wave == "P":
        stress = 2 * RHO[0] * speeds("P")[0]
        text = with_lines(text, FORCE=f"PRESSBC, 1, 1, {stress:.15g}, {stress:.15g}",
                          **{"JOINT, 6": "JOINT, 6, 0, 1.E12, 1.E12, 0, 0, 0, , , 3.24E12, 10."})
    if rigid:
        text = text.replace("\nEND\n", "\nRIGID\nEND\n")
        c = speeds("P")[0], speeds("S")[0]
        text = with_lines(text, QUIET=f"QUIET, 1, 1, {c[0]:.15g}, {c[1]:.15g}")
        for joint, (one, two) in enumerate(((0, 0), (1, 1), (2, 2), (0, 1), (1, 2)), 1):
            kn, ks = (2 / (1 / moduli(kind)[one] + 1 / moduli(kind)[two]) for kind in "PS")
            card = f"JOINT, {joint}"
            text = with_lines(text, **{card: f"{card}, 0, 1.E12, 1.E12, 0, 0, 0, , , "
                                             f"{kn:.15g}, {ks:.15g}"})
    return text, pulse, t


def spectrum(t, v, w):
    return np.abs(np.exp(1j * np.outer(w, t)) * np.gradient(t) @ v)


def peaks(f, values):
    """Returns frequency and height of the peaks, of parabolas through three points."""
    found = []
    for k in range(1, len(values) - 1):
        before, at, after = values[k - 1:k + 2]
        if before < at >= after:
            share = 0.5 * (before - after) / (before - 2 * at + after)
            found.append((f[k] + share * (f[1] - f[0]), at - 0.25 * (before - after) * share))
    return found


def check(case):
    runs = (("S", False, 0), ("P", False, 90), ("S", True, 215), ("P", True, 30))
    made = [deck(case, wave, rigid) for wave, rigid, _ in runs]
    done = case.run_all([("column.deck", (), turned(text, degrees))
                         for (text, _, _), (_, _, degrees) in zip(made, runs)])
    for (wave, rigid, degrees), (_, pulse, t), run in zip(runs, made, done):
        name = f"{'rigid' if rigid else 'deformable'}, {wave}, {degrees} degrees"
        slowest = speeds(wave)[2]
        f = np.linspace(0.004, 0.1, 481) * slowest  # to 10 blocks a wavelength at the top
        w = 2 * np.pi * f
        angle = np.radians(degrees + (0 if wave == "S" else 90))
        v = run.of("Velocity", sum(BLOCKS))[:, :2] @ (np.cos(angle), np.sin(angle))
        # The stress 2 rho c v is the input, and an outcrop moves by 2 v.
        ours = spectrum(run.times, v, w) / spectrum(t, 2 * pulse, w)
        exact, lattice = layers(wave, w), chain(wave, rigid, w, run.dt)
        case.at_most(f"{name}: largest error of the amplification, to 10 blocks a wavelength, of "
                     "blocks with contacts and steps", 0.03, np.abs(ours - lattice).max(),
                     "the pulse has linear pieces, and is recorded every 0.5 ms")
        long = f <= 0.05 * slowest
        case.at_most(f"{name}: largest error of the amplification, to 20 blocks a wavelength, of "
                     "layers", 0.06, np.abs(ours - exact)[long].max(),
                     "waves in blocks are slower by (kl)^2/24, at most 0.4 %")
        both = zip(peaks(f[long], exact[long]), peaks(f[long], ours[long]))
        for number, (theirs, mine) in enumerate(both, 1):
            case.equal(f"{name}: frequency of peak {number}", theirs[0], mine[0], 0.005,
                       "waves in blocks and through contacts are slower", "Hz")
            case.equal(f"{name}: amplification at peak {number}", theirs[1], mine[1], 0.02,
                       "waves in blocks and through contacts are slower")
        energy = run.summary["energy"]
        case.equal(f"{name}: energy through the quiet base / work of the input", 1,
                   energy["quiet"] / energy["loads"], 1e-3, "the rest is still in the column")
        if degrees in (0, 215):
            chart = Chart(f"Top over outcrop, {wave} waves, {'rigid' if rigid else 'deformable'} "
                          "blocks", "frequency, Hz", "amplification")
            chart.expected(f, exact, "layers")
            chart.ours(f[::8], ours[::8])
            case.chart(chart)
