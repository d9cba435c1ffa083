"""A scene in three frames, and its contact forces in the terms of the first one."""

import re

import numpy as np

from .deck import mirrored, turned

FRAMES = {"as drawn": lambda text: text,
          "turned by 115 degrees and shifted": lambda text: turned(text, 115, (300, -70)),
          "mirrored": mirrored}


def outlines(text):
    """Returns the corners of the CREATE cards of a deck, block by block, shape (n, 2)."""
    lines = text.splitlines()
    return [np.array([[float(word) for word in lines[k + row].split(",")] for row in (1, 2)]).T
            for k, line in enumerate(lines) if re.match(r"CREATE\b", line)]


def forces(run, name, frame=-1):
    """Returns {(corner block, corner, edge block): (normal, shear force)} of a run in the frame of
    this name. A mirror image has its corners in another order and shear of the other sign."""
    found, mirror = run.contacts(frame), name == "mirrored"
    corners = np.diff(run.corner_offsets)
    result = {}
    for block, corner, edge, normal, shear in zip(*(found[key] for key in (
            "CornerBlock", "Corner", "EdgeBlock", "NormalForce", "ShearForce"))):
        if mirror:
            corner, shear = 1 + (1 - corner) % corners[block - 1], -shear
        result[int(block), int(corner), int(edge)] = (normal, shear)
    return result
