"""BLOCKS: 2D block motion code for jointed rock.

Rock is an assembly of polygonal blocks, rigid or simply deformable, that move under gravity, pressure and
impact, collide corner to edge, slide and rub. A deck of cards describes the problem.

    import blocks

    run = blocks.run("decks/subsidence/subsidence.deck", out="subsidence")   # as `blocks run` does
    run.results[-1].plot(colour="material", forces=True)

    wall = blocks.Simulation("decks/slope/slope.deck", moves=False)          # step by step
    while wall.time < 1.0:
        wall.step(100)

Blocks, corners and edges are counted from 0, as NumPy counts. On cards, in messages and in names of
histories they are counted from 1. Vectors are rows: the centroids of n blocks are an array (n, 2).
Dimensions are [L], [M], [T] and [F] per unit thickness, in the units of the deck. Anticlockwise rotation
and tension are positive.
"""

from ._blocks import Diagnostic, __version__, card_table, predicates
from .assembly import Assembly, check, joints, layers
from .deck import Deck
from .errors import BlocksError, DeckError, DeckWarning, FileError, NotReadError, RunWarning, UnsoundRun
from .results import Frame, History, Results, read
from .running import Run, run
from .simulation import FactorOfSafety, Simulation, Solution, Trial
from .simulation_cards import SimulationCards
from .studies import study, study_scenes, study_variants
from .sweeps import Sweep, sweep

__all__ = [
    "Assembly", "BlocksError", "Deck", "DeckError", "DeckWarning", "Diagnostic", "FactorOfSafety", "FileError",
    "Frame", "History", "NotReadError", "Results", "Run", "RunWarning", "Simulation", "SimulationCards", "Solution",
    "Sweep", "Trial", "UnsoundRun", "__version__", "card_table", "check", "joints", "layers", "predicates", "read",
    "run", "study", "study_scenes", "study_variants", "sweep",
]


def __getattr__(name: str):
    if name == "plotting":  # needs Matplotlib
        import importlib
        return importlib.import_module(".plotting", __name__)
    raise AttributeError(f"module 'blocks' has no attribute '{name}'")
