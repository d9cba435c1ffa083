"""The pages about the Python package, their pictures, and the examples are executed.

BLOCKS_KEEP_PICTURES=1 copies the pictures that the gallery makes to docs/images.
"""

import contextlib
import importlib.util
import io
import json
import os
import re
import shutil
import subprocess
import sys
import warnings
from pathlib import Path

import pytest

import blocks

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot as plt

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/docs"))
from shown import missing_lines  # noqa: E402

PAGE = ROOT / "docs/python.md"
GALLERY = ROOT / "docs/python-gallery.md"
TUTORIAL = ROOT / "docs/tutorial.md"
EXAMPLES = ROOT / "examples/python"
FENCE = re.compile(r"^```(\S+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)
PICTURE = re.compile(r"!\[[^\]]+\]\(images/(python-[\w-]+\.(?:png|svg|gif))\)")
LARGEST_PICTURE = 300_000  # bytes


def has(module):
    return importlib.util.find_spec(module) is not None


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A temporary folder with a link to the decks, as the pages ask for. It is the current one."""
    (tmp_path / "decks").symlink_to(ROOT / "decks")
    monkeypatch.chdir(tmp_path)
    yield tmp_path
    plt.close("all")


def fences(text):
    """Returns the kind, the text and the line of each code block."""
    return [(match[1], match[3], text.count("\n", 0, match.start()) + 2) for match in FENCE.finditer(text)]


def printed_by(code, page, line, names):
    """Executes a code block and returns what it prints. Errors name the line of the page."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output), warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)  # examples are free of warnings of decks and of Matplotlib
        warnings.simplefilter("ignore", blocks.RunWarning)
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), names)
    return output.getvalue()


def execute(text, page, names, first_line=0):
    """Executes the code blocks of a text in order and compares the text blocks with what was printed."""
    printed, count = "", 0
    for kind, code, line in fences(text):
        if kind == "text":
            assert not missing_lines(code, printed), f"{page.name}:{first_line + line}: printed was\n{printed}"
            continue
        assert kind == "python", f"{page.name}:{first_line + line}: a block of kind {kind}"
        printed = printed_by(code, page, first_line + line, names)
        count += 1
    return count


def recipes():
    """Returns the title, the text and the first line of each recipe of the gallery."""
    text = GALLERY.read_text(encoding="utf-8")
    starts = [match.start() for match in re.finditer(r"^## ", text, re.M)] + [len(text)]
    return [pytest.param(text[begin:end], text.count("\n", 0, begin), id=text[begin + 3:end].split("\n")[0])
            for begin, end in zip(starts, starts[1:])]


def test_page(folder):
    assert execute(PAGE.read_text(encoding="utf-8"), PAGE, {"__name__": "__main__"}) > 20


@pytest.mark.parametrize("text, first_line", recipes())
def test_recipe(folder, text, first_line):
    """A recipe makes the picture that it shows, and prints what it shows."""
    assert execute(text, GALLERY, {"__name__": "__main__"}, first_line) == 1
    (name,) = PICTURE.findall(text)
    assert f'"{name}"' in text
    made, shown = folder / name, ROOT / "docs/images" / name
    assert made.stat().st_size > 5000
    if os.environ.get("BLOCKS_KEEP_PICTURES"):
        shutil.copy(made, shown)
    assert 5000 < shown.stat().st_size < LARGEST_PICTURE


def test_gallery_lists_its_recipes():
    text = GALLERY.read_text(encoding="utf-8")
    titles = re.findall(r"^## (.*)$", text, re.M)
    assert re.findall(r"^\| \[(.*?)\]", text, re.M) == titles
    assert len(titles) == 10 == len(set(PICTURE.findall(text)))
    pictures = {path.name for path in (ROOT / "docs/images").glob("python-*")}
    assert pictures == set(PICTURE.findall(text)), "pictures without a recipe"


def run_script(script, *words):
    """Runs an example as a user does, and returns what it prints."""
    done = subprocess.run([sys.executable, EXAMPLES / script, *words], check=False, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout
    return done.stdout


def test_servo(folder):
    printed = run_script("servo.py")
    assert printed.count("error +0.000 %") == 2  # those of the SERVO card
    closed, apart = map(float, re.search(r"closed by ([\d.]+) mm; the two plates differ by ([\d.]+) mm", printed).groups())
    assert closed == pytest.approx(6, abs=0.1) and apart < 0.1
    assert "1234567.0 N" in run_script("servo.py", "1234567")


@pytest.mark.skipif(not has("scipy"), reason="needs SciPy")
def test_slope_friction(folder):
    printed = run_script("slope_friction.py")
    assert "the block slides below 0.5773" in printed
    assert "means 23.00 degrees" in printed


def test_examples_are_on_the_page():
    text = PAGE.read_text(encoding="utf-8")
    for path in EXAMPLES.iterdir():
        if path.suffix in (".py", ".ipynb"):
            assert f"../examples/python/{path.name}" in text


def notebook():
    return json.loads((EXAMPLES / "tutorial.ipynb").read_text(encoding="utf-8"))["cells"]


def test_notebook_has_the_decks_of_the_tutorial_and_no_outputs():
    code = ["".join(cell["source"]) for cell in notebook() if cell["cell_type"] == "code"]
    for name, deck in re.findall(r"^```deck (\S+)\n(.*?)^```$", TUTORIAL.read_text(encoding="utf-8"), re.M | re.S):
        assert any(f'"""\\\n{deck}"""' in source for source in code), f"{name} differs"
    for cell in notebook():
        assert not cell.get("outputs") and cell.get("execution_count") is None


@pytest.mark.skipif(not (has("nbconvert") and has("ipykernel") and has("pandas")),
                    reason="needs nbconvert, ipykernel and pandas")
def test_notebook(folder):
    """The notebook runs, and prints the numbers of the tutorial."""
    environment = {**os.environ, "JUPYTER_PLATFORM_DIRS": "1", "PYDEVD_DISABLE_FILE_VALIDATION": "1",
                   "HOME": str(folder), "TMPDIR": str(folder)}
    environment.pop("MPLBACKEND", None)  # figures are outputs of their cells
    done = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute", "--output-dir", folder,
                           EXAMPLES / "tutorial.ipynb"], check=False, text=True, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout
    outputs = [output for cell in json.loads((folder / "tutorial.ipynb").read_text(encoding="utf-8"))["cells"]
               for output in cell.get("outputs", [])]
    printed = "".join("".join(output["text"]) for output in outputs if output["output_type"] == "stream")
    assert not [output for output in outputs if output.get("name") == "stderr"]
    shown = [text for kind, text, _ in fences(TUTORIAL.read_text(encoding="utf-8")) if kind == "text"]
    the_same = [text for text in shown if text.startswith(("wall.deck: no", "0.00 3.7500", "layer 1:", "cut 1:"))]
    assert len(the_same) == 4
    assert not [line for text in the_same for line in missing_lines(text, printed)], printed
    for line in ("<Run wall: done, 3727 steps, time 1.00006>", "<Run longer: done, 2237 steps, time 0.60025>",
                 "<Run push: done, 7454 steps, time 2.00012>", "worst overlap 0.000877471, 16 contacts",
                 "the lower joint of block 9 carries 19308.233 N",
                 "block 5 slides by 0.32 m, the brick above it by 0.11 m"):
        assert line in printed
    assert printed.count("same bits: True") == 2
    assert sum("image/png" in output.get("data", {}) for output in outputs) >= 5
