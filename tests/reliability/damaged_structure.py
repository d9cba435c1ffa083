#!/usr/bin/python3
"""Damages the structure of results files and checkpoints, and lets every reader open them:

    damaged_structure.py BLOCKS PYTHON_PACKAGE [FOLDER]

Each damage is of one object of a file: it is missing, has another type or shape, holds values that are out of
range, is a link or is stored elsewhere. Damaged checkpoints have a valid checksum. A reader succeeds if it does not
need the object. Otherwise it ends with exit code 5 and a message, in Python with FileError; or with exit code 2, if
another run could have written the file, and it has nothing to draw. A run that continues from
possible but absurd values may end as unsound, with exit code 4. It never crashes, hangs, or fails for want of memory.

A sample of the damages is tried, and of pairs of them; with BLOCKS_THOROUGH in the environment a large one. A file
that a reader does not survive is kept in FOLDER."""

import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

DECK = """\
START, 40, 8
BONDED BLOCKS ON A FLOOR THAT CRACK
XLIMITS, -9, 9
YLIMITS, -9, 9
BOXES, 9, 9
STIFF, 1.E7, 1.E7
FRACTION, 0.02
MATERIAL, 1, 1.E8, 4.E7, 2500, rock
MATERIAL, 2, 1.E8, 4.E7, 2500
FUNCTION, 2
0, 1
1.E30, 1
UNITS, m, kg, s
END
CREATE, 4, 1, 1
0, 0, 8, 8
-1, 0, 0, -1
CLOOP, 3, 1, 0
CREATE, 4, 1
1, 1, 2, 2
0, 1, 1, 0
CREATE, 4, 2
4, 4, 5, 5
0, 1, 1, 0
JOINT, 1, .5, 1.E5, 1.E5, .4
JPAIR, 1, 1, 1
JPAIR, 1, 2, 1
BOND
CRACK, 2, 1., .05
GRAVITY, 0, -9.81
FRICTN, 0.5
DAMPING, 0.2
SPLANE, 0, 1, 0, 0
SETVEL, 2, 0, 0, -1
FORCE, 5, 0, 1.E5
PLOTS, 0.004
HISTORY, 0.001, y:2, kinetic_energy, overlap
CYCLE, 40
STOP
"""
MEMORY = 4 << 30  # [bytes] of address space
SEAL = 512  # [bytes] of the header of a checkpoint
CPU = 60  # [s] of processor time after which a reader hangs
# Damages of each file, and commands that read each damaged file.
SAMPLE, READERS = (3000, 4) if os.environ.get("BLOCKS_THOROUGH") else (25, 2)

RESULTS = ["plot a.vtkhdf --forces -o p.png", "plot a.vtkhdf --colour bond -o p.svg",
           "plot a.vtkhdf --colour displacement --arrows velocity -o p.svg",
           "view a.vtkhdf -o v.html", "export a.vtkhdf -o e.pvd", "export a.vtkhdf -o e.csv",
           "export a.vtkhdf -o e.geojson", "why a.vtkhdf -b 1 -b 2", "history a.vtkhdf -o h.csv",
           "history a.vtkhdf -q y --profile top -o h.svg", "cracks a.vtkhdf", "cracks a.vtkhdf -o c.svg",
           "run a.deck -q --until 0.0001", "run a.deck -q --restart a.ckpt.h5 -o b"]
# What a sound file of another run may be answered with, too. Some damages are of this kind.
UNUSUAL = ("has changed its outline at time", "the profile meets no block", "no contact has the law of a joint",
           "has no cracks to draw")
CHECKPOINT = ["run a.deck -q --restart a.ckpt.h5 -o b", "check r.deck"]


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU, CPU))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def seal(path):
    """Writes the header and the checksum that fit a checkpoint."""
    whole = path.read_bytes()
    head, rest = whole[:SEAL], whole[SEAL:]
    value = 0xcbf29ce484222325
    for byte in rest:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    lines = head.split(b"\n")[:2] + [b"bytes %d" % len(rest), b"fnv1a %016x" % value, b""]
    path.write_bytes(b"\n".join(lines).ljust(SEAL, b"\0") + rest)


# Damages. Each takes the open file, the path of an object and a source of random numbers.

