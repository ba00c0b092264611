"""An unknown that some of the equations of a block tell together, though they do not tell each of theirs.

A crate that is about to slip at both of its edges: F_A = μ N_A, F_B = μ N_B, N_A + N_B = m g and F_A + F_B = m a give
a = μ g, whatever the two normal forces are. These follow from the moments, one at a time, once a is known.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import tidy
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record

FEWEST, LARGEST = 3, 8
"""Of so many equations at least, and at most."""
SMALL = Decimal("1e-30")

Row = list[Decimal]


@record
class Outright:
    """What is told: `unknown`, its `formula`, the places of the equations that tell it; and in which order the others
    follow, each by the equation at a place.
    """

    unknown: sp.Symbol
    formula: sp.Expr
    places: tuple[int, ...]
    others: tuple[tuple[sp.Symbol, int], ...]


def outright(
    residuals: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    value: Valuation,
    solved_for: Callable[[sp.Expr, sp.Symbol], sp.Expr],
) -> Outright | None:
    """The unknown that the fewest of the equations tell; None: each of them needs all.

    residuals: as many as `unknowns`, all linear. `solved_for(residual, x)`: x by an equation.
    """
    if not FEWEST < len(residuals) <= LARGEST:
        return None
    try:
        rows = [[value(linear_form(r, set(unknowns)).terms.get(x, sp.S.Zero)) for x in unknowns] for r in residuals]
    except Nonlinear:
        return None
    for i in reversed(range(len(unknowns))):
        places = _fewest(rows, i)
        if len(places) == len(rows):
            continue
        formula = _combined([residuals[p] for p in places], unknowns, unknowns[i], value, solved_for)
        others = _one_by_one(rows, unknowns, i)
        if formula is not None and others is not None:
            return Outright(unknowns[i], formula, tuple(places), others)
    return None


def _fewest(rows: Sequence[Row], target: int) -> list[int]:
    """The places of equations without which the unknown at `target` is not told."""
    kept = list(range(len(rows)))
    for place in range(len(rows)):
        fewer = [p for p in kept if p != place]
        if _tells([rows[p] for p in fewer], target):
            kept = fewer
    return kept


def _tells(rows: Sequence[Row], target: int) -> bool:
    """Is the unit row of the target a combination of these rows?"""
    unit = [Decimal(i == target) for i in range(len(rows[0]))] if rows else []
    return bool(rows) and _rank(rows) == _rank([*rows, unit])


def _rank(rows: Sequence[Row]) -> int:
    left, rank = [list(r) for r in rows], 0
    for j in range(len(left[0])):
        pivot = max(range(rank, len(left)), key=lambda i: abs(left[i][j]), default=None)
        if pivot is None or abs(left[pivot][j]) <= SMALL:
            continue
        left[rank], left[pivot] = left[pivot], left[rank]
        for row in left[rank + 1 :]:
            factor = row[j] / left[rank][j]
            row[:] = [a - factor * b for a, b in zip(row, left[rank], strict=True)]
        rank += 1
    return rank


def _combined(
    residuals: list[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    target: sp.Symbol,
    value: Valuation,
    solved_for: Callable[[sp.Expr, sp.Symbol], sp.Expr],
) -> sp.Expr | None:
    """The target by equations whose other unknowns are put in one after the other, until the rest of them cancels."""
    left = list(residuals)
    while len(left) > 1:
        x, place = next((x, i) for i, r in enumerate(left) for x in unknowns if x != target and x in r.free_symbols)
        put = {x: solved_for(left.pop(place), x)}
        left = [tidy(sp.expand(r.xreplace(put))) for r in left]
    form = linear_form(left[0], set(unknowns))
    if any(not value.is_zero(c) for x, c in form.terms.items() if x != target) or target not in form.terms:
        return None
    return tidy(-form.constant / form.terms[target])


def _one_by_one(
    rows: Sequence[Row], unknowns: Sequence[sp.Symbol], told: int
) -> tuple[tuple[sp.Symbol, int], ...] | None:
    """The other unknowns, each by an equation in which it is the only one left; None: some stay together."""
    known, found = {told}, list[tuple[sp.Symbol, int]]()
    while len(known) < len(unknowns):
        open_ = ((p, [j for j, c in enumerate(row) if abs(c) > SMALL and j not in known]) for p, row in enumerate(rows))
        step = next(((p, js[0]) for p, js in open_ if len(js) == 1), None)
        if step is None:
            return None
        known.add(step[1])
        found.append((unknowns[step[1]], step[0]))
    return tuple(found)
