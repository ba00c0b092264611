"""An angle from its sine: sin θ = formula = numbers = 0.4624, then θ itself, as it is worked out with a calculator."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Line, Value, line
from planar_cli.report.in_numbers.in_numbers import solved_for
from planar_cli.report.in_numbers.put_in import in_known
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.pieces import met
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import Result, RouteStep
from planar_cli.units import PURE

FEW, LONGEST = 3, 26
"""Of no more operations an inverse function stands in the line of the angle itself; of more its argument is not told
in letters.
"""
INVERSE = {sp.asin: sp.sin, sp.acos: sp.cos, sp.atan: sp.tan}


def by_function(
    r: Result, sides: tuple[sp.Expr, sp.Expr] | None, unknowns: Collection[sp.Symbol], phrases: Phrases
) -> tuple[Any, ...]:
    """sin θ = formula = numbers = value, where a formula has the inverse of one function; empty: it has not, or that is
    short. `sides`: of its equation, where that stands in numbers.
    """
    found = None if r.formula is None else _argument(r.formula)
    if found is not None and found[1].is_Rational and len(unknowns) > 1:
        return phrases.math(found[0](r.unknown)), phrases.math(found[1])
    if found is None or phrases.symbolic or not phrases.has_numbers(found[1]):
        return ()
    function, argument = found
    if not longer(argument, FEW) and sides is None:
        return ()
    value = Value(phrases.value(argument), "", phrases.figures)
    lead = phrases.math(function(r.unknown))
    solved = None if sides is None else _from_numbers(function(r.unknown), sides, unknowns, phrases)
    if solved is not None:
        return lead, solved, value
    if longer(argument, LONGEST):
        return ()
    if not is_clean(phrases.ledger, argument, dimension=PURE):
        own = {s for s in argument.free_symbols if "__" in s.name}
        known = in_known(argument, own, value, phrases)
        return (lead, *known, value) if known else ()
    return lead, phrases.math(argument), *phrases.substituted(argument, value), value


def by_tangent(residual: sp.Expr, r: Result, phrases: Phrases) -> tuple[Any, ...]:
    """tan(2 β) = -10/3 = -3.333, from a sin(2 β) + b cos(2 β) = 0 with numbers a, b; empty: it is another equation."""
    waves = residual.atoms(sp.sin, sp.cos)
    inside = {f.args[0] for f in waves}
    if phrases.symbolic or len(waves) != 2 or len(inside) != 1 or inside.pop().free_symbols != {r.unknown}:
        return ()
    (sine,), (cosine,) = ([f for f in waves if isinstance(f, kind)] for kind in (sp.sin, sp.cos))
    a, b = (sp.expand(residual).coeff(f) for f in (sine, cosine))
    if not (a.is_Rational and b.is_Rational and a != 0) or sp.expand(residual - a * sine - b * cosine) != 0:
        return ()
    ratio = -b / a
    if ratio.is_Integer:
        return phrases.math(sp.tan(sine.args[0])), phrases.math(ratio)
    return phrases.math(sp.tan(sine.args[0])), phrases.math(ratio), Value(phrases.value(ratio), "", phrases.figures)


def by_trial(leg: RouteStep, r: Result, sides: int, phrases: Phrases) -> Line:
    """That a root was found in numbers, beside a value (`sides` with its letter: two) without a formula, where its
    equation has more than powers of the unknowns.
    """
    if r.formula is not None or sides != 2 or any(e.span is not None for e in leg.relations):
        return ()
    unknowns = set(leg.unknowns)
    equations = [met(e.residual, phrases.value) for e in leg.relations]
    waves = [f for e in equations for f in e.atoms(sp.Function) if f.free_symbols & unknowns]
    return line("solved numerically") if waves else ()


def _argument(formula: sp.Expr) -> tuple[Any, sp.Expr] | None:
    """The function of which an angle is the inverse, and of what; None: it is more than that."""
    (inverse, *more) = formula.atoms(*INVERSE) or (None,)
    if inverse is None or more or formula.has(sp.atan2, sp.Piecewise):
        return None
    function = INVERSE[inverse.func]
    argument = function(formula)
    return None if argument.has(inverse) else (function, simplified(argument))


def _from_numbers(
    own: sp.Expr, sides: tuple[sp.Expr, sp.Expr], unknowns: Collection[sp.Symbol], phrases: Phrases
) -> Any:
    """The numbers that give a function of an angle, from an equation that is linear in it; None: it is not."""
    (angle,) = own.args
    letter = sp.Symbol("sine of the angle", real=True)
    put = [e.xreplace({own: letter}) for e in sides]
    if any(angle in e.free_symbols for e in put):
        return None
    known = replace(phrases, value=phrases.value.extended({letter: phrases.value(own)}))
    return solved_for(letter, (put[0], put[1]), [letter, *(u for u in unknowns if u != angle)], known)
