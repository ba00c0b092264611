"""Constant acceleration along a curve on which a coordinate tells the place: v = v_0 + a t, v² = v_0² + 2 a s with the
arc length s = ∫ √(1 + y′²) dx between the places.

Source: An Introduction to Planar Dynamics, 1.3.1 (equations 1.20 and 1.25) with s for q, 1.4.2.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.calculus.antiderivative import definite
from planar_cli.calculus.spans import bound
from planar_cli.equation.algebra.plain import letters, simplified
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop

CONSTANT = "constant acceleration along the path"
ARC = "arc"
"""The kind of an equation that tells a length along a curve."""


def curve_equations(since: Stop, stop: Stop, regime: Regime, value: Valuation) -> Iterator[Equation]:
    """What a constant acceleration says of the speeds at two states on a curve."""
    varying = set(regime.letters)
    for speed, acceleration in regime.accelerations.items():
        found = _place(regime, speed)
        if found is None or letters(acceleration) & varying:
            continue
        c, pace = found
        v_0, v = since.letters[speed], stop.letters[speed]
        passed = stop.letters[regime.time] - since.letters[regime.time]
        family = ("curve", speed.name, stop.name)
        yield Equation(v - v_0 - acceleration * passed, "v(t)", CONSTANT, stop.name, since.name, family=(*family, "t"))
        x, start, end = bound(c.symbol), since.letters[c.symbol], stop.letters[c.symbol]
        inside = pace.xreplace({c.symbol: x})
        way = definite(inside, x, start, end, value)
        way = sp.Integral(inside, (x, start, end)) if way is None else way
        ledger = regime.general.instant.scene.ledger
        arc = ledger.once(f"s_{since.name}_{stop.name}", "m", way)
        told = "∫ √(r² + (dr/dθ)²) dθ" if c.unit == "rad" else "∫ √(1 + (dy/dx)²) dx"
        words = f"the length of the path of {c.words.split(' of ')[-1]}, {told}"
        yield Equation(arc - way, ARC, words, stop.name, since.name, family=(*family, ARC, arc.name), rank=1)
        square = v**2 - v_0**2 - 2 * acceleration * arc
        yield Equation(square, "v(q)", CONSTANT, stop.name, since.name, family=(*family, "s"))


def arc_lengths(equations: Iterable[Equation]) -> tuple[sp.Symbol, ...]:
    """The letters for lengths along curves."""
    told = [(s, e.family[-1]) for e in equations if e.kind == ARC for s in e.residual.free_symbols]
    return tuple(s for s, name in told if s.name == name)


def _place(regime: Regime, speed: sp.Symbol) -> tuple[Coordinate, sp.Expr] | None:
    """The coordinate of which the rate is this speed by a length that depends on it alone, and that length; None: the
    speed is in a constant ratio to the rate of one, or to none.
    """
    varying = set(regime.letters)
    for c in regime.coordinates:
        rate = regime.rates[c.symbol]
        pace = simplified(speed / rate) if rate.has(speed) else None
        if pace is not None and pace.free_symbols & varying == {c.symbol}:
            return c, pace
    return None
