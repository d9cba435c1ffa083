"""Decks and places of the tests. The package and the program come from the build."""

import os
from pathlib import Path

import pytest

# Under the address sanitizer, only Python has to load it first: the program has its own.
PRELOADED = {"LD_PRELOAD": os.environ.pop("LD_PRELOAD")} if "asan" in os.environ.get("LD_PRELOAD", "") else {}

ROOT = Path(__file__).resolve().parents[2]

FALL = """\
START, 40, 4
BOXES FALL ON A FLOOR
XLIMITS, -2, 12
YLIMITS, -2, 12
BOXES, 14, 14, 0.25
STIFF, 1.E8, 1.E8
FRACTION, 0.05
MATERIAL, 1, 1.E9, 4.E8, 2500
RIGID
END
CREATE, 4, 1, 1
0, 0, 10, 10
-1, 0, 0, -1
CREATE, 4, 1
2, 2, 3, 3
0.1, 1.1, 1.1, 0.1
CREATE, 4, 1
2.2, 2.2, 3.2, 3.2
1.3, 2.3, 2.3, 1.3
GRAVITY, 0, -9.81
FRICTN, 0.5
DAMPING, 0.2
"""


@pytest.fixture
def fall():
    """Two boxes above a floor, without a motion."""
    return FALL


@pytest.fixture
def decks():
    """The folder of the decks."""
    return ROOT / "decks"


@pytest.fixture(scope="session")
def program():
    """The program `blocks` of this build."""
    return os.environ["BLOCKS_PROGRAM"]
