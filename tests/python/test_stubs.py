"""The type stubs have the names of the package, and everything has help and a repr."""

import ast
import inspect
from pathlib import Path

import pytest

import blocks
from blocks import _blocks
from blocks.documented import attributes_of

PACKAGE = Path(blocks.__file__).parent
GENERATOR = Path(__file__).parent / "deck_stub.py"


def names_in(body):
    """Returns the names that a module or class of a stub defines."""
    names = set()
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign):
            names.add(node.target.id)
    return names


def public(names):
    return {name for name in names if not name.startswith("__") and name != "predicates"}


def stub_of(name):
    return ast.parse((PACKAGE / name).read_text()).body


def test_stubs_have_all_names_and_no_others():
    body = stub_of("_blocks.pyi")
    assert public(names_in(body)) == public(vars(_blocks))
    for node in body:
        if isinstance(node, ast.ClassDef):
            assert public(names_in(node.body)) == public(vars(getattr(_blocks, node.name))), node.name
    assert names_in(stub_of("predicates.pyi")) == public(vars(_blocks.predicates))


def test_the_stubs_of_cards_are_those_of_the_card_table():
    scope = {"__name__": "deck_stub"}
    exec(GENERATOR.read_text(), scope)
    for name, text in scope["stubs"]().items():
        assert (PACKAGE / name).read_text() == text


def test_signatures_of_predicates_are_those_of_the_stub():
    for node in stub_of("predicates.pyi"):
        if isinstance(node, ast.FunctionDef):
            predicate = getattr(blocks.predicates, node.name)
            assert [*inspect.signature(predicate).parameters] == [argument.arg for argument in node.args.args]


@pytest.mark.parametrize("name", sorted(blocks.__all__))
def test_everything_public_has_help(name):
    thing = getattr(blocks, name)
    if isinstance(thing, str):
        return
    assert (inspect.getdoc(thing) or "").strip(), name
    if inspect.isclass(thing):
        for member, value in vars(thing).items():
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert (inspect.getdoc(value) or "").strip(), f"{name}.{member}"


def test_documented_attributes_exist(fall):
    """Every attribute that the docstring of a class names can be read."""
    layer = blocks.layers([(0, 0), (0, 1), (9, 1), (9, 0)], 3)
    made = {"Simulation": blocks.Simulation(fall), "Assembly": layer, "Deck": blocks.Deck()}
    for name, thing in made.items():
        attributes = attributes_of(getattr(blocks, name))
        assert len(attributes) > 8 or name == "Deck"
        for attribute in attributes:
            getattr(thing, attribute)
            if name != "Deck":
                assert inspect.getdoc(inspect.getattr_static(type(thing), attribute)), attribute
