"""Where the motion of one regime starts: time, coordinates and speeds at the state from which it acts."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from decimal import Decimal
from enum import Enum
from functools import partial

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import CERTAIN, Valuation
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.following.gaps import just_parted
from planar_cli.solve.following.stillness import acted_on, resting
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.units import parse_unit


def started(
    course: RegimeSequence, regime: Regime, closed: Callable[[sp.Expr], sp.Expr], value: Valuation
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
        number = value.known(own)
        if number is not None:
            found[letter] = sp.Rational(str(number))
    return found


class Start(Enum):
    """What the first state does not tell: some of its letters, or a start that contradicts the regime."""

    OPEN = 1
    CONTRADICTS = 2


def certain_start(course: MotionEquations) -> dict[sp.Symbol, Decimal] | Start:
    """The letters of the first state, where its own statements tell them all."""
    if course.regimes[0].moved():
        return Start.CONTRADICTS
    if course.sought() or any(blow.scene.open_names for blow in course.blows.values()):
        return Start.OPEN
    found = _first_letters(course)
    whole = [letters for letters in found if len(letters) == len(course.first.letters)]
    return min(whole, key=partial(_negative, course)) if whole else Start.OPEN if found else Start.CONTRADICTS


def _negative(course: MotionEquations, start: Mapping[sp.Symbol, Decimal]) -> int:
    """How many coordinates that are lengths are negative: of places that fit the positive ones are meant."""
    places = (c for c in course.regimes[0].coordinates if not parse_unit(c.shown).angle)
    return sum(start.get(c.symbol, 0) < 0 for c in places)


def separated_start(course: MotionEquations) -> tuple[MotionEquations, dict[sp.Symbol, Decimal] | Start]:
    """The letters of the first state. What its own statements leave open of things that have just parted has no
    velocity apart; the equations have that then.
    """
    start = certain_start(course)
    for e in just_parted(course) if start is Start.OPEN else ():
        parted = replace(course, equations=(*course.equations, e), separations=(*course.separations, e))
        now = certain_start(parted)
        if now is not Start.CONTRADICTS:
            course, start = parted, now
    return course, start


def trial_start(course: MotionEquations, known: Valuation) -> dict[sp.Symbol, Decimal] | Start:
    """The letters of the first state with numbers of sought constants, which are among what is `known`."""
    equations = [e for e in course.equations if e.stop == course.first.name]
    chain = course.chain()
    branches = replace(chain, unknowns=chain.unknowns.difference(course.sought()), value=known).branches(equations)
    found = [{s: b.values[o] for s, o in course.first.letters.items() if o in b.values} for b in branches]
    whole = [letters for letters in found if len(letters) == len(course.first.letters)]
    return whole[0] if whole else Start.OPEN if found else Start.CONTRADICTS


def told_start(course: MotionEquations) -> dict[sp.Symbol, Decimal] | None:
    """The letters of the first state where it tells all of them in one way, whatever is sought besides."""
    if course.regimes[0].moved():
        return None
    found = [letters for letters in _first_letters(course) if len(letters) == len(course.first.letters)]
    return found[0] if len(found) == 1 else None


def _first_letters(course: MotionEquations) -> list[dict[sp.Symbol, Decimal]]:
    """The letters of the first state as far as they are told, one way after the other."""
    branches = course.chain().branches([e for e in course.equations if e.stop == course.first.name])
    return [{s: b.values[o] for s, o in course.first.letters.items() if o in b.values} for b in branches]


def resting_though_sought(course: MotionEquations) -> frozenset[str]:
    """The same where constants are sought, but the first state tells in one way what rests."""
    if course.blows or not course.sought() or course.regimes[0].moved():
        return frozenset()
    found = _first_letters(course)
    return resting(course, found[0]) if len(found) == 1 else frozenset()


def untold(course: RegimeSequence) -> bool:
    """Does nothing tell how the speeds change, as where nothing has mass and nothing drives?"""
    for regime in course.regimes:
        rates = {regime.general.rate_of(u) for u in regime.free}
        if any(f.free_symbols & rates for f in regime.accelerations.values()):
            return True
    return False


def balanced(course: StatedMotion, start: Mapping[sp.Symbol, Decimal]) -> frozenset[str]:
    """All free speeds, where the motion starts at rest in equilibrium: whatever acts, nothing changes any more."""
    value = course.base().extended(dict(start))
    for regime in course.regimes:
        changes = [*regime.rates.values(), *regime.accelerations.values()]
        if not regime.free or any(start.get(u, 1) for u in regime.free):
            return frozenset()
        if any(regime.time in e.free_symbols for e in changes) or not all(s in start for s in regime.letters):
            return frozenset()
        if not all(_vanishes(e, start, value) for e in regime.rates.values()):
            return frozenset()
        if regime.accelerations and acted_on(course, regime, set(regime.free), start):
            return frozenset()
    return frozenset(u.name for r in course.regimes for u in r.free)


def _vanishes(expr: sp.Expr, letters: Iterable[sp.Symbol], value: Valuation) -> bool:
    """Is a formula zero, as far as the digits of these letters tell?"""
    number = value.known(expr)
    if number is None:
        return False
    if expr == 0 or value.is_zero(expr):
        return True
    slopes = [(value.known(derivative(expr, s)), value(s)) for s in letters if s in expr.free_symbols]
    slack = sum((abs(slope * v) for slope, v in slopes if slope is not None), Decimal(0))
    return abs(number) <= CERTAIN * slack
