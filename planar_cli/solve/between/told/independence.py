"""On which letters without a number a motion rests: a mass that cancels leaves every speed as it is.

What decides a motion is how its coordinates and speeds change, what the joints keep, how it begins, what its states
state and what happens in impacts. A letter enters one of these if its zeros move when the letter changes.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import CERTAIN, Sample, Valuation
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import NoValue
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.trace.derivation import Route

OTHERWISE = Decimal("1.7320508")
PLACES = 3


def rests_on(course: StatedMotion, value: Valuation, integrands: Iterable[sp.Expr] = ()) -> frozenset[sp.Symbol]:
    """The letters that were drawn and enter the motion, or one of these `integrands` over it."""
    if not isinstance(value, Sample):
        return frozenset()
    residuals = [*_residuals(course), *(_apart(e) for e in integrands)]
    base = course.base()
    return frozenset(p for p in value.drawn if any(_enters(p, e, base) for e in residuals))


def lettered_starts(course: MotionEquations, value: Valuation) -> frozenset[sp.Symbol]:
    """The letters of the first state of which it says something with a letter that was drawn."""
    drawn = value.drawn if isinstance(value, Sample) else frozenset()
    base, first = course.base(), {*course.first.letters.values()}
    told = (e.residual for e in course.equations if e.stop == course.first.name)
    found = (r.free_symbols & first for r in told if any(_enters(p, r, base) for p in drawn))
    return frozenset(s for inside in found for s in inside)


def settled(
    route: Route, value: Valuation, base: Valuation, lettered: frozenset[sp.Symbol] = frozenset()
) -> frozenset[sp.Symbol]:
    """The unknowns of a route whose numbers rest on no letter that was drawn. `base`: numbers of what is no unknown;
    `lettered`: what rests on such letters, and is no unknown of the route.
    """
    drawn = value.drawn if isinstance(value, Sample) else frozenset()
    unknowns = {x for step in route.steps for x in step.derivation.unknowns}
    # What an equilibrium told has a number: at the zero of its own equation nothing would show that a letter moves it.
    base = base.without(unknowns)
    found: set[sp.Symbol] = set()
    for step in route.steps:
        d = step.derivation
        known = all(s in found for s in d.needs & unknowns)
        known = known and not any(e.residual.free_symbols & (lettered - unknowns) for e in d.equations)
        # A speed that is stated with a letter is no unknown of the route: its letter stands in its place.
        residuals = [e.residual.xreplace(dict(route.plain)) for e in d.equations]
        if known and not any(_enters(p, r, base) for p in drawn for r in residuals):
            found |= set(d.unknowns)
    return frozenset(found)


def _residuals(course: StatedMotion) -> Iterator[sp.Expr]:
    """Everything that decides the motion, as expressions that vanish."""
    for regime in course.distinct_regimes():
        yield from map(_apart, (*regime.rates.values(), *regime.accelerations.values()))
        yield from (c.residual for c in regime.general.constraints)
        yield from (_apart(c.drawn) for c in regime.coordinates if c.drawn is not None)
    for demands in (*course.demands.values(), *course.placed.values()):
        yield from (d.residual for d in demands)
    yield from (expr for expr, _ in course.modes.turnings.values())
    for blow in course.blows.values():
        yield from (e.residual for e in blow.equations)


def _apart(expr: sp.Expr) -> sp.Expr:
    """What vanishes where a quantity has this value."""
    return sp.Dummy("value", real=True) - expr


def _inside(expr: sp.Expr, base: Valuation) -> set[sp.Symbol]:
    """The symbols of an expression and of what stands for its symbols, all the way down."""
    found: set[sp.Symbol] = set()
    left = set(expr.free_symbols)
    while left:
        symbol = left.pop()
        found.add(symbol)
        left |= sp.sympify(base.definitions.get(symbol, sp.S.Zero)).free_symbols - found
    return found


def _enters(letter: sp.Symbol, residual: sp.Expr, base: Valuation) -> bool:
    """Do the zeros of a residual move with the letter? They do not if it only scales the whole."""
    inside = _inside(residual, base)
    if letter not in inside:
        return False
    free = sorted(inside - set(base.values) - set(base.definitions), key=str)
    ratios = []
    for place in range(PLACES):
        here = base.extended({s: anywhere(place + PLACES * i) for i, s in enumerate(free)})
        other = here.extended({letter: here(letter) * OTHERWISE})
        try:
            one, two = here(residual), other(residual)
        except NoValue:
            return True
        if abs(one - two) > CERTAIN * max(here.size(residual), CERTAIN):
            ratios.append((one, two))
    first = ratios[0] if ratios else (Decimal(0), Decimal(0))
    return len(ratios) not in (0, PLACES) or any(
        abs(a * first[1] - b * first[0]) > CERTAIN * max(abs(a * first[1]), CERTAIN) for a, b in ratios
    )
