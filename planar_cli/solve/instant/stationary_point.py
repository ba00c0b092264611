"""Where a quantity is stationary that depends on unknowns through equations, with one freedom left.

Of all equations what is linear is eliminated; the quantity is stationary on what is left where the determinant vanishes
of the slopes of the equations left and of the quantity, taken for the unknowns left.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import at_state
from planar_cli.errors import Undecided

MOST = 4
LONGEST = 400


def unchanged(letters: Sequence[str], extreme: sp.Expr) -> str:
    """What an extreme means for the unknowns on which it depends; it is not one of them itself."""
    free = [x for x in letters if not extreme.is_Symbol or x != extreme.name]
    if len(free) == 1:
        return f"its derivative with respect to {free[0]} is zero"
    return f"it does not change with a small change of {', '.join(free)}" if free else "it is stationary"


def eliminated(
    residuals: Iterable[sp.Expr],
    objective: sp.Expr,
    unknowns: frozenset[sp.Symbol],
    kept: frozenset[sp.Symbol],
    sought: frozenset[sp.Symbol],
) -> tuple[list[sp.Expr], sp.Expr, list[sp.Symbol], sp.Expr]:
    """What is left of equations (given by their residuals) and objective, the unknowns in it, and the determinant that
    vanishes where the objective is stationary. `sought`: constants of the file, which all equations share. Undecided:
    more than one unknown is free, or too many are left.
    """
    pool = [p for p in residuals if p.free_symbols & unknowns]
    x_of = True
    while x_of:
        x_of = False
        for index, residual in enumerate(pool):
            x = _linear_in(residual, unknowns - kept)
            if x is None:
                continue
            slope = sp.diff(residual, x)
            formula = simplified(x - residual / slope) if not longer(residual, LONGEST) else x - residual / slope
            formula = expanded(formula) if x in formula.free_symbols else formula
            pool.pop(index)
            pool = [_put(p, x, formula) for p in pool]
            objective = _put(objective, x, formula)
            pool = [p for p in pool if p != 0]
            x_of = True
            break
    pool, objective = _without_data(pool, objective, unknowns)
    related = _related(pool, objective, unknowns)
    related = _binding(related, objective, unknowns - sought)
    letters = sorted({s for p in (*related, objective) for s in p.free_symbols if s in unknowns}, key=lambda s: s.name)
    if len(letters) != len(related) + 1 or len(letters) > MOST:
        named = f": {', '.join(at_state(s.name) for s in letters)}" if letters else ""
        raise Undecided(
            f"what is largest or smallest depends on several unknowns at once{named}; a datum may be missing"
        )
    rows = [[sp.diff(p, x) for x in letters] for p in (*related, objective)]
    condition = proper(simplified(sp.Matrix(rows).det(method="berkowitz")), unknowns)
    return related, objective, letters, condition


def _linear_in(residual: sp.Expr, candidates: frozenset[sp.Symbol]) -> sp.Symbol | None:
    """An unknown that enters linearly with a constant factor."""
    for x in sorted(residual.free_symbols & candidates, key=lambda s: s.name):
        slope = sp.diff(residual, x)
        if slope.is_number and slope != 0:
            return x
    for x in sorted(residual.free_symbols & candidates, key=lambda s: s.name):
        slope = sp.diff(residual, x)
        if x not in slope.free_symbols and slope != 0 and not slope.free_symbols & candidates:
            return x
    return None


def _put(expr: sp.Expr, x: sp.Symbol, formula: sp.Expr) -> sp.Expr:
    if x not in expr.free_symbols:
        return expr
    found = expr.xreplace({x: formula})
    return simplified(found) if not longer(found, LONGEST) else found


def _without_data(
    pool: list[sp.Expr], objective: sp.Expr, unknowns: frozenset[sp.Symbol]
) -> tuple[list[sp.Expr], sp.Expr]:
    """Times and constants that are known, put in; factors that vanish only at the start, dropped."""
    changed = True
    while changed:
        changed = False
        for index, residual in enumerate(pool):
            inside = [s for s in residual.free_symbols if s in unknowns]
            if len(inside) == 1 and sp.diff(residual, inside[0]).is_number:
                x = inside[0]
                formula = simplified(x - residual / sp.diff(residual, x))
                pool.pop(index)
                pool = [p for p in (_put(p, x, formula) for p in pool) if p != 0]
                objective = _put(objective, x, formula)
                changed = True
                break
    return [proper(p, unknowns) for p in pool], objective


def proper(residual: sp.Expr, unknowns: frozenset[sp.Symbol]) -> sp.Expr:
    """The factor of an equation that really relates unknowns: t (a t - b) = 0 at a later time."""
    numerator = sp.fraction(together(residual))[0]
    factors = [f for f in sp.Mul.make_args(factor_terms(factored(numerator))) if f.free_symbols & unknowns]
    proper = [f for f in factors if not f.is_Symbol and not (f.is_Pow and f.base.is_Symbol)]
    return sp.Mul(*proper) if proper and len(proper) < len(factors) else residual


def _related(pool: list[sp.Expr], objective: sp.Expr, unknowns: frozenset[sp.Symbol]) -> list[sp.Expr]:
    """The equations that reach the objective through shared unknowns."""
    reached = objective.free_symbols & unknowns
    found: list[sp.Expr] = []
    changed = True
    while changed:
        changed = False
        for p in pool:
            if p not in found and p.free_symbols & reached:
                found.append(p)
                reached |= p.free_symbols & unknowns
                changed = True
    return found


def _binding(pool: list[sp.Expr], objective: sp.Expr, unknowns: frozenset[sp.Symbol]) -> list[sp.Expr]:
    """Without equations that only tell an unknown of their own, as of a later state: they bind nothing else."""
    found = list(pool)
    while True:
        idle = next(
            (p for p in found if _tells_its_own(p, [objective, *(q for q in found if q is not p)], unknowns)), None
        )
        if idle is None:
            return found
        found = [p for p in found if p is not idle]


def _tells_its_own(residual: sp.Expr, others: list[sp.Expr], unknowns: frozenset[sp.Symbol]) -> bool:
    shared = set().union(*(other.free_symbols for other in others))
    return bool((residual.free_symbols & unknowns) - shared)