def again(file, path, **how):
    """Makes the dataset again with another property, without its attributes."""
    del file[path]
    return file.create_dataset(path, **how)


def missing(file, path, _):
    del file[path]


def group(file, path, _):
    del file[path]
    file.create_group(path)


def dataset(file, path, _):
    del file[path]
    file[path] = 7


def typed(make):
    def damage(file, path, _):
        old = file[path]
        again(file, path, data=np.zeros(old.shape, make(old.dtype)) if old.shape is not None else None,
              dtype=make(old.dtype))
    return damage


def words(file, path, _):
    shape = file[path].shape or ()
    again(file, path, shape=shape, dtype=h5py.string_dtype())


def vlen(file, path, _):
    shape = file[path].shape or ()
    again(file, path, shape=shape, dtype=h5py.vlen_dtype(np.int32))


def reference(file, path, _):
    shape = file[path].shape or ()
    again(file, path, shape=shape, dtype=h5py.ref_dtype)


def shaped(change):
    def damage(file, path, _):
        old = file[path]
        if old.dtype.kind == "O" or old.shape is None:
            return
        shape = change(old.shape)
        data = np.resize(old[()], shape) if old.size else np.zeros(shape, old.dtype)
        again(file, path, data=data)
    return damage


def no_space(file, path, _):
    again(file, path, dtype="i4", shape=None, data=h5py.Empty("i4"))


def huge(length):
    def damage(file, path, _):
        old = file[path]
        shape = (length, *old.shape[1:]) if old.shape else (length,)
        again(file, path, shape=shape, chunks=tuple(min(n, 64) for n in shape), dtype=old.dtype)
    return damage


def value(number):
    """Sets an element, or all elements, to a number."""
    def damage(file, path, rng):
        set_ = file[path]
        if set_.dtype.kind not in "iuf" or not set_.size:
            return
        data = set_[()]
        with np.errstate(all="ignore"):
            wrong = np.array(number).astype(set_.dtype)
        if data.shape and rng.random() < 0.7:
            data.flat[rng.randrange(data.size)] = wrong
        else:
            data = np.full(data.shape, wrong)
        set_[...] = data
    return damage


def external(file, path, _):
    old = file[path]
    shape = old.shape or (1,)
    again(file, path, shape=shape, dtype=old.dtype if old.dtype.kind != "O" else "i4",
          external=[("fifo", 0, h5py.h5f.UNLIMITED)])


def virtual(file, path, _):
    old = file[path]
    shape = old.shape or (1,)
    layout = h5py.VirtualLayout(shape, old.dtype if old.dtype.kind != "O" else "i4")
    layout[...] = h5py.VirtualSource("fifo", "there", shape)
    del file[path]
    file.create_virtual_dataset(path, layout)


def link(target):
    def damage(file, path, _):
        del file[path]
        file[path] = target(path)
    return damage


def ring(file, path, _):
    """The object is a hard link to the group that it is in."""
    del file[path]
    file[path] = file[path].parent if path in file else file[str(Path(path).parent)]


def unknown_filter(file, path, _):
    old = file[path]
    if not old.shape or old.dtype.kind == "O":
        return
    properties = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
    properties.set_chunk(tuple(max(1, n) for n in old.shape))
    properties.set_shuffle()
    properties.set_deflate(9)
    data, kind = old[()], h5py.h5t.py_create(old.dtype)
    space = h5py.h5s.create_simple(old.shape)
    del file[path]
    made = h5py.h5d.create(file.id, path.encode(), kind, space, dcpl=properties)
    made.write(h5py.h5s.ALL, h5py.h5s.ALL, data)
    address = made.get_chunk_info(0).byte_offset if data.size else None
    file.flush()
    if address is not None:  # the compressed bytes are damaged
        with open(file.filename, "r+b") as raw:
            raw.seek(address)
            raw.write(b"\xff" * 8)


def no_attribute(file, path, rng):
    names = list(file[path].attrs)
    if names:
        del file[path].attrs[rng.choice(names)]


def other_attribute(file, path, rng):
    names = list(file[path].attrs)
    if names:
        name = rng.choice(names)
        del file[path].attrs[name]
        file[path].attrs[name] = rng.choice([-1, 1e300, "x" * 100, np.zeros((3, 3)), h5py.Empty("f8")])


