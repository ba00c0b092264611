"""Where an equilibrium is, before what happens near it: the acceleration is zero there, and the place follows.

k_2 (b - x_rest - l_2) - k_1 (x_rest - l_1) = 0:   x_rest = …,   then F_left = k_1 (x_rest - l_1)
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Name, Paragraph, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Request

LONGEST = 40
"""An equation of more operations is not told."""


@record
class EquilibriumPlace:
    """A find that is the place of an equilibrium: its formula, the letter of the state, and what vanishes there."""

    request: Request
    state: str
    letter: sp.Symbol
    formula: sp.Expr
    residual: sp.Expr


def equilibrium_places(found: MotionTrace) -> list[EquilibriumPlace]:
    """Those of one freedom that small oscillations are about."""
    places: list[EquilibriumPlace] = []
    for swing in found.oscillations:
        if len(swing.motion) != 1 or found.symbolic:
            continue
        ((_, law),) = swing.motion
        for request in found.requests:
            (formula, *more) = request.parts
            coordinates = [q for q in law.free_symbols & found.varying if request.find.name != q.name]
            if more or len(coordinates) != 1 or formula.is_Symbol or formula.is_number or request.unit is None:
                continue
            (q,) = coordinates
            there = law.xreplace({q: formula})
            if found.value.known(there) is None or not found.value.is_zero(there):
                continue
            letter = sp.Symbol(f"{q.name}__{swing.state}", real=True)
            residual = sp.fraction(law)[0].xreplace({q: letter})
            if found.value.known(letter) is not None and not longer(residual, LONGEST):
                places.append(EquilibriumPlace(request, swing.state, letter, formula, residual))
    return places


def place_blocks(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """The equation of each, and its solution."""
    for place in equilibrium_places(found):
        yield Paragraph(line(f"In the equilibrium {place.state} the acceleration is zero:"))
        yield Equation((phrases.math(place.residual), phrases.math(sp.S.Zero)))
        assert place.request.unit is not None
        (value, *others) = phrases.in_units(found.value(place.formula), place.request.unit, False)
        clean = is_clean(found.ledger, place.formula, dimension=place.request.unit.dimension)
        formula = [phrases.math(place.formula)] if clean else []
        own = line(Name(place.request.find.name))
        yield Equation((own, *formula, *phrases.substituted(place.formula, value), value, *others))


def by_places(found: MotionTrace) -> dict[sp.Expr, sp.Expr]:
    """The letters of such places, by the formulas for which they stand in what else is asked."""
    places = equilibrium_places(found)
    return {p.formula: p.letter for p in places} | {-p.formula: -p.letter for p in places}
