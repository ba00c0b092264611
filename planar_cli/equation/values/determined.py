"""What linear relations between unknowns determine of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.values.exact import Valuation

DIGITS = 40
"""Coefficients are told to so many digits."""
NOTHING = sp.Rational(1, 10**30)
"""A smaller number is none, after so many digits."""


def told_by(rows: Sequence[sp.Expr], unknowns: Sequence[sp.Expr], value: Valuation) -> set[sp.Expr]:
    """The unknowns that these relations between them determine."""
    columns = list(dict.fromkeys(unknowns))
    reduced = _reduced([*_coefficients(rows, columns, value)], len(columns))
    return {columns[p] for p, row in reduced if not any(c for j, c in enumerate(row) if j != p)}


def led_by(
    speed: sp.Symbol, rows: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], value: Valuation
) -> dict[sp.Symbol, sp.Rational]:
    """The unknowns that these relations between them make multiples of one of them, with the factors."""
    columns = [*(x for x in dict.fromkeys(unknowns) if x != speed), speed]
    last = len(columns) - 1
    reduced = _reduced([*_coefficients(rows, columns, value)], last)
    with_it = ((p, row) for p, row in reduced if not any(c for j, c in enumerate(row[:last]) if j != p))
    return {columns[p]: -row[last] for p, row in with_it}


def _reduced(rows: Sequence[list[sp.Rational]], width: int) -> list[tuple[int, list[sp.Rational]]]:
    """Gauss-Jordan elimination over the first columns: the pivots with their rows, each with 1 at its pivot. Of every
    row the largest number is taken, so that what only rounding leaves is never divided by.
    """
    found: list[tuple[int, list[sp.Rational]]] = []
    for row in rows:
        work = _clean(row)
        for p, other in found:
            work = _clean([a - work[p] * b for a, b in zip(work, other, strict=True)])
        p = max(range(width), key=lambda j: abs(work[j]), default=-1)
        if p < 0 or not work[p]:
            continue
        work = [a / work[p] for a in work]
        found = [(q, _clean([a - other[p] * b for a, b in zip(other, work, strict=True)])) for q, other in found]
        found.append((p, work))
    return found


def _clean(row: Sequence[sp.Rational]) -> list[sp.Rational]:
    return [sp.S.Zero if abs(a) < NOTHING else a for a in row]


def _coefficients(rows: Sequence[sp.Expr], columns: Sequence[sp.Expr], value: Valuation) -> Iterator[list[sp.Rational]]:
    """Of the rows in which the unknowns stand linearly."""
    for row in rows:
        try:
            terms = linear_form(row, set(columns)).terms
        except Nonlinear:
            continue
        found = [value.known(terms[c]) if c in terms else 0 for c in columns]
        if all(v is not None for v in found):
            yield [sp.Rational(f"{v:.{DIGITS}f}") if v else sp.S.Zero for v in found]
