"""What the file states, beside the letter of the page that follows from it at once.

v_Px = 10 cos 45° = 7.071 m/s            a size and a direction
ω_1 = 15 rpm = 1.571 rad/s               another unit than that of the page
"""

from __future__ import annotations

from decimal import Decimal
from typing import Any, Protocol

import sympy as sp

from planar_cli.base_units import factor_to_base
from planar_cli.equation.values.exact import PI
from planar_cli.problem.language.expression import Name, Number, Quantity, Relation
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.polar import VectorStatement, grouped
from planar_cli.problem.scene.scene import Problem
from planar_cli.report.document.blocks import Line, Value, line
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.sides import AS_WRITTEN, number_of, said
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RouteTrace
from planar_cli.solve.between.trace.trace import Relation as MotionRelation
from planar_cli.units import parse_unit, pretty_unit

Stated = Relation | VectorStatement
NEAR, RIGHT_ANGLE = Decimal("1e-20"), 90


def stated_in(problem: Problem, state: str, words: str) -> Stated | None:
    """What the file says with these words, all the time or at a state ("": at its one instant)."""
    told: list[Tree] = [law.statement for law in problem.motion]
    told += [*(problem.instant or ())] if not state else []
    told += [r for s in problem.states if s.name == state for r in s.relations]
    for found in grouped(r for r in told if isinstance(r, Relation)):
        texts = [r.text for r in found.relations] if isinstance(found, VectorStatement) else [found.text]
        if words in (", ".join(texts), "; ".join(texts)):
            return found
    return None


def sentence(stated: Stated, figures: int) -> Line:
    """A relation of the file in the notation of the page; empty: it has no such form."""
    if not isinstance(stated, Relation):
        return ()
    left, right = said(stated.left, figures), said(stated.right, figures)
    return line(left, " = ", right) if left and right else ()


class Telling(Protocol):
    """Who tells a motion: what was found, and how it is said."""

    found: MotionTrace
    phrases: Phrases


def as_written(e: MotionRelation, telling: Telling, route: RouteTrace) -> tuple[Any, ...]:
    """A letter and the formula that the file states of it, where a number in it has a unit that would be swallowed:
    v_1 = √(K (1 + e)/(1 m · (1 - e))). Empty: it swallows none, or nothing is written so.
    """
    found, phrases = telling.found, telling.phrases
    residual = e.residual.xreplace(dict(route.plain)) if e.kind == "given" else sp.S.Zero
    (letter, *more) = residual.free_symbols & found.general.keys() or (None, None)
    stated = None if more else stated_in(found.problem, e.stop, e.words)
    if not isinstance(stated, Relation) or not isinstance(stated.left, Quantity) or sp.diff(residual, letter) != 1:
        return ()
    formula, side = letter - residual, stated.right
    if formula.is_number or not any(isinstance(n, Number) and n.unit is not None for n in walk(side)):
        return ()
    written = () if is_clean(phrases.ledger, letter, formula) else said(side, phrases.figures)
    return (phrases.math(letter), written) if written else ()


def between(stated: Stated | None, letter: sp.Symbol, value: Decimal, phrases: Phrases) -> Line:
    """What stands between a letter and its value; empty: nothing does, or it is more than this."""
    if isinstance(stated, VectorStatement):
        return _component(stated, letter, value, phrases)
    return () if stated is None else _converted(stated, letter, value, phrases)


def gives(stated: Stated, value: Decimal, phrases: Phrases) -> bool:
    """Does the file say a value itself, or its opposite, if in another unit?"""
    if isinstance(stated, VectorStatement):
        size, angle = (number_of(s) if s is not None else None for s in (stated.size, stated.angle))
        return angle is not None and not angle[0] % RIGHT_ANGLE and _is_near(in_base(size, phrases.ledger.us), value)
    if not isinstance(stated.left, Quantity | Name) or any(isinstance(n, Quantity) for n in walk(stated.right)):
        return False
    number = number_of(stated.right)
    return number is None or isinstance(stated.left, Name) or _is_near(in_base(number, phrases.ledger.us), value)


def _is_near(number: Decimal | None, value: Decimal) -> bool:
    return number is not None and abs(abs(number) - abs(value)) <= NEAR * (1 + abs(value))


def _component(stated: VectorStatement, letter: sp.Symbol, value: Decimal, phrases: Phrases) -> Line:
    """|v| cos of the angle, or its sine, whichever is the value."""
    size, angle = (number_of(s) if s is not None else None for s in (stated.size, stated.angle))
    whole, turn = in_base(size, phrases.ledger.us), in_base(angle, phrases.ledger.us)
    if size is None or angle is None or whole is None or turn is None or not value or angle[1] != "deg":
        return ()
    if not angle[0] % RIGHT_ANGLE:
        return ()
    exact = phrases.value
    upward = letter.name.partition("__")[0].endswith("y")
    parts = (("cos", sp.cos), ("sin", sp.sin))
    for name, function in parts[::-1] if upward else parts:
        part = whole * exact(function(sp.Rational(str(angle[0])) * sp.pi / 180))
        for sign in (1, -1):
            if abs(sign * part - value) <= Decimal("1e-12") * abs(value):
                shown = phrases.shown(letter, whole)
                degrees = f"{significant(angle[0], AS_WRITTEN)}°"
                told = f"({degrees})" if angle[0] < 0 else f" {degrees}"
                first = significant(shown.number, max(phrases.figures, AS_WRITTEN))
                return line(f"{'-' if sign < 0 else ''}{first} {name}{told}")
    return ()


def _converted(stated: Relation, letter: sp.Symbol, value: Decimal, phrases: Phrases) -> Line:
    """The number in the unit of the file, where the page has another."""
    number, shown = number_of(stated.right), phrases.shown(letter, value)
    found = in_base(number, phrases.ledger.us)
    if number is None or found is None or abs(found - value) > NEAR * (1 + abs(value)) or not value:
        return ()
    if number[1] == "1" or pretty_unit(number[1]) == pretty_unit(shown.unit):
        return ()
    return line(Value(number[0], number[1], max(phrases.figures, AS_WRITTEN)))


def in_base(number: tuple[Decimal, str] | None, us: bool) -> Decimal | None:
    """A number of the file in the base units of its page."""
    if number is None:
        return None
    unit = parse_unit(number[1])
    factor = factor_to_base(unit, us)
    return number[0] * Decimal(factor.numerator) / Decimal(factor.denominator) * PI**unit.pi_power


def root_of_size(stated: Stated, residual: sp.Expr, phrases: Phrases) -> tuple[sp.Expr, Decimal] | None:
    """The size of a vector that goes with one letter alone, |v_A|/4, and its value; None: it is no such thing."""
    size = number_of(stated.size) if isinstance(stated, VectorStatement) and stated.size is not None else None
    whole = in_base(size, phrases.ledger.us)
    if size is None or whole is None or len(residual.free_symbols) != 1:
        return None
    for sign in (1, -1):
        square = sp.sqrt(sp.expand(sign * residual + sp.Rational(str(whole)) ** 2))
        if square.has(sp.Abs) and not square.has(sp.Pow):
            return square, whole
    return None
