"""Many runs of one deck, with many seeds or values of its fields."""

from __future__ import annotations

import csv
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from .deck import quoted
from .errors import BlocksError, FileError
from .inputs import DeckLike, name_and_text, seed_of
from .results import Results, read
from .tables import table_of

__all__ = ["Sweep", "program", "sweep"]


def program() -> str:
    """The path of the program `blocks`: that of BLOCKS_PROGRAM, beside the package, or on PATH."""
    given = os.environ.get("BLOCKS_PROGRAM")
    built = Path(__file__).resolve().parent
    candidates = [given] if given else [Path(os.path.dirname(__file__)).parent.parent / "src" / "blocks",
                                        *(parent / "bin" / "blocks" for parent in built.parents),
                                        shutil.which("blocks")]
    for candidate in candidates:
        if candidate and os.access(candidate, os.X_OK) and not os.path.isdir(candidate):
            return os.fspath(candidate)
    raise FileError("the program `blocks` is missing; install the package blocks, or name it in BLOCKS_PROGRAM")


def _call(*words: str | os.PathLike, quiet: bool = True) -> int:
    """Calls the program. Raises BlocksError with its message if it fails."""
    done = subprocess.run([program(), *map(os.fspath, words)], check=False, text=True,
                          stdout=subprocess.DEVNULL if quiet else None, stderr=subprocess.PIPE)
    if done.returncode in (130, -2):
        raise KeyboardInterrupt
    if done.returncode != 0:
        raise BlocksError(done.stderr.strip() or f"blocks ended with code {done.returncode}")
    return done.returncode


class Sweep:
    """A sweep in its folder. `sweep` makes it; `Sweep(folder)` opens an older one.

    Attributes:
        folder: of all runs.
        plan: dict, the contents of sweep.json.
    """

    def __init__(self, folder: str | os.PathLike):
        self.folder = Path(folder)
        path = self.folder / "sweep.json"
        if not path.exists():
            raise FileError(f"{self.folder} is not the folder of a sweep: it has no sweep.json")
        self.plan: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))

    def __len__(self) -> int:
        return len(self.plan["runs"])

    def run_folder(self, run: int) -> Path:
        """The folder of a run, which is numbered from 1 as in the folder."""
        return self.folder / "runs" / f"{run // 1000:03}" / f"{run:06}"

    def outcome(self, run: int) -> dict[str, Any] | None:
        """How run `run`, from 1, ended: `code`, `status`, `message`; None if it has not."""
        path = self.run_folder(run) / "outcome.json"
        return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None

    def results(self, run: int) -> Results:
        """The results of run `run`, from 1."""
        files = sorted(self.run_folder(run).glob("*.vtkhdf"))
        if not files:
            raise FileError(f"run {run} has no results")
        return read(files[0])

    def table(self, quantities: Sequence[str] | str = ()) -> Any:
        """A row for each run: parameters, seed, exit code, message and values of quantities.

        Args:
            quantities: as for `blocks report`, such as "y:9", "speed:max" or "kinetic_energy"; none: what
                the report shows by itself.

        Returns:
            A pandas DataFrame if pandas is installed, otherwise a structured array.
        """
        names = [quantities] if isinstance(quantities, str) else list(quantities)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "runs.csv"
            options = [f"-q{','.join(names)}"] if names else []
            _call("report", self.folder, "--quiet", "-o", Path(folder) / "table.csv", "--run-table", path, *options)
            with path.open(newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        return table_of([{name: _number(value) for name, value in row.items()} for row in rows])

    def resume(self, *, jobs: int | None = None, retry: bool = False, quiet: bool = True) -> Sweep:
        """Goes on with the runs that have not ended; `retry`: also with those that failed. Returns the sweep."""
        _call("sweep", self.folder, *([f"-J{jobs}"] if jobs is not None else []), *(["--retry"] if retry else []),
              *(["-q"] if quiet else []), quiet=quiet)
        return self

    def __repr__(self) -> str:
        ended = sum(self.outcome(run) is not None for run in range(1, len(self) + 1))
        return f"<Sweep {self.folder}: {len(self)} runs, {ended} ended>"

    def _repr_html_(self) -> str:
        table = self.table()
        if hasattr(table, "to_html"):
            return table.to_html(max_rows=20, index=False)
        return f"<pre>{table}</pre>"


def _number(text: str) -> Any:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text if text else float("nan")


def _listed(value: Any) -> str:
    """Returns a value as one entry of a list of --set."""
    text = str(value)
    return quoted(text) if "," in text and not text.startswith(("'", '"')) else text


def sweep(deck: DeckLike, out: str | os.PathLike, *, seeds: Iterable[int] | str | None = None,
          set: Mapping[str, Any] | None = None, until: float | None = None, jobs: int | None = None,
          engine: str = "local", time_limit: float | None = None, quiet: bool = True) -> Sweep:
    """Runs a deck many times, as `blocks sweep` does. The same call goes on with what is missing.

    Each run is a process of its own with one thread. The engines parallel and slurm return as the command does.

    Args:
        deck: path, text or `Deck`. A text is kept in the folder as deck.deck.
        out: folder of the sweep.
        seeds: of the random layers, as numbers or as "1-200".
        set: for each field of a card a value or a list of values; all combinations are run.
        until: [T] time at which the runs end.
        jobs: runs at once; None: as many as there are processors.
        engine: 'local', 'parallel' or 'slurm'.
        time_limit: seconds after which a run ends.
        quiet: False: show the progress.

    Raises:
        BlocksError: with the message of the program, if the sweep cannot begin.
    """
    name, text = name_and_text(deck)
    if text is not None:
        folder = Path(out)
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{Path(name).stem}.deck"
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            if (folder / "sweep.json").exists():
                raise BlocksError(f"{folder} has a sweep of another deck")
            path.write_text(text, encoding="utf-8")
        name = os.fspath(path)
    words: list[str] = ["sweep", name, "-o", os.fspath(out), "--engine", engine]
    if seeds is not None:
        wanted = seeds if isinstance(seeds, str) else ",".join(str(seed_of(seed)) for seed in seeds)
        if not wanted:
            raise ValueError("there are no seeds")
        words += ["--seeds", wanted]
    for field, values in (set or {}).items():
        is_one = isinstance(values, str) or not isinstance(values, Iterable)
        several = [values] if is_one else list(values)
        if not several:
            raise ValueError(f"there are no values of {field}")
        words += ["--set", f"{field}={','.join(map(_listed, several))}"]
    for option, value in (("--until", until), ("-J", jobs), ("--time-limit", time_limit)):
        if value is not None:
            words += [option, str(value)]
    _call(*words, *(["-q"] if quiet else []), quiet=quiet)
    return Sweep(out)
