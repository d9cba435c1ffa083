"""Quasi-static model of a box that slides on springs per length over fixed boxes of its width."""

import math

import numpy as np


def ends_of_faces(way):
    """Returns the contacts of a slider of width 1 that has moved by `way`, from boxes between whole
    numbers: {(end, box): (half the length of the face, position from the middle of the slider)}.
    An end is a corner of the slider (rear, front) or of the box (left, right)."""
    contacts = {}
    for box in range(math.floor(way), math.floor(way + 1 - 1e-12) + 1):
        low, high = max(way, box), min(way + 1, box + 1)
        if high > low:
            half = (high - low) / 2
            contacts["rear" if low == way else "left", box] = half, low - way - 0.5
            contacts["front" if high == way + 1 else "right", box] = half, high - way - 0.5
    return contacts


def pass_on(ended, old, contacts, way):
    """Adds the springs of the contacts that have ended to the nearest contact of the same two faces
    or of the same corner. old: (force, stiffness) by contact."""
    for end, box in ended:
        force, _ = old.pop((end, box))
        place = box + (end in ("front", "right"))
        near = [key for key in contacts if key[1] == box or key[0] == end]
        if near:
            heir = min(near, key=lambda key: abs(contacts[key][1] + way + 0.5 - place))
            old[heir] = old[heir][0] + force, old[heir][1]


def sinking(friction, ways, step, follows_length):
    """Returns the depth of the middle of the slider at these ways, in units of W / kn, less that at
    its start. The slider has width and height 1 and weight W. With follows_length, a force changes
    in proportion to the length of its contact, so that it is kn L times the overlap. Otherwise
    forces change by closing only, stiffnesses never shrink, and springs of contacts that end are
    added to others."""
    depth, tilt, depths = 1.0, 0.0, []
    grid = np.arange(0.0, max(ways) + step, step)
    springs, before = {key: (half, half) for key, (half, _) in ends_of_faces(0.0).items()}, {}
    for way in grid + 1e-9:
        contacts = ends_of_faces(way)
        for key, (half, at) in contacts.items():
            overlap = depth + tilt * at
            born = (half * overlap if follows_length else 0.0), half
            force, stiffness = springs.setdefault(key, born)
            moved = at - before[key] if key in before else 0.0
            force += stiffness * tilt * moved
            if follows_length:
                longer = half - stiffness
                force = force + longer * overlap if longer > 0 else force * half / stiffness
                stiffness = half
            springs[key] = max(0.0, force), max(stiffness, half)
        ended = [key for key in springs if key not in contacts]
        if follows_length:  # Faces end with length 0, so without force.
            springs = {key: spring for key, spring in springs.items() if key in contacts}
        else:
            pass_on(ended, springs, contacts, way)
        before = {key: at for key, (_, at) in contacts.items()}
        for _ in range(60):  # Contacts may open, so equilibrium is found by iterations.
            missing = 1 - sum(force for force, _ in springs.values())
            moment = friction / 2 - sum(f * before[key] for key, (f, _) in springs.items())
            if abs(missing) + abs(moment) < 1e-9:
                break
            matrix = sum(k * np.array([[1, before[key]], [before[key], before[key]**2]])
                         for key, (_, k) in springs.items())
            down, turn = np.linalg.lstsq(matrix, np.array([missing, moment]), rcond=None)[0]
            depth, tilt = depth + down, tilt + turn
            springs = {key: (max(0.0, f + k * (down + before[key] * turn)), k)
                       for key, (f, k) in springs.items()}
        depths.append(depth)
    return np.interp(ways, grid, depths) - depths[0]
