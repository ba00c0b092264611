"""Whether the assumptions of a regime hold where it takes over."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.solve.course.events import SLACK, Leg, State, length_of
from planar_cli.solve.course.gaps import closes_at_once, openings
from planar_cli.solve.course.regime import Regime, number_function
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.stated_motion import StatedMotion
from planar_cli.solve.course.ways import becomes_negative

MOVES = 1e-7
"""A larger speed is one, in m/s or rad/s."""
LOOKS = 8
"""So often on a stretch it is seen whether forces that are not unique can be what is assumed of them."""


def objection(course: StatedMotion, i: int, regime: Regime, state: State, before: State, value: Valuation) -> str:
    """Why the assumptions of a regime do not hold where it begins at state i; "" when they do. `before`: the state in
    the letters of the regime before, `state` in its own.
    """
    found = _moves(course, regime, state, before, value) or _fails(regime, state, value)
    found = found or _slides_otherwise(regime, state, value) or _presses(course, i, regime, state, value)
    return found or (_impossible(regime, state, value) if regime.loose else "")


def handed_number(old: Regime, expr: sp.Expr, state: State, value: Valuation) -> float:
    """A letter of another regime in the motion of an old one."""
    return number_function([old.closed(expr)], list(state), value)(*state.values())[0]


def _numbers(regime: Regime, exprs: Sequence[sp.Expr], value: Valuation) -> Callable[..., list[float]]:
    return number_function(exprs, regime.letters, value)


def _moves(course: StatedMotion, regime: Regime, state: State, before: State, value: Valuation) -> str:
    """Does something move that the regime takes for held?"""
    handing = course.handings[id(regime)]
    for symbol, number in before.items():
        if symbol in regime.letters or symbol not in course.first.speeds or abs(number) <= MOVES:
            continue
        kept = handed_number(regime, handing[symbol], {**before, **state}, value) if symbol in handing else 0.0
        if _alone(symbol, regime) and abs(kept - number) > MOVES * max(1.0, abs(number)):
            return "it moves"
    return ""


def _alone(symbol: sp.Symbol, regime: Regime) -> bool:
    """Is a speed of the state not accounted for by the regime's own?"""
    twin = {r.name for r in regime.free}
    moving = (c for c in regime.coordinates if regime.rates[c.symbol] != 0)
    return symbol.name not in twin and not any(c.speed == symbol for c in moving)


def _fails(regime: Regime, state: State, value: Valuation) -> str:
    """The test of its modes that does not hold, or not for long."""
    here = [state[s] for s in regime.letters]
    values = _numbers(regime, [w.expr for w in regime.watches], value)(*here) if regime.watches else []
    for watch, v in zip(regime.watches, values, strict=True):
        if v < -SLACK * max(1.0, abs(v)):
            return watch.test.words
        if abs(v) <= SLACK and becomes_negative(regime, watch.expr, here, value):
            return watch.test.words
    return ""


def _slides_otherwise(regime: Regime, state: State, value: Valuation) -> str:
    """What speaks against a slip that is assumed."""
    here = [state[s] for s in regime.letters]
    for slip in regime.slips:
        speed = _numbers(regime, [slip], value)(*here)[0]
        if speed < -SLACK:
            return "it slides the other way"
        if abs(speed) <= SLACK and not _starts_to_slide(regime, slip, here, value):
            return "nothing makes it slide"
    return ""


def _starts_to_slide(regime: Regime, slip: sp.Expr, here: list[float], value: Valuation) -> bool:
    """Does the speed of slip grow from zero, at once or as the load grows?"""
    rate = regime.derivative(slip)
    first = _numbers(regime, [rate], value)(*here)[0]
    if abs(first) > SLACK:
        return first > 0
    return _numbers(regime, [regime.derivative(rate)], value)(*here)[0] > 0


def _presses(course: RegimeSequence, i: int, regime: Regime, state: State, value: Valuation) -> str:
    """What would press into its partner where it is taken for parted."""
    here = [state[s] for s in regime.letters]
    for opening, words in openings(course, i, regime):
        length = length_of(regime, state, [0.0] * len(here[1:]), value)
        if closes_at_once(regime, opening, here, value, length):
            return f"`{words}` does not hold"
    return ""


def _impossible(regime: Regime, state: State, value: Valuation) -> str:
    """The test that no distribution of forces that are not unique satisfies."""
    return regime.general.impossible({s: Decimal(repr(state[s])) for s in regime.letters}, value)


def demand_possible(regime: Regime, leg: Leg, until: float, value: Valuation) -> None:
    """NoSolution: forces that are not unique can not be what is assumed of them all along a stretch; when that ends is
    not told by them.
    """
    for k in range(1, LOOKS + 1) if regime.loose else ():
        words = _impossible(regime, leg.at(leg.t0 + (until - leg.t0) * k / LOOKS), value)
        if words:
            mark = regime.general.instant.scene.problem.find[0].mark
            text = f"forces are not unique, so that nothing tells when this ends: {words}"
            raise NoSolution([Diagnostic(mark, "PL603", text, "put a state where it ends, or leave a support out")])
