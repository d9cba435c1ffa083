#!/usr/bin/python3
"""The figure of docs/rest.md: rest.py writes rest-flight.svg beside itself.

The paths are those of dv/dt = g - alpha |g| v / |v|, which validation/problems/free_fall compares
with the program.
"""

import math

from picture import INK, Picture

G = 10.0  # m/s2
START = (6.0, 8.0)  # m/s
BETWEEN = 0.2  # s from one drawn block to the next
SIDE = 0.36  # m
PATHS = ((0.0, "#1f6fb2", "#cfe1f2"), (0.2, "#b8801f", "#f5e3c0"), (0.8, "#c0392b", "#f4d3cf"))
LEFT, GROUND, SCALE = 50, 268, 63  # pixels; pixels per metre


def fly(alpha):
    """Returns (time, place) of a thrown block from step to step, until it is back at its height."""
    (vx, vy), x, y, t, dt = START, 0.0, 0.0, 0.0, 1e-4
    path = [(t, x, y)]
    while y >= 0.0:
        speed = math.hypot(vx, vy)
        vx, vy = vx - dt * alpha * G * vx / speed, vy - dt * (G + alpha * G * vy / speed)
        x, y, t = x + dt * vx, y + dt * vy, t + dt
        path.append((t, x, y))
    return path


def at(x, y):
    """Returns pixels."""
    return LEFT + SCALE * x, GROUND - SCALE * y


def flight():
    """Paths of a block thrown under local damping."""
    p = Picture(720, 305)
    p.text(360, 26, "The same block thrown at 10 m/s, with local damping alpha; outlines every 0.2 s", size=14)
    p.line((LEFT - 30, GROUND), (700, GROUND), INK, 1.2)
    for x in range(0, 11, 2):
        p.line(at(x, 0), (at(x, 0)[0], GROUND + 5), INK, 1.2)
        p.text(at(x, 0)[0], GROUND + 21, f"{x} m" if x else "0", size=12)
    for alpha, colour, fill in PATHS:
        path = fly(alpha)
        points = [at(x, y) for _, x, y in path[::100]]
        p.parts.append('<polyline points="' + " ".join(f"{x:.1f},{y:.1f}" for x, y in points) +
                       f'" fill="none" stroke="{colour}" stroke-width="2"/>')
        each = round(BETWEEN / 1e-4)
        for k in range(each, len(path), each):
            (x, y), half = at(*path[k][1:]), SCALE * SIDE / 2
            p.parts.append(f'<rect x="{x - half:.1f}" y="{y - half:.1f}" width="{2 * half:.1f}" '
                           f'height="{2 * half:.1f}" fill="{fill}" fill-opacity="0.75" '
                           f'stroke="{colour}" stroke-width="1.2"/>')
        time, x, _ = path[-1]
        top = max(path, key=lambda point: point[2])
        print(f"alpha {alpha:g}: {time:.3f} s, {x:.3f} m, top {top[2]:.3f} m at {top[0]:.3f} s")
    for (x, y), line, (_, colour, _) in (((8.0, 2.5), "no damping", PATHS[0]), ((6.5, 1.45), "alpha = 0.2", PATHS[1]),
                                         ((3.45, 1.0), "alpha = 0.8: falls with", PATHS[2]),
                                         ((3.45, 0.68), "a fifth of gravity", PATHS[2])):
        p.text(*at(x, y), line, colour, "start", 13)
    p.line(at(0, 0), at(0.75, 1.0), INK, 2, arrow=True)
    p.text(*at(0.1, 1.0), "10 m/s", INK, "middle", 12)
    p.save("rest-flight.svg")
    return p


if __name__ == "__main__":
    flight()
