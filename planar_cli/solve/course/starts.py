"""Where the motion of one regime starts: time, coordinates and speeds at the state from which it acts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from decimal import Decimal
from enum import Enum

import sympy as sp

from planar_cli.equation.exact import CERTAIN, Unvalued, Valuation
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
    if course.sought() or any(blow.scene.open_names for blow in course.blows.values()):
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


def untold(course: Course) -> bool:
    """Does nothing tell how the speeds change, as where nothing has mass and nothing drives?"""
    for regime in course.regimes:
        rates = {regime.general.rate_of(u) for u in regime.free}
        if any(f.free_symbols & rates for f in regime.accelerations.values()):
            return True
    return False


def balanced(course: Course, start: Mapping[sp.Symbol, Decimal]) -> frozenset[str]:
    """All free speeds, where the motion starts at rest in equilibrium: whatever acts, nothing changes any more."""
    value = course.base().extended(dict(start))
    for regime in course.regimes:
        changes = [*regime.rates.values(), *regime.accelerations.values()]
        if not regime.free or any(start.get(u, 1) for u in regime.free):
            return frozenset()
        if any(regime.time in e.free_symbols for e in changes):
            return frozenset()
        try:
            if not all(_vanishes(e, start, value) for e in changes):
                return frozenset()
        except (Unvalued, ArithmeticError):
            return frozenset()
    return frozenset(u.name for r in course.regimes for u in r.free)


def _vanishes(expr: sp.Expr, letters: Iterable[sp.Symbol], value: Valuation) -> bool:
    """Is a formula zero, as far as the digits of these letters tell?"""
    if expr == 0 or value.is_zero(expr):
        return True
    inside = [s for s in letters if s in expr.free_symbols]
    slack = sum((abs(value(sp.diff(expr, s)) * value(s)) for s in inside), Decimal(0))
    return abs(value(expr)) <= CERTAIN * slack
