"""Released at rest exactly in an unstable equilibrium: what moves is the limit of ever slighter touches.

A touch of a thousand-millionth is followed in numbers; it tells what happens in which order, and the laws of energy
tell the speeds, which differ from their limits by the square of the touch alone. Only the times grow beyond all bounds.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.roots.events import length_of
from planar_cli.solve.following.stillness import resting
from planar_cli.solve.regimes.regime import Regime

SLIGHT = 1e-9
"""The touch in parts of a radian, or of the size of the scene, in the time in which it grows."""
GROWN = 0.1
"""Where it has come to in the same parts, the motion is no longer the touch."""
DEPARTS = "released at rest in an unstable equilibrium: the limit of a slight touch"


@record
class Departure:
    """The free speed that a departure begins with, and its value then."""

    speed: sp.Symbol
    value: Decimal
    grown: float
    """After what time it has grown so far that it is seen [s]."""


def departure_of(
    regime: Regime, base: Valuation, start: Mapping[sp.Symbol, Decimal], sense: int, idle: Collection[str]
) -> Departure | None:
    """What sends the motion off, of the free speeds that rest by themselves; None: their rest is not unstable, or in
    several ways. `regime`: the first; `base`: numbers of everything that is known.
    """
    value = base.extended(dict(start))
    found = []
    for u in (u for u in regime.free if u.name in idle):
        growth = _growth(regime, u, value)
        if growth > 0:
            found.append((u, growth))
    if len(found) != 1:
        return None
    u, growth = found[0]
    c = _coordinate(regime, u)
    assert c is not None
    state = {s: float(v) for s, v in start.items()}
    still = [0.0] * (len(regime.letters) - 1)
    size = (
        1.0
        if c.unit == "rad"
        else length_of(regime, state, still, value, regime.general.instant.scene.ledger.scales.length)
    )
    pace = math.sqrt(growth)
    slope = abs(float(value(derivative(regime.rates[c.symbol], u))))
    return Departure(u, Decimal(repr(sense * SLIGHT * pace * size / slope)), math.log(GROWN / SLIGHT) / pace)


def resting_until_struck(course: StatedMotion, start: Mapping[sp.Symbol, Decimal]) -> frozenset[str]:
    """Free speeds that rest by themselves from an unstable start on, where a blow follows: it may send them off, so
    they are not held.
    """
    regime, value = course.regimes[0], course.base().extended(dict(start))
    still = [u for u in regime.free if start.get(u) == 0 and u in regime.accelerations]
    return resting(course, start) if any(_growth(regime, u, value) > 0 for u in still) else frozenset()


def _coordinate(regime: Regime, u: sp.Symbol) -> Coordinate | None:
    """The coordinate that moves with a speed."""
    moved = [c for c in regime.coordinates if u in regime.rates[c.symbol].free_symbols]
    return next((c for c in moved if c.speed == u), moved[0] if moved else None)


def _growth(regime: Regime, u: sp.Symbol, value: Valuation) -> float:
    """How fast a deviation grows, d(du/dt)/dq dq/du in 1/s²; not positive where it does not."""
    c = _coordinate(regime, u)
    if c is None:
        return 0.0
    slope = derivative(regime.accelerations[u], c.symbol) * derivative(regime.rates[c.symbol], u)
    return float(value.known(slope) or 0)
