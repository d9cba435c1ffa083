"""Modulus and wave speed of blocks and joints in series."""

from math import asin, cos, pi, sqrt

import numpy as np
from suite.chart import Chart
from suite.deck import with_lines
from suite.numbers import first_time, order, slope

LENGTH = "long"
C11, RHO, P = 1.2e10, 2500.0, 1e6


def modulus(stiffness, length=1.0, c11=C11):
    return 1 / (1 / c11 + 1 / (4 * stiffness * length))


def held(stiffness, c12=4e9):
    """Modulus of a block of 1 m x 1 m between planes that yield by s22 / K."""
    return C11 - c12 ** 2 / stiffness / (1 + C11 / stiffness)


STRAIGHT = "MATERIAL, 1, 1.2E10, 6.E9, 2500"  # nu = 0, the same C11


def speed(case, stiffness, rise, blocks=60, material=STRAIGHT, smooth=True,
          fraction=0.02, time=None, pressure=P):
    """Wave speed from the times when blocks 6 m to 36 m along the bar reach half the pressure."""
    text = with_lines(case.text("decks/wave/wave.deck"), PLOTS="PLOTS, 5E-5", MATERIAL=material,
                      FRACTION=f"FRACTION, {fraction}",
                      STIFF=f"STIFF, {stiffness:g}, {stiffness:g}",
                      MOTION=f"MOTION, {time or 0.5 * rise + 50 / sqrt(modulus(stiffness) / RHO):.4g}")
    text = text.replace("PRESSBC, 1, 1, 1.E6, 1.E6", f"PRESSBC, 1, 1, {pressure:g}, {pressure:g}")
    points = [f"{rise * k / 32:.9g}, {0.5 - 0.5 * cos(pi * k / 32):.9g}" for k in range(33)]
    if smooth:
        text = text.replace("FUNCTION, 3\n0, 0\n0.001, 1", "\n".join(["FUNCTION, 34", *points]))
    text = text.replace("LAYER, -60", f"LAYER, -{blocks}")
    text = text.replace("START, 60", f"START, {blocks}").replace("20, 40, 60", "20")
    run = case.run("wave", text=text)
    numbers = [b for b in range(1, blocks + 1) if 5.5 <= (b - 0.5) * 60 / blocks <= 36]
    stress = run.all("Stress")[:, :, 0]
    times = [first_time(run.times, -stress[:, b - 1], pressure / 2) for b in numbers]
    return slope(times, [(b - 0.5) * 60 / blocks for b in numbers]), run


def check(case):
    small = "what is left of the swing; strains are finite (1e-4)"
    for material, exact, what in ((STRAIGHT, modulus(2e10), "nu = 0"),
                                  (None, modulus(2e10, c11=held(2e10)), "nu = 0.25, planes give")):
        text = case.text("bar.deck")
        run = case.run("bar", text=with_lines(text, MATERIAL=material) if material else text)
        x = run.all("Centroid")[run.times > 0.2, :, 0].mean(axis=0)
        case.equal(f"slow bar: modulus of nine blocks and joints, {what}", exact,
                   -P / ((x[9] - x[0]) / 9 - 1), 1e-3, small, "Pa")

    because = "half height against dispersion; frames every 0.05 ms"
    stiff, ours = (2e9, 2e10, 2e11), []
    for k in stiff:
        ours.append(speed(case, k, 0.008)[0])
        case.equal(f"wave speed, K = {k:g}, rise 8 ms", sqrt(modulus(k) / RHO), ours[-1], 0.005,
                   because, "m/s")
    fine = np.geomspace(1e9, 4e11, 80)
    chart = Chart("Wave speed of a bar of blocks and joints", "contact stiffness K, N/m per m",
                  "speed, m/s", log="x")
    chart.expected(fine, np.sqrt(modulus(fine) / RHO), "sqrt(E_eff / rho)")
    chart.ours(stiff, ours)
    case.chart(chart)

    for fraction in (0.005, 0.06):
        other = speed(case, 2e10, 0.008, fraction=fraction)[0]
        case.equal(f"wave speed, K = 2e10, FRACTION {fraction} against 0.02", ours[1], other, 1e-3,
                   "the time step is not what limits the accuracy", "m/s")

    rises, exact = (0.001, 0.002, 0.004, 0.008), sqrt(modulus(2e11) / RHO)
    speeds = [speed(case, 2e11, rise)[0] for rise in rises[:-1]] + [ours[-1]]
    own = "MATERIAL, 1, 1.E10, 4.E9, 2500"
    case.equal("wave speed, decks/wave: nu = 0.25, rise 1 ms",
               sqrt(modulus(2e11, c11=held(2e11)) / RHO),
               speed(case, 2e11, 0.001, material=own, smooth=False)[0], 0.02,
               "a front of 2 m over blocks of 1 m", "m/s")
    chart = Chart("Dispersion: speed of the half height, K = 2e11", "rise of the pressure, ms",
                  "speed, m/s", log="x")
    chart.expected([0.9, 9], [exact, exact], "sqrt(E_eff / rho)")
    chart.ours([1e3 * rise for rise in rises], speeds, "blocks of 1 m")
    case.chart(chart)
    dispersion(case)


