"""What linear relations between unknowns determine of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.form import Nonlinear, linear_form

DIGITS = 40
"""Coefficients are told to so many digits."""
NOTHING = sp.Rational(1, 10**30)
"""A smaller number is none, after so many digits."""


def told_by(rows: Sequence[sp.Expr], unknowns: Sequence[sp.Expr], value: Valuation) -> set[sp.Expr]:
    """The unknowns that these relations between them determine."""
    columns = list(dict.fromkeys(unknowns))
    matrix = sp.Matrix([*_coefficients(rows, columns, value)] or [[sp.S.Zero] * len(columns)])
    reduced, pivots = matrix.rref(iszerofunc=lambda x: abs(x) < NOTHING)
    width = range(len(columns))
    alone = ((i, p) for i, p in enumerate(pivots) if all(abs(reduced[i, j]) < NOTHING for j in width if j != p))
    return {columns[p] for _, p in alone}


def led_by(
    speed: sp.Symbol, rows: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol], value: Valuation
) -> dict[sp.Symbol, sp.Rational]:
    """The unknowns that these relations between them make multiples of one of them, with the factors."""
    columns = [*(x for x in dict.fromkeys(unknowns) if x != speed), speed]
    matrix = sp.Matrix([*_coefficients(rows, columns, value)] or [[sp.S.Zero] * len(columns)])
    reduced, pivots = matrix.rref(iszerofunc=lambda x: abs(x) < NOTHING)
    last = len(columns) - 1
    with_it = ((i, p) for i, p in enumerate(pivots) if all(abs(reduced[i, j]) < NOTHING for j in range(last) if j != p))
    return {columns[p]: -reduced[i, last] for i, p in with_it if p != last}


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
