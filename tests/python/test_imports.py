"""No module of the package imports itself through others."""

import ast
from graphlib import TopologicalSorter
from pathlib import Path

import blocks

PACKAGE = Path(blocks.__file__).parent


def imports_of(path):
    """Returns the modules of the package that a module imports anywhere, in functions and for types too."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.level == 1:
            found.update([node.module.split(".")[0]] if node.module else [name.name for name in node.names])
    return {name for name in found if (PACKAGE / f"{name}.py").exists()}


def test_imports_have_no_circle():
    modules = {path.stem: imports_of(path) for path in PACKAGE.glob("*.py") if path.stem != "__init__"}
    assert sum(map(len, modules.values())) > 50
    TopologicalSorter(modules).prepare()  # raises CycleError, which names the modules