def chain_speed(hertz, stiffness, length):
    """Exact phase speed in a chain of deformable blocks: 1 / (4 K) = 4 sin^2(q/2) / (rho l w^2) -
    l cos^2(q/2) / (C11 - rho l^2 w^2 / 4), solved for sin^2(q/2)."""
    w = 2 * pi * hertz
    give = length / (C11 - RHO * length ** 2 * w ** 2 / 4)
    square = (1 / (4 * stiffness) + give) / (4 / (RHO * length * w ** 2) + give)
    return w * length / (2 * asin(sqrt(square)))


def phase_speed(run, hertz, length):
    """Phase speeds from the phases of the stress increments in blocks 6 m to 36 m along the bar,
    until the reflection from its end arrives."""
    numbers = [b for b in range(1, run.blocks + 1) if 5.5 <= (b - 0.5) * length <= 36]
    window = run.times < 0.035
    t = 0.5 * (run.times[window][1:] + run.times[window][:-1])
    gains = np.diff(run.all("Stress")[window, :, 0], axis=0)[:, [b - 1 for b in numbers]]
    w = 2 * pi * hertz
    phases = np.unwrap(np.angle(np.exp(-1j * w * t) @ gains))
    return -w / slope([(b - 0.5) * length for b in numbers], phases)


def dispersion(case):
    """Phase speeds of one pulse in blocks of three lengths, with equal joint compliance per metre."""
    exact = sqrt(modulus(2e11) / RHO)
    lengths, hertz = np.array([1.0, 0.5, 0.25]), np.array([50, 100, 150, 200, 250, 300])
    chart = Chart("Phase speed over that of the bar, K l = 2e11 N/m", "frequency, Hz",
                  "c / sqrt(E_eff / rho)")
    every, off = np.linspace(40, 310, 60), []
    for length in lengths:
        stiffness = 2e11 / length
        _, run = speed(case, stiffness, 0.002, round(60 / length), time=0.035, pressure=1e4)
        ours = np.array([phase_speed(run, f, length) for f in hertz])
        for f in (100, 300):
            case.equal(f"phase speed at {f} Hz, blocks of {length:g} m, chain",
                       chain_speed(f, stiffness, length), ours[list(hertz).index(f)], 2e-4,
                       "an exact answer; what rings on behind the pulse is cut off at 35 ms", "m/s")
        off.append(1 - ours[list(hertz).index(200)] / exact)
        chart.expected(every, [chain_speed(f, stiffness, length) / exact for f in every],
                       "chain" if length == 1 else "")
        chart.ours(hertz, ours / exact, f"blocks of {length:g} m")
    case.equal("order of convergence in the length of the blocks, phase speed at 200 Hz to the bar's", 2,
               order(lengths, off), 0.02, "the next term goes with the fourth power")
    case.chart(chart)
