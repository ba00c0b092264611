"""Where the motion of one regime starts: time, coordinates and speeds at the state from which it acts."""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.solve.course.course import Course
from planar_cli.solve.course.regime import Regime


def started(
    course: Course, regime: Regime, closed: Callable[[sp.Expr], sp.Expr], value: Valuation
) -> dict[sp.Symbol, sp.Expr]:
    """By the letters of the general position: a formula in the names of the file, else a number to all digits.

    `closed`: a letter of a state down to the names of the file.
    """
    first = next((i for i, r in enumerate(course.regimes) if r is regime), 0)
    stop = course.stops[course.states[min(first, len(course.states) - 1)].name] if course.states else course.first
    every = {own for s in course.stops.values() for own in s.letters.values()}
    found: dict[sp.Symbol, sp.Expr] = {}
    for letter in regime.letters:
        own = stop.letters[letter]
        formula = closed(own)
        if not formula.free_symbols & every:
            found[letter] = formula
            continue
        try:
            found[letter] = sp.Rational(str(value(own)))
        except (Unvalued, ArithmeticError):
            continue
    return found
