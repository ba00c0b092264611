"""Gaps of a drawing in words: by how much a point is off the line or the point where it should be."""

from __future__ import annotations

from typing import Any

from planar_cli.problem.language.expression import Name, Quantity, Relation
from planar_cli.problem.language.walk import walk


def gap(scene: Any, length: Any) -> str:
    """A length as drawn, with its unit; "" where letters are in it, or the scene knows no numbers yet."""
    numbers = getattr(scene, "valuations", ())
    if not numbers or scene.ledger.symbolic:
        return ""
    number = abs(float(numbers[0](as_first(scene, length))))
    return f"{number:.4g} {'ft' if scene.problem.us else 'm'}"


def as_first(scene: Any, length: Any) -> Any:
    """A length as drawn, or where the coordinates have the values that the first state gives them."""
    ledger, drawn = getattr(scene, "ledger", None), scene.as_drawn(length)
    if ledger is None or not scene.problem.states:
        return drawn
    told = {}
    for r in scene.problem.states[0].relations:
        plain = isinstance(r, Relation) and r.operator == "=" and isinstance(r.left, Name)
        if plain and not any(isinstance(node, Quantity) for node in walk(r.right)):
            told[ledger.symbols.get(r.left.name)] = scene.value(r.right)
    return drawn.xreplace({s: told[s] for s in ledger.coordinates if s in told})


def sought_in(scene: Any, length: Any) -> list[str]:
    """The constants and coordinates that are still sought, and on which a length as drawn depends."""
    ledger = getattr(scene, "ledger", None)
    if ledger is None:
        return []
    inside = as_first(scene, length).free_symbols
    moving = ledger.coordinates if scene.problem.states else ()
    return [s.name for s in dict.fromkeys((*ledger.sought, *moving)) if s in inside]
