"""Reads the output of a run, NAME.vtkhdf and NAME.summary.json. Blocks are numbered from 1."""

import json

import h5py
import numpy as np


class Results:
    """One finished run."""

    def __init__(self, stem, processor_seconds, log=""):
        self.log = log  # what the run has printed
        self.processor_seconds = processor_seconds  # of the whole run, including files
        self.path = stem.with_name(stem.name + ".vtkhdf")
        self.summary = json.loads(stem.with_name(stem.name + ".summary.json").read_text())
        self._file = h5py.File(self.path)
        self._vtk = self._file["VTKHDF"]
        self.times = self._vtk["Steps/Values"][:]
        self._data = {}

    @property
    def dt(self):
        """Time step [T]."""
        return self.summary["dt"]["value"]

    @property
    def blocks(self):
        """Number of blocks."""
        return self.summary["blocks"]

    def all(self, field):
        """Returns a quantity of all blocks, shape (frames, blocks[, components])."""
        if field not in self._data:
            # Rows that do not change are stored once. Every frame has the index of its first row.
            starts = self._vtk["Steps/CellDataOffsets/" + field][:]
            values = self._vtk["CellData/" + field][:]
            self._data[field] = np.array([values[s:s + self.blocks] for s in starts])
        return self._data[field]

    @property
    def corner_offsets(self):
        """Returns where the corners of each block begin in the first frame, with the end."""
        return self._vtk["Offsets"][:self.blocks + 1]

    def of(self, field, block):
        """Returns a quantity of one block over the frames."""
        return self.all(field)[:, block - 1]

    def outline(self, block, frame):
        """Returns the corners of a block, clockwise, shape (n, 2)."""
        start = self._vtk["Steps/PointOffsets"][frame]
        first, last = self._vtk["Offsets"][block - 1], self._vtk["Offsets"][block]
        return self._vtk["Points"][start + first:start + last, :2]

    def contacts(self, frame):
        """Returns the acting contacts of a frame as a dictionary of columns."""
        group = self._file["BLOCKS/contacts"]
        start, count = group["Offsets"][frame], group["Counts"][frame]
        return {name: group[name][start:start + count] for name in group
                if name not in ("Counts", "Offsets")}

    def all_contacts(self):
        """Returns the acting contacts of all frames as a dictionary of columns, with the frame of
        each row as "Frame"."""
        group = self._file["BLOCKS/contacts"]
        counts = group["Counts"][:]
        columns = {name: group[name][:] for name in group if name not in ("Counts", "Offsets")}
        return {**columns, "Frame": np.repeat(np.arange(len(counts)), counts)}

    def overlap(self, corner_block, edge_block, frame=-1):
        """Returns the overlaps [L] of the corners of one block in another, by corner."""
        found = self.contacts(frame)
        mine = (found["CornerBlock"] == corner_block) & (found["EdgeBlock"] == edge_block)
        return found["Overlap"][mine]

    def free(self):
        """Returns the numbers of the blocks that are free at the end."""
        return [b + 1 for b in range(self.blocks) if not self.all("Fixed")[-1][b]]

    def kinetic_energy(self):
        """Kinetic energy of all free blocks over the frames [F L]."""
        v, spin = self.all("Velocity"), self.all("Spin")
        mass, inertia = self.all("Mass"), self.all("Inertia")
        return 0.5 * (mass * (v ** 2).sum(axis=2) + inertia * spin ** 2).sum(axis=1)

    def momentum(self):
        """Momentum of all blocks over the frames, shape (frames, 2)."""
        return (self.all("Mass")[:, :, None] * self.all("Velocity")).sum(axis=1)[:, :2]

    def angular_momentum(self):
        """Angular momentum of all blocks about the origin over the frames."""
        x, v = self.all("Centroid"), self.all("Velocity")
        orbit = x[:, :, 0] * v[:, :, 1] - x[:, :, 1] * v[:, :, 0]
        return (self.all("Mass") * orbit + self.all("Inertia") * self.all("Spin")).sum(axis=1)
