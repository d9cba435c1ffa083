"""The frames of a results file: stored states of the model."""

from __future__ import annotations

import functools
import json
import math
import os
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _blocks, exports, frame_arrays, notebooks, quantities
from .dimensions import Units, unit_text
from .errors import FileError
from .results_file import frozen
from .state_tables import contact_table, crack_count

if TYPE_CHECKING:
    from .drawing import Drawing

__all__ = ["Frame"]

_REMOVED = 3  # value of the cell array Fixed for a removed block

_Floats = NDArray[np.float64]
_Integers = NDArray[np.integer]


class Frame:
    """One stored state of the model, with n blocks that have m corners.

    Blocks, corners and edges are counted from 0, so that numbers index the arrays. Only `number` and the cell
    arrays of `frame[name]` have the numbers of the cards, from 1. Arrays are read when they are first used;
    they are kept and cannot be written to. A removed block keeps its row, but has no corners.

    `frame[name]` is a cell array as the file has it, (n,), (n, 3) or, for tensors, (n, 4): "Stress".
    `len(frame)` is n. To iterate over a frame is to iterate over `names`.

    Attributes:
        results: the Results that the frame belongs to.
        index: its index in them, from 0.
        time: [T].
        step: number of the step.
    """

    def __init__(self, results: Any, index: int):
        self.results = results
        self.index = index
        self.time = float(results.times[index])
        self.step = int(results.steps[index])
        self._arrays: dict[str, NDArray[Any]] = {}

    # Cell arrays

    @functools.cached_property
    def names(self) -> tuple[str, ...]:
        """Names of the cell arrays of this frame, as in the file: "Stress", "Velocity"."""
        return self.results._file.read(lambda file: frame_arrays.cell_names(file, self.index))

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Returns a cell array as the file has it. Raises KeyError if there is none of that name."""
        if name in self._arrays:
            return self._arrays[name]
        if name not in self.names and name in frame_arrays.OF_EVERY_FRAME:
            raise FileError(f"cannot read {self.results.path}: it is damaged (frame {self.index} has no {name})")
        if name not in self.names:
            raise KeyError(f"there is no cell array {name!r}: choose {', '.join(self.names)}")
        self._arrays[name] = self.results._file.read(lambda file: frame_arrays.cell_array(file, self.index, name))
        return self._arrays[name]

    def __len__(self) -> int:
        return len(self["BlockNumber"])

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __contains__(self, name: object) -> bool:
        return name in self.names

    def keys(self) -> tuple[str, ...]:
        """The same as `names`, so that dict(frame) works."""
        return self.names

    # Shape

    @functools.cached_property
    def _outlines(self) -> tuple[_Floats, _Integers, _Integers, _Integers]:
        return self.results._file.read(lambda file: frame_arrays.outlines_of(file, self.index))

    @property
    def corners(self) -> _Floats:
        """(m, 2) [L] corners of all blocks, clockwise."""
        return self._outlines[0]

    @property
    def first_corner(self) -> _Integers:
        """(n + 1,) block b has the corners from first_corner[b] to first_corner[b + 1], half open."""
        return self._outlines[1]

    @property
    def joint(self) -> _Integers:
        """(m,) joint id of the side that begins at each corner; 0: none."""
        return self._outlines[2]

    @functools.cached_property
    def wet_sides(self) -> NDArray[np.void]:
        """The parts of sides on which water presses, with linear pressure: a structured array.

        `corner` is the row of `corners` where the side begins, `share` (2,) are the ends of the part as shares of
        the side, `pressure` (2,) [F/L^2] is the pressure there.
        """
        points = self._outlines[3]
        return self.results._file.read(lambda file: frame_arrays.wet_side_table(file, self.index, points))

    @functools.cached_property
    def water_table(self) -> _Floats:
        """(k, 2) [L] the water table as a line from the left to the right; (0, 2) without one."""
        return self.results._file.read(lambda file: frame_arrays.water_table_of(file, self.index))

    @functools.cached_property
    def polygons(self) -> list[_Floats]:
        """The outline (k, 2) of each block, [L], clockwise: views of `corners`."""
        return np.split(self.corners, self.first_corner[1:-1]) if len(self) else []

    @property
    def centroid(self) -> _Floats:
        """(n, 2) [L]."""
        return self["Centroid"][:, :2]

    @property
    def angle(self) -> _Floats:
        """(n,) rotation since the block was made, rad."""
        return self["Angle"]

    @property
    def rotation(self) -> _Floats:
        """(n,) rotation since the block was made, in degrees, as HISTORY has it."""
        return frozen(np.degrees(self.angle))

    @property
    def area(self) -> _Floats:
        """(n,) [L^2] when the block was made."""
        return self["Area"]

    @functools.cached_property
    def displacement(self) -> _Floats:
        """(n, 2) [L] of the centroids since the first frame of the file.

        Blocks that were made later have 0. A piece of a block that has split counts from where its material
        was (docs/cracks.md#pictures). A removed block has NaN.
        """
        centroid, cracks = self.results.first_state
        if self._crack_count != cracks:
            return frozen(_blocks._displacements(self.results.path, self.index))
        moved = np.zeros((len(self), 2))
        common = min(len(centroid), len(self))
        moved[:common] = self.centroid[:common] - centroid[:common]
        moved[self.is_removed] = math.nan
        return frozen(moved)

    # Motion and stress

    @property
    def velocity(self) -> _Floats:
        """(n, 2) [L/T] of the centroids."""
        return self["Velocity"][:, :2]

    @property
    def spin(self) -> _Floats:
        """(n,) [1/T] angular velocity."""
        return self["Spin"]

    @property
    def force(self) -> _Floats:
        """(n, 2) [F] of contacts, planes and loads, without gravity."""
        return self["Force"][:, :2]

    @property
    def water_force(self) -> _Floats:
        """(n, 2) [F] of water on each block, which is part of `force`; 0 without water."""
        return self["WaterForce"][:, :2] if "WaterForce" in self else frozen(np.zeros((len(self), 2)))

    @property
    def moment(self) -> _Floats:
        """(n,) [F L] of these forces about the centroid."""
        return self["Moment"]

    @property
    def mass(self) -> _Floats:
        """(n,) [M]."""
        return self["Mass"]

    @property
    def inertia(self) -> _Floats:
        """(n,) [M L^2] about the centroid."""
        return self["Inertia"]

    @property
    def stress(self) -> _Floats:
        """(n, 2, 2) [F/L^2] internal stress (12); 0 in rigid runs."""
        return self["Stress"].reshape(-1, 2, 2)

    @property
    def applied_stress(self) -> _Floats:
        """(n, 2, 2) [F/L^2] stress by the forces on the block (9)."""
        return self["AppliedStress"].reshape(-1, 2, 2)

    @property
    def strain_rate(self) -> _Floats:
        """(n, 2, 2) [1/T] (10); 0 in rigid runs."""
        return self["StrainRate"].reshape(-1, 2, 2)

    @property
    def unbalanced(self) -> _Floats:
        """(n,) [F] unbalanced force. Raises AttributeError if the deck does not ask for equilibrium."""
        if "UnbalancedForce" not in self:
            raise AttributeError("the file has no unbalanced forces: the deck does not ask for equilibrium")
        return self["UnbalancedForce"]

    @property
    def local_ratio(self) -> _Floats:
        """(n,) unbalanced force over all forces on the block. Raises AttributeError like `unbalanced`."""
        if "LocalRatio" not in self:
            raise AttributeError("the file has no local ratios: the deck does not ask for equilibrium")
        return self["LocalRatio"]

    # What the blocks are

    @property
    def number(self) -> _Integers:
        """(n,) number of the block in the deck, from 1."""
        return self["BlockNumber"]

    @property
    def material(self) -> _Integers:
        """(n,) number of the MATERIAL card."""
        return self["Material"]

    @property
    def fixed(self) -> _Integers:
        """(n,) 0 free, 1 fixed, 2 left the domain, 3 removed, 4 driven."""
        return self["Fixed"]

    @property
    def is_free(self) -> NDArray[np.bool_]:
        """(n,) False if fixed, driven, outside the domain or removed."""
        return self.fixed == 0

    @property
    def is_removed(self) -> NDArray[np.bool_]:
        """(n,) whether the block has been removed."""
        return self.fixed == _REMOVED

    @functools.cached_property
    def parent(self) -> _Integers:
        """(n,) block, from 0, from which each one split off; -1: none."""
        return frozen(self["Parent"] - 1 if "Parent" in self else np.full(len(self), -1, np.int32))

    # The model

    @property
    def units(self) -> Units | None:
        """Units of the deck, or None if it has no UNITS card."""
        return self.results.units

    @property
    def materials(self) -> dict[int, str]:
        """Names of the materials that have one, by number."""
        return self.results.materials

    @property
    def title(self) -> str:
        """Title of the deck."""
        return self.results.title

    def _scalar(self, name: str) -> float:
        return self.results._file.read(lambda file: frame_arrays.field_value(file, self.index, name))

    @property
    def kinetic_energy(self) -> float:
        """[F L]."""
        return self._scalar("KineticEnergy")

    @property
    def worst_overlap(self) -> float:
        """[L] overlap of the deepest contact of the frame."""
        return self._scalar("WorstOverlap")

    @property
    def unbalanced_ratio(self) -> float:
        """Ratio of the unbalanced forces; NaN if the deck does not ask for equilibrium."""
        return self._scalar("UnbalancedRatio") if "UnbalancedForce" in self else math.nan

    @functools.cached_property
    def _crack_count(self) -> int:
        return self.results._file.read(lambda file: crack_count(file, self.index))

    @property
    def cracks(self) -> NDArray[np.void]:
        """The cracks up to this frame: the first rows of `Results.cracks`."""
        return self.results.cracks[: self._crack_count]

    @functools.cached_property
    def contacts(self) -> NDArray[np.void]:
        """Structured array, a row for each contact that acts, of a corner on an edge.

        Fields, with blocks, corners and edges counted from 0: `corner_block`, `corner`, `edge_block` (-1: a
        symmetry plane), `edge` (number of its first corner, or of the plane), `point` [L] (the corner),
        `normal` (outward unit normal of the edge), `force` [F] on the block of the corner, `normal_force`,
        `shear_force` [F] and `overlap` [L]. With a JOINT card there is also the state of the law: `law`,
        `bonded`, `failed`, `slip`, ... (docs/results.md).
        """
        starts = self.first_corner
        return self.results._file.read(lambda file: contact_table(file, self.index, starts))

    # One number for each block

    def quantity(self, name: str) -> _Floats:
        """Returns one number for each block, (n,). Removed blocks have NaN.

        Args:
            name: a quantity of `blocks plot --colour`: speed, displacement, rotation (degrees), x, y, dx, dy,
                vx, vy, spin, fx, fy, moment, s11 to s22, p1 and p2 (stress), a11 to a22 (applied stress), e11
                to e22 (strain rate), unbalanced, local_ratio, mass, area, inertia. Attributes with one number for each
                block are accepted too: "fixed".

        Raises:
            KeyError: if there is no such quantity.
        """
        return quantities.quantity(self, name)

    @property
    def quantities(self) -> tuple[str, ...]:
        """Names of the quantities of this frame."""
        return quantities.quantity_names(self)

    def label(self, name: str) -> str:
        """Returns what a quantity is called on an axis: "displacement x"."""
        return quantities.kind_of(name).label

    def unit(self, name: str) -> str:
        """Returns the unit of a quantity as the program writes it: "m/s", or "L T⁻¹"."""
        return unit_text(quantities.kind_of(name).dimension, self.units)

    # Other forms

    def to_geojson(self, path: str | os.PathLike[str] | None = None) -> str | None:
        """Writes the blocks as `blocks export` does, a GeoJSON feature for each (docs/exchange.md).

        Blocks have the numbers of the cards, from 1. Removed blocks are left out. An older file with this path
        is kept as PATH.bak, PATH.bak2, ...

        Args:
            path: of the file; None: return the text.

        Raises:
            ValueError: if the path is that of the results.
            FileError: if the file cannot be written, or the path is a link.
        """
        text = exports.geojson_text(self)
        if path is None:
            return text
        if os.path.exists(path) and os.path.samefile(path, self.results.path):
            raise ValueError(f"{os.fspath(path)} would be overwritten: choose another path")
        _blocks._replace_file(os.fspath(path), text)
        return None

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The same as to_geojson(), as a dictionary: for geopandas and shapely."""
        return json.loads(exports.geojson_text(self))

    def to_pyvista(self) -> Any:
        """Returns the blocks as a pyvista.PolyData with all cell arrays, without removed blocks.

        Raises:
            ImportError: if pyvista is missing.
        """
        return exports.pyvista_mesh(self)

    def plot(self, ax: Any = None, colour: Any = "material", **options: Any) -> Drawing:
        """Draws the blocks on Matplotlib axes; see `blocks.plotting.plot`."""
        from .plotting import plot

        return plot(self, ax, colour, **options)

    def __repr__(self) -> str:
        name = os.path.basename(self.results.path)
        blocks = f"{len(self)} block" + ("s" if len(self) != 1 else "")
        return f"<Frame {self.index} of {name}: t {self.time:g}, step {self.step}, {blocks}>"

    def _repr_png_(self) -> bytes | None:
        return notebooks.png_of(self)

    def _repr_html_(self) -> str:
        return notebooks.html_of(self)
