"""Methods that are made from the table of cards, one for each card."""

from __future__ import annotations

import inspect
import keyword
from collections.abc import Callable, Iterable, Mapping
from typing import Any

__all__ = ["add_card_methods"]


def add_card_methods(cls: type, cards: Iterable[Mapping[str, Any]]) -> None:
    """Adds a method for each card to a class, with its fields as arguments.

    Args:
        cls: its method `card(name, *fields, lines=())` takes the words of a card; the methods return its result.
        cards: rows of `card_table()`.
    """
    for card in cards:
        setattr(cls, _name(card["name"]), _method_of(card, cls.__name__))


def _name(word: str) -> str:
    """Returns a name that Python allows for a card or a field."""
    name = "".join(letter if letter.isalnum() else "_" for letter in word.lower())
    return name + "_" if keyword.iskeyword(name) else name


def _text_of(card: Mapping[str, Any]) -> str:
    """Returns the docstring of the method of a card."""
    lines = [f"{card['summary']}", "", f"    {card['syntax']}"]
    lines += [f"    {line['syntax']}" for line in card["lines"]]
    if card["fields"] or card["lines"]:
        lines += ["", "Args:"]
    for field in card["fields"]:
        facts = [field["kind"]]
        if field["dimension"] not in ("", "[-]"):
            facts.append(field["dimension"])
        if field["range"]:
            facts.append(field["range"])
        if field["choices"]:
            facts.append(" or ".join(field["choices"]))
        if field["default"] is not None:
            facts.append(f"default {field['default'] or 'blank'}")
        lines.append(f"    {_name(field['name'])}: {field['help']} ({', '.join(facts)})")
    for line in card["lines"]:
        lines.append(f"    lines: {line['syntax']}: {line['help']}")
    if card["notes"]:
        lines += ["", card["notes"]]
    lines += ["", "Example:", *("    " + line for line in card["example"].splitlines())]
    return "\n".join(lines)


def _method_of(card: Mapping[str, Any], owner: str) -> Callable[..., Any]:
    """Returns the method of a card for the class with this name."""
    kinds = inspect.Parameter
    fields = card["fields"]
    repeats = bool(fields) and fields[-1]["repeats"]
    plain = fields[:-1] if repeats else fields
    parameters = [kinds("self", kinds.POSITIONAL_OR_KEYWORD)]
    is_optional = False
    for field in plain:
        # A field behind one with a default may be left out too; the check of the deck then says so.
        is_optional = is_optional or field["default"] is not None
        parameters.append(kinds(_name(field["name"]), kinds.POSITIONAL_OR_KEYWORD,
                                default=None if is_optional else kinds.empty))
    if repeats:
        parameters.append(kinds(_name(fields[-1]["name"]), kinds.VAR_POSITIONAL))
    if card["lines"]:
        parameters.append(kinds("lines", kinds.KEYWORD_ONLY, default=()))
    signature = inspect.Signature(parameters, return_annotation=owner)

    def add(*args: Any, **options: Any) -> Any:
        given = signature.bind(*args, **options)
        given.apply_defaults()
        values = dict(given.arguments)
        target = values.pop("self")
        lines = values.pop("lines", ())
        more = values.pop(_name(fields[-1]["name"])) if repeats else ()
        return target.card(card["name"], *values.values(), *more, lines=lines)

    add.__name__ = _name(card["name"])
    add.__qualname__ = f"{owner}.{add.__name__}"
    add.__doc__ = _text_of(card)
    add.__signature__ = signature
    return add
