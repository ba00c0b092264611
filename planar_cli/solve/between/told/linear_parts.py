"""What a small deviation makes of the forces and of the sums of forces at an equilibrium: to the first order.

    E(q, u) ≈ E_0 + ∂E/∂q δ + ∂E/∂u δ̇          of one freedom, at rest in the equilibrium
    T = M δ̇²/2,  V = K δ²/2                     the energies, by which ω_0² = K/M

Of forces only what is long in a general position is asked: the pull of an oblique spring, and sums of moments in which
it stands.
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.solve.between.equations.oscillation import Oscillation
from planar_cli.solve.between.trace.oscillation_trace import LinearPart
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
    terms = (closed, _slope(found, closed), sp.diff(closed, speed))
    return LinearPart(key, *(_at_rest(course, found, e) for e in terms))


def _slope(found: Oscillation, closed: sp.Expr) -> sp.Expr:
    """∂E/∂δ: all coordinates that follow the freedom change with it."""
    (speed,) = found.speeds
    rates = {q: rate for q, rate in found.regime.rates.items() if closed.has(q) and rate.has(speed)}
    return sp.Add(*(sp.diff(closed, q) * sp.diff(rate, speed) for q, rate in rates.items()))


def _at_rest(course: RegimeSequence, found: Oscillation, expr: sp.Expr) -> sp.Expr:
    still = dict.fromkeys(found.regime.free, sp.S.Zero)
    there = simplified(found.stop.at(expr.xreplace({**still, **found.places})))
    # A constant that is sought keeps its letter: only places are put in.
    own, reader = there.free_symbols & set(found.stop.letters.values()), course.readers[found.stop.name]
    return simplified(there.xreplace({x: reader.settled(x) for x in own})) if own else there


def energies_near(course: RegimeSequence, found: Oscillation) -> tuple[sp.Expr, sp.Expr] | None:
    """The factors M and K of T = M δ̇²/2 and V = K δ²/2 near an equilibrium, from the balance of energy: the power of
    the loads at small speeds is -K δ δ̇. None: no such balance, or formulas without end.
    """
    balance = found.regime.balance if found.single else None
    if balance is None:
        return None
    (speed,) = found.speeds
    energy, power = (found.regime.closed(e) for e in balance)
    if longer(energy, ENDLESS) or longer(power, ENDLESS):
        return None
    force = sp.diff(power, speed).xreplace({speed: sp.S.Zero})
    mass, stiffness = sp.diff(energy, speed, 2), -_slope(found, force)
    return _at_rest(course, found, mass), _at_rest(course, found, stiffness)


def _vanishes(expr: sp.Expr, value: Valuation) -> bool:
    number = value.known(expr)
    return expr == 0 or (number is not None and abs(number) <= NOTHING * max(value.size(expr), Decimal(1)))
