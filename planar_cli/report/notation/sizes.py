"""Sizes in formulas of a general position: |sin θ| is sin θ on the side where that is positive, which is assumed.

The side is that of the place at which the formulas were worked out and checked, so that there is such a place: nothing
that is never so is assumed.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution


def sizes_of(expr: sp.Expr, coordinates: Collection[sp.Symbol]) -> list[sp.Expr]:
    """What stands between bars and depends on coordinates alone: its sign is that of a side."""
    found = (e.args[0] for e in sp.sympify(expr).atoms(sp.Abs))
    return sorted((a for a in found if a.free_symbols and a.free_symbols <= set(coordinates)), key=str)


def on_one_side(expr: sp.Expr, coordinates: Collection[sp.Symbol], value: Valuation) -> sp.Expr:
    """The formula where all of that has the sign that it has with these numbers."""
    signs = {sp.Abs(a): p for a in sizes_of(expr, coordinates) if (p := positive_of(a, value)) is not None}
    return simplified(sp.sympify(expr).xreplace(signs)) if signs else expr


def positive_of(inside: sp.Expr, value: Valuation) -> sp.Expr | None:
    """It, or its opposite, whichever is positive with these numbers; None: it is nought, or has no number."""
    number = value.known(inside)
    if number is None or value.is_zero(inside):
        return None
    return inside if number > 0 else -inside


def with_signs(part: PartSolution) -> tuple[PartSolution, tuple[sp.Expr, ...]]:
    """A part whose answers have no such sizes, and what is positive then."""
    if part.motion is not None or part.followed is not None or not part.instants:
        return part, ()
    scene = part.instants[-1].instant.scene
    coordinates, value = set(scene.ledger.coordinates), scene.valuations[0]
    sizes = dict.fromkeys(a for f in part.found for e in _formulas(f) for a in sizes_of(e, coordinates))
    positive = dict.fromkeys(p for a in sizes if (p := positive_of(a, value)) is not None)
    if not positive:
        return part, ()
    found = tuple(
        replace(f, expressions=tuple(on_one_side(e, coordinates, value) for e in _formulas(f))) if _formulas(f) else f
        for f in part.found
    )
    return replace(part, found=found), tuple(positive)


def _formulas(found: Found) -> tuple[sp.Expr, ...]:
    """The closed formulas of an answer that has no number."""
    told = found.kind in ("number", "vector") and found.values is None and not found.word and found.curve is None
    return (found.expressions or ()) if told else ()
