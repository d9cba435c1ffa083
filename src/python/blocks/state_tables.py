"""Contacts and cracks of a results file as structured arrays.

Fields are named and numbered as those of `Simulation.contacts` and `Simulation.cracks`: blocks, corners and
edges are counted from 0, although the file counts them from 1.
"""

from __future__ import annotations

import re

import h5py
import numpy as np
from numpy.typing import NDArray

from .results_file import frozen

__all__ = ["contact_table", "crack_count", "crack_table"]

_CONTACT_FIELDS = ("corner_block", "corner", "edge_block", "edge", "point", "normal", "force", "normal_force",
                   "shear_force", "overlap")
_CRACK_FIELDS = (("step", "i8"), ("time", "f8"), ("parent", "i4"), ("child", "i4"), ("cause", "i4"),
                 ("stress", "f8"), ("begin", "f8", 2), ("end", "f8", 2), ("parent_area", "f8"),
                 ("child_area", "f8"), ("released", "f8"), ("moved", "f8"), ("kinetic_before", "f8"),
                 ("kinetic_after", "f8"), ("strain_before", "f8"), ("strain_after", "f8"))


def _snake(name: str) -> str:
    """Returns "corner_block" for "CornerBlock"."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def contact_table(file: h5py.File, frame: int, first_corner: NDArray[np.integer]) -> NDArray[np.void]:
    """Reads the contacts of a frame.

    Args:
        file: the results.
        frame: its index, from 0.
        first_corner: (n + 1,) where the corners of each block begin.
    """
    group = file["BLOCKS/contacts"]
    begin, rows = int(group["Offsets"][frame]), int(group["Counts"][frame])
    columns = {_snake(name): group[name][begin : begin + rows] for name in set(group) - {"Offsets", "Counts"}}
    columns["force"] = np.zeros((rows, 2))
    for name in ("point", "normal"):
        columns[name] = columns[name][:, :2]
    order = [*_CONTACT_FIELDS, *sorted(set(columns) - set(_CONTACT_FIELDS))]
    table = np.zeros(rows, [(name, columns[name].dtype, columns[name].shape[1:]) for name in order])
    for name in order:  # rows that a column lacks belong to frames before the first JOINT card: 0
        table[name][: len(columns[name])] = columns[name]
    for name in ("corner_block", "corner", "edge_block", "edge"):
        table[name] -= 1
    _expect_in_range(table, np.diff(first_corner))
    on_block = table["edge_block"] >= 0
    table["corner"] += first_corner[table["corner_block"]].astype(table["corner"].dtype)
    table["edge"][on_block] += first_corner[table["edge_block"][on_block]].astype(table["edge"].dtype)
    normal = table["normal"]
    along = np.stack([normal[:, 1], -normal[:, 0]], axis=1)  # normals are on the left of edges
    table["force"] = normal * table["normal_force"][:, None] - along * table["shear_force"][:, None]
    return frozen(table)


def _expect_in_range(contacts: NDArray[np.void], corners: NDArray[np.integer]) -> None:
    """Raises ValueError unless all corners and edges of blocks exist; `corners` has their number in each block."""
    blocks, other = contacts["corner_block"], contacts["edge_block"]
    on_block = other >= 0
    for name, low, most in (("CornerBlock", blocks, len(corners)), ("EdgeBlock", other + 1, len(corners) + 1)):
        if np.any((low < 0) | (low >= most)):
            raise ValueError(f"contacts/{name} is out of range")
    edges = contacts["edge"][on_block]
    for name, index, of in (("Corner", contacts["corner"], blocks), ("Edge", edges, other[on_block])):
        if np.any((index < 0) | (index >= corners[of])):
            raise ValueError(f"contacts/{name} is out of range")


def crack_count(file: h5py.File, frame: int) -> int:
    """Returns the number of cracks up to a frame."""
    counts = file.get("BLOCKS/cracks/counts")
    return int(counts[frame]) if counts is not None and counts.shape[0] > frame else 0


def crack_table(file: h5py.File, rows: int) -> NDArray[np.void]:
    """Reads the first cracks."""
    table = np.zeros(rows, list(_CRACK_FIELDS))
    if rows > 0:
        group = file["BLOCKS/cracks"]
        for name in set(table.dtype.names) - {"begin", "end", "released"}:
            table[name] = group[name][:rows]
        for name, stored in (("begin", "from"), ("end", "to")):
            table[name] = group[stored][:rows, :2]
        for name in ("parent", "child"):
            table[name] -= 1
        before, after = (table["kinetic_" + when] for when in ("before", "after"))
        table["released"] = before + table["strain_before"] - after - table["strain_after"]
    return frozen(table)
