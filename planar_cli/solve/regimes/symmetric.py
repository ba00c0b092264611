"""Two bodies that begin alike and are driven alike move alike: balls that slide out of the middle of a turning tube.

If the equations of motion stay the same when q and ±p are exchanged, and so do the places and speeds of the first
state, then q = ±p at all times, since only one motion begins there.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping

import sympy as sp

from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop


def symmetric_equations(
    since: Stop, stop: Stop, regime: Regime, begun: Mapping[sp.Symbol, sp.Expr]
) -> Iterator[Equation]:
    """Pairs of coordinates that stay alike between two states. `begun`: what is known of letters of the first."""
    speeds = {c.symbol: u for c in regime.coordinates for u in regime.free if regime.rates[c.symbol] == u}
    sliding = [c for c in regime.coordinates if c.symbol in speeds and c.symbol in regime.letters]
    for p, q in itertools.combinations(sliding, 2):
        for sense in (1, -1):
            pairs = {q.symbol: sense * p.symbol, speeds[q.symbol]: sense * speeds[p.symbol]}
            alike = p.unit == q.unit and _begin_alike(since, pairs, begun, regime)
            if alike and _driven_alike(regime, pairs):
                words = _words(p, q)
                for n, (mine, other) in enumerate(pairs.items()):
                    residual = stop.letters[mine] - other.xreplace(stop.letters)
                    family = ("alike", str(n), q.symbol.name, stop.name)
                    yield Equation(residual, "link", words, stop.name, since.name, family=family, rank=1)
                break


def _words(p: Coordinate, q: Coordinate) -> str:
    return f"{q.body or q.words} moves as {p.body or p.words} does, by symmetry"


def _begin_alike(
    since: Stop, pairs: Mapping[sp.Symbol, sp.Expr], begun: Mapping[sp.Symbol, sp.Expr], regime: Regime
) -> bool:
    """Are places and speeds of the first state those of a motion in which both are alike?"""
    value = regime.general.value
    for mine, other in pairs.items():
        letters = {s: since.letters[s] for s in (mine, *other.free_symbols)}
        if not begun.keys() >= set(letters.values()):
            return False
        known = {s: begun[letter] for s, letter in letters.items()}
        if not value.is_zero(known[mine] - other.xreplace(known)):
            return False
    return True


def _driven_alike(regime: Regime, pairs: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Are all equations of motion the same after the exchange?"""
    exchange = dict(pairs)
    for mine, other in pairs.items():
        (theirs,) = other.free_symbols
        exchange[theirs] = mine * other.coeff(theirs)
    value = regime.general.value
    speeds = {c.symbol: regime.rates[c.symbol] for c in regime.coordinates}
    for own, rate in (*speeds.items(), *regime.accelerations.items()):
        (image,) = sp.sympify(exchange.get(own, own)).free_symbols
        sense = sp.sympify(exchange.get(own, own)).coeff(image)
        theirs = speeds.get(image, regime.accelerations.get(image))
        try:
            if theirs is None or not value.is_zero(rate.xreplace(exchange) - sense * theirs):
                return False
        except (NoValue, Unvalued):
            return False
    return True
