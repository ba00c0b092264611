"""What a small deviation makes of the forces and of the sums of forces at an equilibrium: to the first order.

    E(q, u) ≈ E_0 + ∂E/∂q δ + ∂E/∂u δ̇          of one freedom, at rest in the equilibrium

Only what is long in a general position is asked: the pull of an oblique spring, and sums of moments in which it stands.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.plain import longer, simplified
from planar_cli.solve.between.oscillation import Oscillation
from planar_cli.solve.between.oscillation_trace import LinearPart
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.solution import InstantSolution

LONG, ENDLESS = 30, 600
"""Shorter formulas are told as they are, longer ones are not differentiated."""
NOTHING = Decimal("1e-20")
"""A sum is zero in equilibrium up to this part of its terms."""


def linear_parts(course: RegimeSequence, found: Oscillation, value: Valuation) -> tuple[LinearPart, ...]:
    """Of the pulls and of the sums of forces of its regime, if one of them is long; else, or if one of the sums holds a
    reaction that nothing tells, nothing.
    """
    solution = found.regime.general.solution
    assert solution is not None
    stage = next((s for s in solution.stages if s.level == "acceleration"), None)
    if not found.single or stage is None:
        return ()
    sums, pulls = _sums(stage), dict(_pulls(solution, stage))
    told = {*pulls, *solution.instant.scene.ledger.definitions}
    reactions = set(solution.trial.system.symbols.values()) - told
    if not sums or any(e.free_symbols & reactions for e in sums):
        return ()
    exprs = [*pulls.values(), *sums]
    closed = [found.regime.closed(e) for e in exprs]
    if not any(longer(e, LONG) for e in closed) or any(longer(e, ENDLESS) for e in closed):
        return ()
    keys = [*pulls, *sums]
    parts = [_part(course, found, key, e) for key, e in zip(keys, closed, strict=True)]
    balanced = all(_vanishes(p.constant, value) for p in parts[len(pulls) :])
    return tuple(parts) if balanced else ()


def _sums(stage: Stage) -> list[sp.Expr]:
    """The left sides of the sums of forces and moments."""
    return [w.left for b in stage.blocks for w in b.equations if w.law in ("force", "moment")]


def _pulls(solution: InstantSolution, stage: Stage) -> Iterator[tuple[sp.Symbol, sp.Expr]]:
    """The named forces that stand in them."""
    ledger, inside = solution.instant.scene.ledger, set().union(*(e.free_symbols for e in _sums(stage)), set())
    for symbol, expr in ledger.definitions.items():
        if symbol in inside and ledger.units[symbol].text in ("N", "lbf"):
            yield symbol, expr


def _part(course: RegimeSequence, found: Oscillation, key: sp.Expr, closed: sp.Expr) -> LinearPart:
    (speed,) = found.speeds
    reader = course.readers[found.stop.name]
    still = dict.fromkeys(found.regime.free, sp.S.Zero)

    def at_rest(expr: sp.Expr) -> sp.Expr:
        there = simplified(found.stop.at(expr.xreplace({**still, **found.places})))
        own = there.free_symbols & set(found.stop.letters.values())
        # A constant that is sought keeps its letter: only places are put in.
        return simplified(there.xreplace({x: reader.settled(x) for x in own})) if own else there

    slope = sp.S.Zero
    for place, rate in found.regime.rates.items():
        if closed.has(place) and rate.has(speed):
            slope += sp.diff(closed, place) * sp.diff(rate, speed)
    return LinearPart(key, at_rest(closed), at_rest(slope), at_rest(sp.diff(closed, speed)))


def _vanishes(expr: sp.Expr, value: Valuation) -> bool:
    number = value.known(expr)
    return expr == 0 or (number is not None and abs(number) <= NOTHING * max(value.size(expr), Decimal(1)))
