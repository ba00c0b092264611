"""Curves as answers: the name of a curve with what belongs to it, its equation, and where that holds."""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.calculus.curve_words import CIRCLE, Curve
from planar_cli.report.blocks import Line, Math, Text
from planar_cli.report.notation import plain
from planar_cli.report.words import Phrases, rounded
from planar_cli.solve.passages import squared_radius
from planar_cli.units import LENGTH, TIME


def curve_line(curve: Curve, phrases: Phrases, hodograph: bool = False) -> Line:
    """The name of a curve, its equation with the units of its numbers, and where that holds. `hodograph`: it is one of
    velocities.
    """
    parts: list[Any] = [Text(curve.told(plain)), *_radius(curve, phrases, hodograph)]
    if curve.equation is not None:
        shown = squared_radius(curve.equation, curve.radius)
        parts += [Text(", "), phrases.math(curve.equation) if shown == curve.equation else Math(shown)]
        plain_numbers = _with_numbers(curve.equation, phrases)
        if plain_numbers is not None:
            parts += [Text(", that is "), plain_numbers]
        if not phrases.letters and curve.equation.rhs != 0:
            length = "ft" if phrases.ledger.us else "m"
            parts.append(Text(f" (velocities in {length}/s)" if hodograph else f" (lengths in {length})"))
    if curve.holds:
        parts.append(Text(f", {curve.holds}"))
    return tuple(parts)


def _radius(curve: Curve, phrases: Phrases, hodograph: bool) -> Line:
    """Of a circle its radius, with the number of one that is no plain number."""
    if not curve.kind.startswith(CIRCLE) or curve.radius is None:
        return ()
    formula = phrases.math(curve.radius)
    if phrases.letters:
        return (Text(" of radius "), formula)
    value = phrases.of_dimension(phrases.value(curve.radius), LENGTH / TIME if hodograph else LENGTH)
    return (Text(" of radius "), *(() if curve.radius.is_Rational else (formula, Text(" = "))), value)


def _with_numbers(equation: Any, phrases: Phrases) -> Math | None:
    """A curve with the numbers of all names put in; None where there are none, or letters without a number."""
    inside = [s for s in equation.free_symbols if s in phrases.ledger.values]
    if phrases.letters or not inside:
        return None
    numbers = {s: sp.Rational(str(phrases.value(s))) for s in inside}
    sides = [side.xreplace(numbers) for side in (equation.lhs, equation.rhs)]
    numeric = [rounded(sp.nsimplify(sp.N(s, 30), rational=True), phrases.figures) for s in sides]
    return Math(sp.Eq(*numeric, evaluate=False))
