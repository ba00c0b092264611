"""Where the motion of one regime starts: time, coordinates and speeds at the state from which it acts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from decimal import Decimal
from enum import Enum

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


class Start(Enum):
    """What the first state does not tell: some of its letters, or a start that contradicts the regime."""

    OPEN = 1
    CONTRADICTS = 2


def certain_start(course: Course) -> dict[sp.Symbol, Decimal] | Start:
    """The letters of the first state, where its own statements tell them all."""
    if course.regimes[0].moved():
        return Start.CONTRADICTS
    if course.sought():
        return Start.OPEN
    own = set(course.first.letters.values())
    branches = list(course.chain().branches([e for e in course.equations if e.stop == course.first.name]))
    for branch in branches:
        if own <= set(branch.values):
            return {s: branch.values[own] for s, own in course.first.letters.items()}
    return Start.OPEN if branches else Start.CONTRADICTS


def resting(course: Course, start: Mapping[sp.Symbol, Decimal]) -> frozenset[str]:
    """Free speeds that are zero at the start and that nothing sets in motion, whatever the others do."""
    idle = {u for u in course.regimes[0].free if not start[u]}
    while idle:
        zero = dict.fromkeys(idle, sp.S.Zero)
        moved = {u for u in idle for r in course.regimes if r.accelerations.get(u, sp.S.One).subs(zero) != 0}
        if not moved:
            return frozenset(u.name for u in idle)
        idle -= moved
    return frozenset()
