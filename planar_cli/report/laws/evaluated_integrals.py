"""What an integral over time of a law in numbers comes to, as a function of the time, into which the states are put.

∫[0 → y_L] dy_L = ∫[0 → t] 0.6 (1 - cos(π t/4)) dt,  y_L = 0.6 (t - 4 sin(π t/4)/π)   in m
y_L,1 = 0.6 (1 - 4 sin(π/4)/π) = 0.05981 m
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, Math
from planar_cli.report.given.as_stated import Telling
from planar_cli.report.in_numbers.put_in import Writer
from planar_cli.report.laws.laws import hides_units, integral_note, running
from planar_cli.report.notation.at_a_time import at_a_time
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, RouteTrace

LONGEST = 24
"""A longer function is left to its numbers."""
PLAIN = 60
"""Numbers up to this size are such as a person would write."""


def evaluated(
    e: Relation, sides: tuple[sp.Expr, ...], route: RouteTrace, telling: Telling, told: set[tuple[sp.Symbol, str]]
) -> list[Block] | None:
    """A place as a function of the time, by its integral from the time 0 on, once; None: it is told otherwise. `sides`:
    of the integral; `told`: the coordinates that were told so, with the states from which.
    """
    found, phrases = telling.found, telling.phrases
    own = _function(e, route, found, phrases)
    if own is None or e.law is None:
        return None
    letter, end, formula = own
    q, t = found.general[letter], found.general[end]
    if (q, e.since) in told:
        return []
    shown = _in_one_shape(formula, end, phrases, {end: t}) or _with_numbers(formula, end, t, phrases, e)
    limits = {i: i.limits[0][2] for side in sides for i in side.atoms(sp.Integral)}
    if not hides_units(shown) or set(limits.values()) != {letter, end} or len(limits) != len(sides):
        return None
    told.add((q, e.since))
    general = {
        i: sp.Integral(i.function, (*i.limits[0][:2], high.xreplace({letter: q, end: t}))) for i, high in limits.items()
    }
    integrals = [running(side.xreplace(general), {t, q}, phrases, e.law) for side in sides]
    note = integral_note(e.law, e.kind, [shown], phrases)
    return [Equation(tuple(integrals), None, (), note), Equation((phrases.math(q), shown), None, (), note)]


def by_its_function(e: Relation, route: RouteTrace, telling: Telling) -> tuple[Any, ...]:
    """letter = function at its time = value, in the shape in which the function is told; empty: it is not told so."""
    found, phrases = telling.found, telling.phrases
    own = _function(e, route, found, phrases)
    if own is None:
        return ()
    letter, end, formula = own
    shown = _in_one_shape(formula, end, phrases, {})
    put = None if shown is None else _put_in(shown, end, found)
    if put is None:
        return ()
    plain = not put.values and put.expr.doit().is_Rational
    return (phrases.math(letter), *(() if plain else (put,)), phrases.shown(letter, found.value(letter)))


def _function(
    e: Relation, route: RouteTrace, found: MotionTrace, phrases: Phrases
) -> tuple[sp.Symbol, sp.Symbol, sp.Expr] | None:
    """The place at the end of an integral over a law in numbers, the time there, and the place by it; None of a
    polynomial, where no term goes with the time itself, or where the motion does not begin at the time 0.
    """
    if e.span is None or e.span.kind != "q(t)" or e.span.explicit is None or phrases.symbolic:
        return None
    times = {own for own, general in found.general.items() if general.name == "t"}
    letter = next((s for s, general in found.general.items() if _is_end(s, general, e, found)), None)
    formula = sp.expand(simplified(e.span.explicit.xreplace(dict(route.plain))))
    ends = formula.free_symbols & times
    if letter is None or len(ends) != 1 or formula.is_polynomial(*ends) or longer(formula, LONGEST):
        return None
    (end,) = ends
    return None if formula.coeff(end, 1) == 0 else (letter, end, formula)


def _in_one_shape(
    formula: sp.Expr, end: sp.Symbol, phrases: Phrases, general: dict[sp.Symbol, sp.Symbol]
) -> Math | None:
    """0.6 (t - 4 sin(π t/4)/π): one number for all that is known before the time, and fractions of π behind it; None:
    other letters or numbers stand there.
    """
    steady = formula.coeff(end, 1)
    inside = sp.expand(formula / steady)
    numbers = inside.atoms(sp.Rational) if inside.free_symbols == {end} else {sp.oo}
    if any(n is sp.oo or max(abs(n.p), n.q) > PLAIN for n in numbers):
        return None
    writer = Writer({end}, phrases)
    return Math(sp.Mul(writer.number(steady), inside.xreplace(general), evaluate=False), writer.texts)


def _with_numbers(formula: sp.Expr, end: sp.Symbol, t: sp.Symbol, phrases: Phrases, e: Relation) -> Math:
    """The same with a number for all that is known, as 0.6 (t - 1.357 sin(0.7368 t))."""
    steady = formula.coeff(end, 1)
    whole = sp.Mul(steady, sp.expand(formula / steady), evaluate=False).xreplace({end: t})
    return running(whole, {t}, phrases, e.law)


def _put_in(shown: Math, end: sp.Symbol, found: MotionTrace) -> Math | None:
    """The same with its time put in."""
    number, inside = shown.expr.args
    there = at_a_time(inside, found)
    return None if there is None else Math(sp.Mul(number, there, evaluate=False), shown.values)


def _is_end(own: sp.Symbol, general: sp.Symbol, e: Relation, found: MotionTrace) -> bool:
    """Is it the letter of the coordinate of the law at the end of the relation?"""
    return e.law is not None and general == e.law.coordinate.symbol and found.ledger.roles[own].at == e.stop
