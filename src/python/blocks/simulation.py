"""A model that the calling program advances step by step."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from . import _blocks
from .dimensions import Units
from .documented import attributes_of
from .inputs import DeckLike, name_and_text, whole
from .notebooks import html_of
from .selectors import Selectors
from .simulation_cards import SimulationCards

__all__ = ["Simulation", "Solution"]


class Solution(NamedTuple):
    """How a SOLVE has ended."""

    steps: int  #: made by it
    ratio: float  #: of the unbalanced forces at the end
    converged: bool  #: whether two successive tests found at most the ratios that were wanted
    wanted: float  #: ratio
    time: float  #: [T] at the end
    local: float  #: largest local ratio of a block at the end
    wanted_local: float  #: local ratio
    block: int  #: that has the largest local ratio, from 0; -1: none


class Trial(NamedTuple):
    """A run of the model with the strength of its joints divided by a factor."""

    factor: float  #: by which the strength was divided
    outcome: str  #: "stable", "failing" or "undecided"
    steps: int  #: made
    ratio: float  #: of the unbalanced forces at the end
    local: float  #: largest local ratio of a block at the end
    speed: float  #: [L/T] of the fastest block at the end
    block: int  #: that block, from 0; -1: none
    moved: float  #: [L] by the centroid that moved farthest


class FactorOfSafety(NamedTuple):
    """The bracket of a factor of safety, both ends proved by a trial."""

    lower: float | None  #: largest factor with which the model was stable; None: none
    upper: float | None  #: smallest factor above it with which it was failing; None: none
    trials: list[Trial]  #: in the order in which they were needed


class Simulation(_blocks.Simulation, Selectors):
    """A model that the calling program advances step by step, with the same bits as `blocks run`.

    The cards of the deck are executed: START to END, then blocks and loads. MOTION, CYCLE and SOLVE advance
    the time; with `moves=False` the deck is executed only up to the first of them. The only files written
    are those asked for with `write_frame` and `write_checkpoint`. n blocks have m corners.

    Arrays are views of the memory of the model, without a copy: they show the state after the last step.
    Only `velocity` and `spin` can be written to. When cards add blocks or blocks split, the arrays get other
    memory; a view taken before keeps the values that it had, and writing to it has no effect. Views also
    outlive the simulation. One thread at a time can use a simulation.

    Args:
        deck: text, path or `Deck`. Names of files on the cards of a path are relative to its folder.
        threads: 1 to 1024; does not change the results.
        moves: False: execute the deck only up to its first MOTION, CYCLE or SOLVE.

    Raises:
        DeckError: if cards contain errors.
        UnsoundRun: if one of the cards makes steps that become unsound.

    Attributes:
        time: [T].
        steps: number of steps made.
        time_step: [T] of the next step (4); 0 without blocks.
        corners: (m, 2) [L] corners of all blocks, clockwise.
        first_corner: (n + 1,) block b has the corners from first_corner[b] to first_corner[b + 1], half open.
        corner_block: (m,) block of each corner.
        joint: (m,) joint id of the side that begins at each corner; 0: none.
        centroid: (n, 2) [L].
        velocity: (n, 2) [L/T] of the centroids. May be written to, for free blocks.
        spin: (n,) [1/T] angular velocity. May be written to, for free blocks.
        angle: (n,) rotation since the block was made, rad.
        gradient: (n, 2, 2) deformation gradient since the block was made.
        stress: (n, 2, 2) [F/L^2] internal stress (12).
        strain_rate: (n, 2, 2) [1/T] (10).
        force: (n, 2) [F] on each block in the last step, without gravity.
        moment: (n,) [F L] in the last step.
        mass: (n,) [M].
        inertia: (n,) [M L^2] about the centroid.
        area: (n,) [L^2] when the block was made.
        material: (n,) number of the MATERIAL card.
        is_free: (n,) False if fixed, driven, outside the domain or removed. A copy.
        is_removed: (n,) True for blocks that REMOVE has taken out. A copy.
        contacts: structured array, a row for each contact that acted in the last step: `corner_block`,
            `corner`, `edge_block` (-1: a symmetry plane), `edge` (number of its first corner, or of the
            plane), `point` [L], `normal` (outward unit normal of the edge), `force` [F] on the block of the
            corner, `normal_force`, `shear_force` [F] and `overlap` [L]. If joints have laws (docs/laws.md),
            also `law` (joint id; 0: STIFF and FRICTN), `bonded`, `failed`, `slip`, `slip_path`, `dilation`,
            `closure`, `plastic_closure`, `length` [L], `normal_stiffness` and `shear_stiffness` [F/L].
            A copy.
        contact_force: (n, 2) [F] sum of the contact forces on each block in the last step. A copy.
        water_force: (n, 2) [F] of water on each block where it is now; 0 without WATER. A copy.
        cracks: structured array, a row for each crack so far: `step`, `time`, `parent`, `child`, `cause`
            (0: stress, 1: point loads), `stress` [F/L^2], `begin`, `end` [L], `parent_area`, `child_area`
            [L^2] and `released` [F L]. A copy.
        kinetic_energy: [F L].
        worst_overlap: [L] largest overlap of any contact so far.
        unbalanced_ratio: of the forces in the last step: 0 in equilibrium, 1 in free fall.
        is_read: whether the contacts of the last step are known.
        is_rigid: whether the blocks are rigid.
        warnings: messages so far, in printed form.
        title: of the deck.
        materials: names of the materials that have one, by number.
        units: names of the units `length`, `mass` and `time`; None if the deck names none.
    """

    def __init__(self, deck: DeckLike, threads: int = 1, moves: bool = True):
        super().__init__(*name_and_text(deck), whole(threads, "threads", 1, 1024), moves)
        self._first_centroid = self.centroid.copy()

    def step(self, count: int = 1, read: bool | None = None, *, every: int = 0,
             callback: Callable[[Simulation], Any] | None = None) -> None:
        """Makes steps. Other threads of Python run meanwhile, and Ctrl-C stops after a step.

        Args:
            count: number of steps.
            read: whether the contacts of the last step will be asked for, which may take as long as the
                step. None: yes, if there are at least 50 steps, or if contacts have been asked for since the
                steps before. With `callback` it is the last step before each call; None: yes before the
                first call.
            every: number of steps between two calls of `callback`; 0: 1 if there is a callback.
            callback: is called with the simulation after every `every` steps. If it returns a true value,
                no more steps are made.

        Raises:
            UnsoundRun: if a step made the state unusable.
            ValueError: if there are no blocks, or a velocity that was written is not possible.
        """
        call = None if callback is None else lambda: callback(self)
        between = whole(every, "every", 0) or (0 if callback is None else 1)
        self._step(whole(count, "the number of steps", 0), read, between, call)

    def run_until(self, time: float, read: bool | None = None, *, every: int = 0,
                  callback: Callable[[Simulation], Any] | None = None) -> None:
        """Makes the steps to this time [T], as MOTION does. See `step`.

        Raises:
            ValueError: if the time has passed, by more than the step that reached it.
        """
        count = self._steps_until(time)
        if time < self.time - self.time_step:
            raise ValueError(f"the time {time:g} has passed: it is {self.time:g}")
        self.step(count, read, every=every, callback=callback)

    def solve(self, ratio: float = 1e-5, nmax: int = 100_000, local: float | None = None) -> Solution:
        """Makes steps until the forces are balanced (SOLVE). Needs damping.

        Args:
            ratio: unbalanced forces over all forces, at which two successive tests end it.
            nmax: largest number of steps.
            local: largest local ratio of a block; None: 100 times the ratio, at most .01.

        Raises:
            DeckError: if a ratio or the number is not possible, or there are no blocks.
            UnsoundRun: if a step made the state unusable.
        """
        given = () if local is None else (float(local),)
        self.cards.solve(float(ratio), whole(nmax, "nmax", 1), *given)
        return self.solutions[-1]

    def fos(
        self,
        width: float = 0.01,
        ratio: float = 1e-5,
        ncycle: int | None = None,
        lower: float | None = None,
        upper: float | None = None,
    ) -> FactorOfSafety:
        """Finds the factor of safety by reduction of strength (FOS). The blocks stay where they are.

        Args:
            width: wanted width of the bracket.
            ratio: of the unbalanced forces in a stable trial, as in `solve`.
            ncycle: largest number of steps of a trial; None: 500 times the response of the model.
            lower: factor at which the model is stable; None: is looked for.
            upper: factor at which it fails; None: is looked for.

        Raises:
            DeckError: if a value is not possible, or nothing has balanced the forces before.
        """
        given = [float(width), float(ratio)]
        given += [None if ncycle is None else whole(ncycle, "ncycle", 1)]
        given += [None if bound is None else float(bound) for bound in (lower, upper)]
        self._execute("FOS, " + ", ".join("" if value is None else repr(value) for value in given))
        return self.factors_of_safety[-1]

    @property
    def factors_of_safety(self) -> list[FactorOfSafety]:
        """The result of each FOS so far, those of cards included."""
        return [
            FactorOfSafety(lower, upper, [Trial(*trial) for trial in trials])
            for lower, upper, trials in self._factors_of_safety
        ]

    @property
    def solutions(self) -> list[Solution]:
        """How each SOLVE so far has ended, those of cards included."""
        return [Solution(*solve) for solve in self._solves]

    @property
    def cards(self) -> SimulationCards:
        """Executes further problem cards: `sim.cards("FRICTN, 0.4")`, or by name `sim.cards.frictn(0.4)`."""
        return SimulationCards(self._execute)

    def _execute(self, text: str) -> None:
        super().cards(text)
        self._note_new_blocks()

    def _note_new_blocks(self) -> None:
        """Keeps the centroids of blocks that cards have added. Those of the pieces of cracks are not known."""
        first, now = self._first_centroid, self.centroid
        added = now[len(first):].copy()
        pieces = self.cracks["child"]
        added[pieces[pieces >= len(first)] - len(first)] = np.nan
        self._first_centroid = np.concatenate([first, added])

    def set_velocity(self, block: int, velocity: Any, spin: float | None = None) -> None:
        """Sets the velocity (2,) [L/T] of a free block, and its spin [1/T] if given."""
        super().set_velocity(block, _vector(velocity), spin)

    def set_force(self, block: int, force: Any) -> None:
        """Sets a force (2,) [F] at the centroid of a block, in every step from now on.

        It acts in addition to the loads of cards and replaces the force that was set before; 0 ends it.

        Raises:
            ValueError: if the block is not free, or the force is not finite.
        """
        super().set_force(block, _vector(force))

    def write_frame(self, path: str | os.PathLike) -> None:
        """Appends the state to a results file (.vtkhdf). The first call makes a new file.

        An existing file is renamed to the first of `path`.bak, `path`.bak2, ... that is free.

        Raises:
            FileError: if the file cannot be written, or another simulation writes to it.
        """
        super().write_frame(os.fspath(path))

    def write_checkpoint(self, path: str | os.PathLike) -> None:
        """Writes the state for RESTART.

        The first call with a path renames existing files with the names `path` and `path`.prev to .bak, .bak2,
        ... Later calls keep the previous checkpoint as `path`.prev.

        Raises:
            FileError: if the file cannot be written, or the path is a link, a folder or a device.
        """
        super().write_checkpoint(os.fspath(path))

    @property
    def displacement(self) -> np.ndarray:
        """(n, 2) [L] of the centroids since the simulation was made, or since later cards made the block.

        Pieces that cracks have split off since then have NaN. Their displacements are in `Frame.displacement`.
        A copy.
        """
        self._note_new_blocks()
        return self.centroid - self._first_centroid

    @property
    def rotation(self) -> np.ndarray:
        """(n,) rotation since the block was made, in degrees, as HISTORY has it. A copy."""
        return np.degrees(self.angle)

    @property
    def units(self) -> Units | None:
        """Names of the units; None if the deck names none."""
        return Units(*self._units) if self._units else None

    @property
    def polygons(self) -> list[np.ndarray]:
        """The outline (k, 2) of each block, [L], clockwise: views of `corners`; empty for removed blocks."""
        outlines = np.split(self.corners, self.first_corner[1:-1]) if len(self) else []
        return [outline[:0] if gone else outline for outline, gone in zip(outlines, self.is_removed)]

    def plot(self, ax=None, **options: Any):
        """Draws the blocks on Matplotlib axes; see `blocks.plotting.plot`."""
        from .plotting import plot
        return plot(self, ax, **options)

    def _repr_html_(self) -> str:
        return html_of(self)

    def __repr__(self) -> str:
        try:
            return (f"<Simulation {self.title!r}: {len(self)} blocks, step {self.steps}, time {self.time:g}, "
                    f"time step {self.time_step:.4g}>")
        except RuntimeError as error:  # it is making steps
            return f"<Simulation: {error}>"


def _vector(value: Any) -> np.ndarray:
    vector = np.asarray(value, dtype=float)
    if vector.shape != (2,):
        raise ValueError(f"expected the two components of a vector, not the shape {vector.shape}")
    return vector


# The properties of the compiled class get the help that the docstring above gives.
for _name, _text in attributes_of(Simulation).items():
    if _name in vars(_blocks.Simulation):
        vars(_blocks.Simulation)[_name].__doc__ = _text
