#!/usr/bin/python3
"""The figures of docs/rest.md: rest.py writes rest-flight.svg and rest-corners.svg beside itself.

The paths of rest-flight.svg are those of dv/dt = g - alpha |g| v / |v|, which validation/problems/free_fall compares
with the program.
"""

import math

from picture import ACTS, INK, OTHER, Picture

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


def corners():
    """The contacts at the ends of a face before and after a shift along it."""
    p = Picture(720, 282)
    top, face, low, width = 62, 132, 202, 200
    for x, shift, title in ((70, 0, "corners meet"), (430, 34, "upper block shifted to the right")):
        p.text(x + (width + shift) / 2, 28, title, size=14)
        p.block([(x, face), (x + width, face), (x + width, low), (x, low)], OTHER)
        p.block([(x + shift, top), (x + width + shift, top), (x + width + shift, face), (x + shift, face)])
        p.text(x + shift + width / 2, top + 38, "upper block")
        p.text(x + width / 2, face + 42, "lower block")
        if shift:
            for corner in (x + shift, x + width):
                p.dot(corner, face)
            for corner in (x, x + width + shift):
                p.parts.append(f'<circle cx="{corner}" cy="{face}" r="4.5" fill="white" stroke="{INK}"/>')
            p.text(x + shift + 9, face - 10, "F, 2k", ACTS, "start", 13)
            p.text(x + width - 9, face + 20, "F, 2k", ACTS, "end", 13)
        else:
            for corner in (x, x + width):
                p.dot(corner, face - 5)
                p.dot(corner, face + 5)
            for corner, anchor in ((x - 10, "end"), (x + width + 10, "start")):
                p.text(corner, face - 6, "F/2, k", ACTS, anchor, 13)
                p.text(corner, face + 14, "F/2, k", ACTS, anchor, 13)
    p.dot(70, 237)
    p.text(84, 241, "corner that acts on the side of the other block: its normal force, its stiffness",
           anchor="start", size=12.5)
    p.parts.append(f'<circle cx="70" cy="261" r="4.5" fill="white" stroke="{INK}"/>')
    p.text(84, 265, "corner beyond the end of the side: its contact has passed its spring on",
           anchor="start", size=12.5)
    p.save("rest-corners.svg")
    return p


if __name__ == "__main__":
    flight()
    corners()
