"""Finite elements of an elastic, bedded rock mass above a panel, in plane strain."""

import numpy as np


def matrix_of_element(ks, width, height):
    """Returns the stiffness of a bilinear rectangle, E = 8 GPa, nu = 0.25, with bedding every 1 m
    of shear stiffness ks [N/m3]. Corners are anticlockwise from the lower left one."""
    e, nu = 8e9, 0.25
    compliance = np.array([[(1 - nu**2) / e, -nu * (1 + nu) / e, 0],
                           [-nu * (1 + nu) / e, (1 - nu**2) / e, 0],
                           [0, 0, 2 * (1 + nu) / e + 1 / ks]])
    stiffness, total = np.linalg.inv(compliance), np.zeros((8, 8))
    for x in (-3**-0.5, 3**-0.5):
        for y in (-3**-0.5, 3**-0.5):
            dx = np.array([y - 1, 1 - y, 1 + y, -1 - y]) / (2 * width)
            dy = np.array([x - 1, -1 - x, 1 + x, 1 - x]) / (2 * height)
            strain = np.zeros((3, 8))
            strain[0, ::2], strain[1, 1::2], strain[2, ::2], strain[2, 1::2] = dx, dy, dy, dx
            total += strain.T @ stiffness @ strain * width * height / 4
    return total


def deflection_of_roof(ks, pressure, cells=24):
    """Returns by how much the middle of the roof sinks when this pressure is removed [m]. The mass
    is 400 m wide and high with a free top and smooth sides. Beyond x = 150 m its bottom is fixed."""
    side, half_panel = 400.0, 150.0
    h, across = side / cells, cells + 1
    element = matrix_of_element(ks, h, h)
    total = np.zeros((2 * across**2, 2 * across**2))
    for row in range(cells):
        for column in range(cells):
            first = row * across + column
            nodes = np.array([first, first + 1, first + across + 1, first + across])
            at = np.stack([2 * nodes, 2 * nodes + 1], 1).ravel()
            total[np.ix_(at, at)] += element
    x = np.arange(across) * h
    # The part of each node's surroundings that lies above the panel.
    above = np.clip(half_panel - (x - h / 2), 0, h) - np.where(x == 0, h / 2, 0)
    load = np.zeros(len(total))
    load[1:2 * across:2] = -pressure * above
    held = x >= half_panel
    fixed = np.zeros(len(total), bool)
    fixed[0:2 * across:2], fixed[1:2 * across:2] = held, held
    fixed[::2 * across], fixed[2 * cells::2 * across] = True, True
    free = ~fixed
    moved = np.linalg.solve(total[np.ix_(free, free)], load[free])
    return -moved[np.searchsorted(np.flatnonzero(free), 1)]
