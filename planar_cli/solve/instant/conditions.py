"""Decisions that rest on letters: what must be positive for the modes of an instant to hold."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from planar_cli.equation.common_factors import factor_terms
from planar_cli.equation.plain import longer
from planar_cli.problem.facts import Test
from planar_cli.solve.instant.instant import TINY, Trial

LONGEST = 60
"""A condition of more operations is not told."""


def conditions(trial: Trial, formulas: Callable[[list[sp.Expr]], list[sp.Expr]]) -> tuple[sp.Expr, ...]:
    """Expressions in letters of the file that are positive as the modes are assumed, and need not be. `formulas`:
    what expressions of the unknowns are in names of the file.
    """
    system, scene = trial.system, trial.system.scene
    if not scene.ledger.symbolic or not any(b.mass != 0 for b in scene.bodies.values()):
        return ()
    exprs = [e for mode in system.modes.values() for t in mode.tests if (e := _tested(trial, t)) is not None]
    if not exprs:
        return ()
    letters = set(scene.ledger.letters)
    told = [e for e in formulas(exprs) if e.free_symbols <= letters and not longer(e, LONGEST)]
    plain = [_without_factors(scene, e) for e in told]
    return tuple(scene.not_always_positive(e for e in plain if e.free_symbols))


def _tested(trial: Trial, test: Test) -> sp.Expr | None:
    """What is not negative in a test of forces that the equations determine, or of a slip that begins."""
    system, outcome = trial.system, trial.outcomes[0]
    if test.pushes and all(n in system.symbols and outcome.push(n) is not None for n, _ in test.pushes):
        return sp.Add(*(c * system.symbols[n] for n, c in test.pushes), sp.sympify(test.constant))
    if test.row is None or system.motion is None or abs(outcome.assembly.row_speed(test.row)) > TINY:
        return None
    return test.sense * system.motion.row_acceleration(test.row)


def _without_factors(scene: Any, expr: sp.Expr) -> sp.Expr:
    """The expression without the factors that are positive whatever the letters."""
    factors = sp.Mul.make_args(factor_terms(expr))
    doubtful = scene.not_always_positive(f for f in factors if f.free_symbols)
    signs = [sp.sign(f) for f in factors if f.is_number]
    return sp.Mul(*signs, *doubtful)
