"""The study of contact detection."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from . import _blocks
from ._blocks import study_scenes, study_variants
from .inputs import seed_of, whole
from .tables import table_of

__all__ = ["study", "study_scenes", "study_variants"]


def study(scenes: str | Sequence[str], variants: str | Sequence[str] = "default", *, frames: int = 20, first: int = 0,
          seed: int = 1982, steps: int = 0, threads: int = 1) -> Any:
    """Compares variants of the contact rule in scenes whose motion is known, as `blocks study contacts` does.

    Args:
        scenes: name of a scene, or several; see `study_scenes`.
        variants: name of a variant, or several; see `study_variants`.
        frames: number of random frames of reference.
        first: number of the first frame.
        seed: of the frames.
        steps: number of steps; 0: that of the scene.
        threads: does not change the results.

    Returns:
        A row for each scene and variant, as a pandas DataFrame if pandas is installed, otherwise as a
        structured array. Shares are from 0 to 1, with 95 % confidence limits `_low` and `_high`: `hang_ups`
        and `fall_throughs` (of the frames), `wrong_signs` of (19), `wrong_tangents` of (20), `phantom` and
        `missed` contacts; `speed_lost` and `energy_error` are means (docs/robustness.md).
    """
    names = [scenes] if isinstance(scenes, str) else list(scenes)
    rules = [variants] if isinstance(variants, str) else list(variants)
    counts = [whole(frames, "frames", 1, 2**31 - 1), whole(first, "first", 0, 2**31 - 1)]
    numbers = [seed_of(seed), whole(steps, "steps", 0), whole(threads, "threads", 1, 1024)]
    return table_of(_blocks._study(names, rules, *counts, *numbers))
