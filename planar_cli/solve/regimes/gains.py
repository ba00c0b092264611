"""What a motion gains in speed: functions of time, place and speed of which a given expression is the rate.

A drag has no potential. But it is one of the forces of a law of motion, F = m a - B, so that its impulse is
m (v_2 - v_1) less that of the others, and its work along one coordinate 1/2 m (v_2² - v_1²) less theirs.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, longer, simplified
from planar_cli.solve.regimes.potential import LONG, potential
from planar_cli.solve.regimes.regime import Regime


def gained(rate: sp.Expr, regime: Regime) -> sp.Expr | None:
    """G(t, q, u) with dG/dt = rate along every motion of the regime; None: none was found.

    Of the places and the time alone where that does, else with multiples of speeds, or of squares of speeds.
    """
    placed = potential(rate, regime)
    if placed is not None or longer(rate, LONG):
        return placed
    rest, total = _in_terms(rate), sp.S.Zero
    for gain, change in _gains(regime):
        factor = _share(rest, change, regime)
        if factor is None:
            continue
        rest, total = expanded(rest - factor * change), total + factor * gain
        if all(_is_linear(term, regime) for term in sp.Add.make_args(rest)):
            placed = potential(simplified(rest), regime)
            return None if placed is None else sp.sympify(total + placed)
    return None


def _gains(regime: Regime) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """What may be gained, with its rate in terms: every free speed, and its square."""
    for speed, acceleration in regime.accelerations.items():
        yield speed, _in_terms(acceleration)
        yield speed**2, _in_terms(2 * speed * acceleration)


def _share(rate: sp.Expr, change: sp.Expr, regime: Regime) -> sp.Expr | None:
    """The constant by which a term of a rate of gain is one of `rate` that no place tells; None: there is none."""
    letters = set(regime.letters)
    terms, changes = sp.Add.make_args(rate), sp.Add.make_args(change)
    loose = [t for t in terms if not _is_linear(t, regime)]
    own_terms = [t for t in changes if not _is_linear(t, regime)]
    if not loose:
        # A force that depends on the place alone has no potential over the time: it is a part of a law of motion too.
        loose = [t for t in terms if t.has(*letters) and not t.has(*regime.free)]
        own_terms = [t for t in changes if t.has(*letters)]
    for own in own_terms if loose else ():
        ratios = (simplified(term / own) for term in loose)
        found = next((r for r in ratios if not r.free_symbols & letters), None)
        if found is not None:
            return found
    return None


def _is_linear(term: sp.Expr, regime: Regime) -> bool:
    """Is a term linear in the free speeds?"""
    slopes = (derivative(term, u) for u in regime.free if term.has(u))
    return not any(slope.has(*regime.free) for slope in slopes)


def _in_terms(expr: sp.Expr) -> sp.Expr:
    """Multiplied out, with v² √(v²) for (v²)^(3/2): what is a part of one term is seen to be one."""
    flat = expr.replace(
        lambda e: e.is_Pow and e.exp.is_Rational and e.exp.q == 2 and e.exp > 1,
        lambda e: e.base ** (e.exp - sp.S.Half) * sp.sqrt(e.base),
    )
    return expanded(flat)
