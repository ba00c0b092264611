"""An angle of which an equation has the sine, cosine or tangent alone: cos β = -11.79/83.33 = -0.1414 before β."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.report.document.blocks import Equation, Line, Value, line
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.stages import Stage

NEAR = Decimal("1e-20")


def by_sine(x: SolvedLine, stage: Stage, lead: Line, phrases: Phrases) -> Equation | None:
    """The line before an angle that is told by its value alone; None where its one equation, residual = 0, holds the
    angle in another way, or is no quotient of numbers.
    """
    own = [w for b in stage.blocks for w in b.equations if w.number in x.equations]
    if phrases.symbolic or len(own) != 1:
        return None
    angle, whole = x.symbol, own[0].residual.xreplace(stage.algebra.explicit)
    held = [f for f in whole.atoms(sp.sin, sp.cos, sp.tan) if f.has(angle)]
    if len(held) != 1 or held[0].args[0] != angle:
        return None
    (function,) = held
    letter = sp.Dummy()
    put = whole.xreplace({function: letter})
    factor = sp.diff(put, letter)
    if put.has(angle) or factor.has(letter) or factor == 0:
        return None
    try:
        below, above = phrases.value(factor), -phrases.value(put.xreplace({letter: sp.S.Zero}))
        found = phrases.value(function)
    except (NoValue, Unvalued):
        return None
    if below < 0:
        below, above = -below, -above
    if not above or abs(above / below - found) > NEAR:
        return None
    one = significant(below, phrases.figures) == "1"
    quotient = line(f"{significant(above, phrases.figures)}/{significant(below, phrases.figures)}")
    return Equation((phrases.math(function), *(() if one else (quotient,)), Value(found, "")), None, lead)