EITHER = {"missing": missing, "soft link": link(lambda path: h5py.SoftLink("/nowhere")),
          "link to itself": link(h5py.SoftLink), "link elsewhere": link(lambda path: h5py.SoftLink("/VTKHDF")),
          "external link": link(lambda path: h5py.ExternalLink("fifo", "/there")), "ring": ring,
          "no attribute": no_attribute, "other attribute": other_attribute}
OF_GROUP = {"dataset": dataset, "empty group": group}
OF_DATASET = {
    "group": group, "float": typed(lambda _: "f4"), "byte": typed(lambda _: "i1"), "unsigned": typed(lambda _: "u8"),
    "long double": typed(lambda _: np.longdouble), "big endian": typed(lambda _: ">i2"),
    "text": typed(lambda _: "S5"), "enumeration": typed(lambda _: h5py.enum_dtype({"A": 0, "B": 1})),
    "compound": typed(lambda kind: [("a", "f8"), ("b", "i4")]), "words": words, "vlen": vlen, "reference": reference,
    "array type": typed(lambda _: ("f8", (2,))),
    "scalar": shaped(lambda n: ()), "empty": shaped(lambda n: (0, *n[1:])),
    "one less": shaped(lambda n: (max(n[0] - 1, 0), *n[1:]) if n else (0,)),
    "one more": shaped(lambda n: (n[0] + 1, *n[1:]) if n else (2,)), "rank more": shaped(lambda n: (*n, 2)),
    "rank less": shaped(lambda n: n[:-1]), "wide": shaped(lambda n: (*n[:-1], n[-1] + 3) if n else (3,)),
    "rank 32": shaped(lambda n: (1,) * 32), "no space": no_space,
    "huge": huge(1 << 40), "large": huge(1 << 31), "largest": huge((1 << 63) - 1), "long": huge(3_000_000),
    "0": value(0), "-1": value(-1), "NaN": value(np.nan), "infinite": value(np.inf), "1e300": value(1e300),
    "least": value(-(1 << 63)), "greatest": value((1 << 63) - 1), "int": value((1 << 31) - 1), "9": value(9),
    "external": external, "virtual": virtual, "damaged chunk": unknown_filter,
}


def objects(path):
    """Returns the paths of all objects of a file and whether they are groups."""
    found = []
    with h5py.File(path) as file:
        file.visititems(lambda name, it: found.append((name, isinstance(it, h5py.Group))))
    return found


def all_damages(path):
    return [(name, kind) for name, is_group in objects(path)
            for kind in (*EITHER, *(OF_GROUP if is_group else OF_DATASET))]


def damage_of(kind):
    return EITHER.get(kind) or OF_GROUP.get(kind) or OF_DATASET[kind]


