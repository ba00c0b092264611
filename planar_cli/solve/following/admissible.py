"""Whether the assumptions of a regime hold where it takes over."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Unvalued, Valuation
from planar_cli.equation.scales import Here, measured
from planar_cli.errors import Diagnostic, NoSolution, NoValue
from planar_cli.solve.between.events import FollowedSegment, State
from planar_cli.solve.between.stated_motion import StatedMotion
from planar_cli.solve.following.gaps import closes_at_once, openings
from planar_cli.solve.regimes.directions import becomes_negative
from planar_cli.solve.regimes.regime import Regime, number_function
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

MOVES = 1e-7
"""A larger part of the speeds of a motion is a speed."""
LOOKS = 8
"""So often on a stretch it is seen whether forces that are not unique can be what is assumed of them."""


def objection(course: StatedMotion, i: int, regime: Regime, here: Here, old: Regime, before: State) -> str:
    """Why the assumptions of a regime do not hold where it begins at state i; "" when they do. `before`: the state in
    the letters of the `old` regime, `here` in its own.
    """
    found = _moves(course, regime, here, old, before) or _leaps(old, regime, here, before) or _fails(regime, here)
    found = found or _slides_otherwise(regime, here) or _presses(course, i, regime, here)
    return found or (_impossible(regime, here.letters, here.value) if regime.loose else "")


def transferred_number(old: Regime, expr: sp.Expr, state: State, value: Valuation) -> float:
    """A letter of another regime in the motion of an old one."""
    return number_function([old.closed(expr)], list(state), value)(*state.values())[0]


def _moves(course: StatedMotion, regime: Regime, here: Here, old: Regime, before: State) -> str:
    """Does something move that the regime takes for held, or rest that it takes along?"""
    transfer = course.transfers[id(regime)]
    for symbol, number in before.items():
        if symbol in regime.letters or symbol not in course.first.speeds:
            continue
        nothing = MOVES * here.sizes.get(symbol, 0.0)
        if abs(number) <= nothing and symbol not in old.letters:
            continue
        both = {**before, **here.letters}
        kept = transferred_number(regime, transfer[symbol], both, here.value) if symbol in transfer else 0.0
        if _alone(symbol, regime) and abs(kept - number) > max(nothing, MOVES * abs(number)):
            return "it moves"
    return ""


def _leaps(old: Regime, regime: Regime, here: Here, before: State) -> str:
    """Would a body be elsewhere, or move otherwise, in the regime than it was and did in the old one? No mode begins
    where it does not hold: a slack rope is not taut, what is apart does not press.
    """
    if old is regime or any(s not in before for s in old.letters):
        return ""
    for constraint in regime.general.constraints:
        # A turn more or less is no other place.
        if not constraint.residual.has(sp.atan2) and _differ([(constraint.residual, here), (sp.S.Zero, here)]):
            return "the places are others than it holds"
    there = Here({s: before[s] for s in old.letters}, here.sizes, here.value)
    scenes = [r.general.instant.scene.bodies for r in (old, regime)]
    for body in scenes[0]:
        places = [(b[body].center.x, b[body].center.y, b[body].theta) for b in scenes]
        for one, other in zip(*places, strict=True):
            if _differ([(one, there), (other, here)]):
                return f"{body} is elsewhere"
            rates = old.derivative(one), regime.derivative(other)
            if _differ([(rates[0], there), (rates[1], here)]):
                return f"{body} moves otherwise"
    return ""


def _differ(pairs: Sequence[tuple[sp.Expr, Here]]) -> bool:
    """Have two formulas, each in the letters of its own regime, different values? What has none does not tell."""
    try:
        (a, one), (b, other) = (measured([e], h.letters, h.sizes, h.value)[0] for e, h in pairs)
    except (NoValue, Unvalued):
        return False
    return abs(a - b) > MOVES * max(one, other)


def _alone(symbol: sp.Symbol, regime: Regime) -> bool:
    """Is a speed of the state not accounted for by the regime's own?"""
    twin = {r.name for r in regime.free}
    moving = (c for c in regime.coordinates if regime.rates[c.symbol] != 0)
    return symbol.name not in twin and not any(c.speed == symbol for c in moving)


def _fails(regime: Regime, here: Here) -> str:
    """The test of its modes that does not hold, or not for long."""
    signs = here.signs([w.expr for w in regime.watches]) if regime.watches else []
    for watch, sign in zip(regime.watches, signs, strict=True):
        if sign < 0 or (sign == 0 and becomes_negative(regime, watch.expr, here)):
            return watch.test.words
    return ""


def _slides_otherwise(regime: Regime, here: Here) -> str:
    """What speaks against a slip that is assumed."""
    for slip in regime.slips:
        sign = here.sign(slip)
        if sign < 0:
            return "it slides the other way"
        if sign == 0 and not _starts_to_slide(regime, slip, here):
            return "nothing makes it slide"
    return ""


def _starts_to_slide(regime: Regime, slip: sp.Expr, here: Here) -> bool:
    """Does the speed of slip grow from zero, at once or as the load grows?"""
    rate = regime.derivative(slip)
    sign = here.sign(rate) or here.sign(regime.derivative(rate))
    return sign > 0


def _presses(course: RegimeSequence, i: int, regime: Regime, here: Here) -> str:
    """What would press into its partner where it is taken for parted."""
    for opening, words in openings(course, i, regime):
        if closes_at_once(regime, opening, here):
            return f"`{words}` does not hold"
    return ""


def _impossible(regime: Regime, state: Mapping[sp.Symbol, float], value: Valuation) -> str:
    """The test that no distribution of forces that are not unique satisfies."""
    return regime.general.impossible({s: Decimal(repr(state[s])) for s in regime.letters}, value)


def demand_possible(regime: Regime, segment: FollowedSegment, until: float, value: Valuation) -> None:
    """NoSolution: forces that are not unique can not be what is assumed of them all along a stretch; when that ends is
    not told by them.
    """
    for k in range(1, LOOKS + 1) if regime.loose else ():
        words = _impossible(regime, segment.at(segment.t0 + (until - segment.t0) * k / LOOKS), value)
        if words:
            mark = regime.general.instant.scene.problem.find[0].mark
            text = f"forces are not unique, so that nothing tells when this ends: {words}"
            raise NoSolution([Diagnostic(mark, "PL603", text, "put a state where it ends, or leave a support out")])
