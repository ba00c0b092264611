"""Decisions that rest on letters: what must be positive for the modes of an instant to hold."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import longer
from planar_cli.records import record
from planar_cli.solve.instant.instant import TINY, Trial
from planar_cli.solve.instant.parting import parting
from planar_cli.solve.instant.worked import unknowns_of

if TYPE_CHECKING:
    from planar_cli.problem.scene.facts import Test
    from planar_cli.solve.instant.seeker import Sought

LONGEST = 60
"""A condition of more operations is left as it comes."""


Formulas = Callable[[list[sp.Expr]], list[sp.Expr]]
"""What expressions of the unknowns are in names of the file."""


@record
class Proviso:
    """What is `positive` as an answer is assumed to hold, and need not be; in `words`, where a formula is too long.

    It is 1 where there is no formula.
    """

    positive: sp.Expr
    words: str


def conditions(trial: Trial, formulas: Formulas) -> tuple[Proviso, ...]:
    """What must be positive, in letters of the file, for the modes of a trial."""
    system, scene = trial.system, trial.system.scene
    if not scene.ledger.symbolic or not any(b.mass != 0 for b in scene.bodies.values()):
        return ()
    tests = [t for mode in system.modes.values() for t in mode.tests]
    return _doubtful(scene, [(e, t.words) for t in tests if (e := _tested(trial, t)) is not None], formulas)


def conditions_beside(sought: Sought, formulas: Formulas) -> tuple[Proviso, ...]:
    """The same of a branch, for the assumptions that are not at their limit there, and for the sides on which places
    lie that what is sought moves.
    """
    trial, scene = sought.trial, sought.trial.system.scene
    if not scene.ledger.symbolic or not trial.outcomes or trial.system.reactions is None:
        return ()
    numbers = trial.outcomes[0].value.extended(unknowns_of(trial.system, trial.outcomes[0]))
    numbers = numbers.extended(sought.branch.algebra.value.values)
    values = {p.name: e for p, e in trial.system.reactions.pushes}
    told = [(e, "") for e in scene.decided_with(frozenset(scene.ledger.sought)) if (numbers.known(e) or 0) > TINY]
    for test in (t for mode in trial.system.modes.values() for t in mode.tests if t.pushes):
        if not all(n in values for n, _ in test.pushes):
            continue
        expr = sp.Add(*(c * values[n] for n, c in test.pushes), sp.sympify(test.constant))
        if (numbers.known(expr) or 0) > TINY:
            told.append((expr, test.words))
    return _doubtful(scene, told, formulas)


def _doubtful(scene: Any, told: list[tuple[sp.Expr, str]], formulas: Formulas) -> tuple[Proviso, ...]:
    """Those that are negative for some letters, without factors that are positive for all."""
    if not told:
        return ()
    letters = scene.ledger.known_letters()
    found: dict[sp.Expr, str] = {}
    for expr, (_, words) in zip(formulas([e for e, _ in told]), told, strict=True):
        if expr.free_symbols and expr.free_symbols <= letters:
            found.setdefault(expr if longer(expr, LONGEST) else without_factors(scene, expr), words)
    return tuple(Proviso(e, found[e]) for e in scene.not_always_positive(e for e in found if e.free_symbols))


def _tested(trial: Trial, test: Test) -> sp.Expr | None:
    """What is not negative in a test of forces that the equations determine, or of a slip or a lift that begins."""
    system, outcome = trial.system, trial.outcomes[0]
    if test.pushes and all(n in system.symbols and outcome.push(n) is not None for n, _ in test.pushes):
        return sp.Add(*(c * system.symbols[n] for n, c in test.pushes), sp.sympify(test.constant))
    if system.motion is not None and (apart := parting(system.motion, test)) is not None:
        return apart
    if test.row is None or system.motion is None or abs(outcome.assembly.row_speed(test.row)) > TINY:
        return None
    return test.sense * system.motion.row_acceleration(test.row)


def without_factors(scene: Any, expr: sp.Expr) -> sp.Expr:
    """The expression without the factors that are positive whatever the letters."""
    factors = sp.Mul.make_args(factor_terms(expr))
    doubtful = scene.not_always_positive(f for f in factors if f.free_symbols)
    signs = [sp.sign(f) for f in factors if f.is_number]
    return sp.Mul(*signs, *(_base(f) for f in doubtful))


def _base(factor: sp.Expr) -> sp.Expr:
    """What has the sign of a factor: of an odd power, its base."""
    odd = factor.is_Pow and factor.exp.is_Integer and factor.exp % 2 == 1
    return factor.base if odd else factor