class Trial:
    """A folder with a sound run, and the readers."""

    def __init__(self, blocks, package, folder, kept):
        self.blocks, self.package, self.folder, self.kept = blocks, package, folder, kept
        self.failures = 0
        (folder / "a.deck").write_text(DECK)
        (folder / "r.deck").write_text("RESTART, a.ckpt.h5\nCYCLE, 1\n")
        subprocess.run([blocks, "run", "a.deck", "-q", "--stop-after", "30"], cwd=folder, check=False,
                       stdout=subprocess.DEVNULL)
        with h5py.File(folder / "a.vtkhdf") as file:
            assert len(file["BLOCKS/contacts/Corner"]) and len(file["BLOCKS/cracks"]), "nothing to damage"
        self.sound = folder / "sound"
        self.sound.mkdir()
        for name in ("a.vtkhdf", "a.ckpt.h5", "a.out", "a.summary.json"):
            shutil.copy(folder / name, self.sound)
        before = (folder / "a.ckpt.h5").read_bytes()
        seal(folder / "a.ckpt.h5")
        assert (folder / "a.ckpt.h5").read_bytes() == before, "checkpoints have another checksum"
        os.mkfifo(folder / "fifo")

    def restore(self):
        for path in self.folder.iterdir():
            if path.is_file() and path.suffix != ".deck":
                path.unlink()
        for path in self.sound.iterdir():
            shutil.copy(path, self.folder)

    def damage(self, name, damages, seed):
        """Damages a copy of a sound file. Returns False if the damages exclude each other."""
        self.restore()
        rng = random.Random(seed)
        try:
            with h5py.File(self.folder / name, "r+") as file:
                for path, kind in damages:
                    damage_of(kind)(file, path, rng)
        except (KeyError, ValueError, OSError, TypeError, RuntimeError, OverflowError):
            return False
        if name.endswith(".h5"):
            seal(self.folder / name)
        return True

    def fail(self, name, damages, command, why):
        self.failures += 1
        print(f"{name} with {damages}: {command}: {why}", flush=True)
        if self.kept:
            self.kept.mkdir(exist_ok=True)
            shutil.copy(self.folder / name, self.kept / f"{self.failures}-{name}")

    def read(self, name, damages, commands):
        # Runs come last, because they replace the files.
        for command in sorted(commands, key=lambda one: (one.startswith("run"), " -o b" not in one)):
            try:
                end = subprocess.run([self.blocks, *command.split()], cwd=self.folder, preexec_fn=limit, check=False,
                                     capture_output=True, text=True, errors="replace", timeout=600)
            except subprocess.TimeoutExpired:
                self.fail(name, damages, command, "hangs")
                continue
            told = end.stderr.strip()
            codes = (0,) if not damages else (0, 4, 5) if command.startswith("run") else (0, 5)
            if damages and any(words in told for words in UNUSUAL):
                codes = (2,)
            if end.returncode not in codes or (end.returncode == 5 and name not in told) or "std::" in told:
                self.fail(name, damages, command, f"exit code {end.returncode}: {told[-300:]}")

    def read_in_python(self, name, damages):
        """Reads everything in a child process, which has imported the package already."""
        child = os.fork()
        if child == 0:
            limit()
            code = 3
            try:
                os.chdir(self.folder)
                code = read_all(name)
            finally:
                os._exit(code)
        code = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        if code != 0:
            self.fail(name, damages, "blocks.read", f"exit code {code}")


def read_all(name):
    import warnings

    import blocks
    warnings.simplefilter("ignore")

    def attempt(action):
        try:
            action()
        except (blocks.FileError, blocks.DeckError, blocks.UnsoundRun, KeyError, AttributeError):
            pass  # KeyError and AttributeError: there is no such quantity
        return True

    if name.endswith(".h5"):
        attempt(lambda: blocks.Simulation("RESTART, a.ckpt.h5\nCYCLE, 1\n"))
        return 0
    try:
        results = blocks.read(name)
    except blocks.FileError:
        return 0
    for wanted in ("units", "title", "materials", "history", "cracks", "times", "steps"):
        attempt(lambda: getattr(results, wanted))
    attempt(lambda: results.history.names)
    try:
        frames = list(results)
    except blocks.FileError:
        return 0
    for frame in frames[:2] + frames[-1:]:
        for wanted in ("corners", "joint", "contacts", "displacement", "kinetic_energy", "parent", "stress", "polygons",
                       "is_removed", "cracks"):
            attempt(lambda: getattr(frame, wanted))
        attempt(lambda: frame.quantity("speed"))
        attempt(frame.to_geojson)
    return 0


def main():
    blocks, package = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
    kept = Path(sys.argv[3]).resolve() if sys.argv[3:] else None
    sys.path.insert(0, package)
    try:
        import blocks as python
        in_python = hasattr(python, "read")
    except ImportError as reason:
        print(f"without the Python package: {reason}")
        in_python = False
    rng = random.Random(1982)
    tried = 0
    with tempfile.TemporaryDirectory() as folder:
        trial = Trial(blocks, package, Path(folder), kept)
        trial.restore()
        for name, commands in (("a.vtkhdf", RESULTS), ("a.ckpt.h5", CHECKPOINT)):
            trial.read(name, [], commands)
            single = all_damages(trial.sound / name)
            chosen = [[one] for one in rng.sample(single, min(SAMPLE, len(single)))]
            chosen += [rng.sample(single, 2) for _ in range(SAMPLE // 5)]
            for damages in chosen:
                if not trial.damage(name, damages, tried):
                    continue
                tried += 1
                if in_python:
                    trial.read_in_python(name, damages)
                trial.read(name, damages, rng.sample(commands, min(READERS, len(commands))))
    print(f"{tried} inputs, {trial.failures} of them not refused as they should be")
    sys.exit(1 if trial.failures or not tried else 0)


if __name__ == "__main__":
    main()
