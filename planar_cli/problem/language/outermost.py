"""The quantities of which a find is made, and whether it is an energy."""

from __future__ import annotations

from typing import Any

from planar_cli.problem.language.expression import Quantity, Relation

ENERGIES = ("KE", "PE", "work", "heat")


def quantities_in(side: Any) -> list[Quantity]:
    """All quantities of a side or relation, the outermost."""
    if isinstance(side, Quantity):
        return [side]
    if isinstance(side, Relation):
        return quantities_in(side.left) + quantities_in(side.right)
    found: list[Quantity] = []
    for name in ("operand", "argument", "left", "right"):
        inner = getattr(side, name, None)
        if inner is not None and not isinstance(inner, str):
            found += quantities_in(inner)
    return found


def is_energy(what: Any) -> bool:
    """Does a find ask for an energy or for work, whose newton metre is a joule?"""
    return any(q.word in ENERGIES for q in quantities_in(what))
