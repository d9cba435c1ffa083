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
        self._parts = self._vtk["Steps/PartOffsets"][:]  # of each frame
        self.counts = self._vtk["NumberOfCells"][:][self._parts]  # blocks in each frame
        self._data = {}

    @property
    def dt(self):
        """Time step [T]."""
        return self.summary["dt"]["value"]

    @property
    def blocks(self):
        """Number of blocks at the end."""
        return self.summary["blocks"]

    @property
    def exists(self):
        """Whether a frame has a block, shape (frames, blocks)."""
        return np.arange(self.blocks) < self.counts[:, None]

    @property
    def cracks(self):
        """The cracks in the order in which blocks split, as the summary has them."""
        return self.summary["cracks"]

    def all(self, field):
        """Returns a quantity of all blocks, shape (frames, blocks[, components]). Blocks that a
        frame does not have yet are NaN there, whole numbers 0."""
        if field not in self._data:
            # Rows that do not change are stored once. Every frame has the index of its first row.
            starts = self._vtk["Steps/CellDataOffsets/" + field][:]
            values = self._vtk["CellData/" + field][:]
            absent = np.nan if np.issubdtype(values.dtype, np.floating) else 0
            data = np.full((len(starts), self.blocks, *values.shape[1:]), absent, values.dtype)
            for rows, start, count in zip(data, starts, self.counts):
                rows[:count] = values[start:start + count]
            self._data[field] = data
        return self._data[field]

    @property
    def corner_offsets(self):
        """Returns where the corners of each block begin in the first frame, with the end."""
        return self._offsets(0)

    def _offsets(self, frame):
        """Returns where the corners of each block begin in a frame, with the end."""
        # A part is the outlines of some frames. It has one offset more than it has blocks.
        first = self._vtk["Steps/CellOffsets"][frame] + self._parts[frame]
        return self._vtk["Offsets"][first:first + self.counts[frame] + 1]

    def of(self, field, block):
        """Returns a quantity of one block over the frames."""
        return self.all(field)[:, block - 1]

    def outline(self, block, frame):
        """Returns the corners of a block, clockwise, shape (n, 2)."""
        start = self._vtk["Steps/PointOffsets"][frame]
        first, last = self._offsets(frame)[block - 1:block + 1]
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

    def history(self, quantity):
        """Returns the times and values of a quantity of the last HISTORY card."""
        groups = self._file["BLOCKS/history"]
        group = groups[max(groups, key=int)]
        names = group["quantities"].asstr()[()].splitlines()
        rows = group.attrs["rows"]
        return group["time"][:rows], group["values"][:rows, names.index(quantity)]

    def kinetic_energy(self):
        """Kinetic energy of all free blocks over the frames, without strain rates [F L]."""
        v, spin = self.all("Velocity"), self.all("Spin")
        mass, inertia = self.all("Mass"), self.all("Inertia")
        return 0.5 * self._sum(mass * (v ** 2).sum(axis=2) + inertia * spin ** 2)

    def momentum(self):
        """Momentum of all blocks over the frames, shape (frames, 2)."""
        return np.stack([self._sum(self.all("Mass") * self.all("Velocity")[:, :, k])
                         for k in (0, 1)], axis=1)

    def angular_momentum(self):
        """Angular momentum of all blocks about the origin over the frames."""
        x, v = self.all("Centroid"), self.all("Velocity")
        orbit = x[:, :, 0] * v[:, :, 1] - x[:, :, 1] * v[:, :, 0]
        return self._sum(self.all("Mass") * orbit + self.all("Inertia") * self.all("Spin"))

    def _sum(self, values):
        """Returns the sum over the blocks that each frame has."""
        return values.sum(axis=1, where=self.exists)
