"""Expressions in the unknowns as rows of sixty-digit numbers, each worked out once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.form import Form, linear_form
from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.values.exact import ZERO, Valuation
from planar_cli.records import changing
from planar_cli.solve.multibody.linear import Row


@changing
class Numbers:
    """Expressions to rows of numbers: linear ones by their coefficients, others by their slopes at a generic place.

    `unknowns`: the columns. `linear`: those of them in which everything is linear; for the rest
    their slopes are taken. `value`: the valuation, in which every unknown has a generic number as well.
    """

    unknowns: tuple[sp.Symbol, ...]
    linear: frozenset[sp.Symbol]
    value: Valuation
    rows: dict[sp.Expr, Row] = field(default_factory=dict)

    def form(self, expr: sp.Expr) -> Form:
        return linear_form(expr, self.linear)

    def row(self, expr: sp.Expr) -> Row:
        """Coefficients of the unknowns and the constant, as numbers."""
        known = self.rows.get(expr)
        if known is None:
            known = self.rows[expr] = self._row(expr)
        return list(known)

    def without(self, idle: set[sp.Symbol], value: Valuation) -> Numbers:
        """The same numbers when some unknowns, all of them linear, are zero: their columns are left out. Slopes of
        what is not linear may have rested on them.
        """
        kept = [j for j, x in enumerate(self.unknowns) if x not in idle]
        whole = len(self.linear) == len(self.unknowns)
        rows = {expr: [*(row[j] for j in kept), row[-1]] for expr, row in self.rows.items()} if whole else {}
        return Numbers(tuple(self.unknowns[j] for j in kept), self.linear - idle, value, rows)

    def with_turning(self, row: Row, rows: Sequence[Row], parts: Sequence[sp.Expr]) -> Row:
        """The row of the sum of `rows`, each times one of `parts`: with the slopes of unknowns on which the direction
        rests and nothing else, as that of a sought angle in the sum of forces along a cord.
        """
        found = list(row)
        for j, x in enumerate(self.unknowns):
            if x in self.linear or found[j]:
                continue
            slopes = [self._slope(part, x) for part in parts]
            if any(slopes):
                found[j] = sum((self._total(r) * s for r, s in zip(rows, slopes, strict=True)), ZERO)
        return found

    def _total(self, row: Row) -> Decimal:
        """The value of what is linear in the unknowns, at their generic numbers; others stand in its constant."""
        linear = ((c, x) for c, x in zip(row, self.unknowns, strict=False) if c and x in self.linear)
        return row[-1] + sum((c * self.value(x) for c, x in linear), ZERO)

    def _row(self, expr: sp.Expr) -> Row:
        form = self.form(expr)
        row = [self._coefficient(form.terms.get(x)) for x in self.unknowns]
        constant = self._clean(form.constant)
        if len(self.linear) < len(self.unknowns):
            for j, x in enumerate(self.unknowns):
                if x not in self.linear:
                    row[j] = self._slope(expr, x)
        return [*row, constant]

    def _coefficient(self, expr: sp.Expr | None) -> Decimal:
        return ZERO if expr is None else self._clean(expr)

    def _clean(self, expr: sp.Expr) -> Decimal:
        value = self.value(expr)
        if value and abs(value) < Decimal("1e-20") and self.value.is_zero(expr):
            return ZERO
        return value

    def _slope(self, expr: sp.Expr, x: sp.Symbol) -> Decimal:
        """The exact derivative in numbers; a difference quotient would leave traces where terms cancel. Of what rests
        on the sign of x alone the derivative tells nothing: there the difference of both signs counts.
        """
        opened = opened_for(expr, x, self.value.definitions)
        if x not in opened.free_symbols:
            return ZERO
        slope = self._clean(derivative(opened, x))
        if slope:
            return slope
        rooted = opened.has(sp.Abs, sp.sign) or any(p.exp.is_Rational and p.exp.q == 2 for p in opened.atoms(sp.Pow))
        return self._clean(opened - opened.xreplace({x: -x})) if rooted else ZERO


def opened_for(expr: sp.Expr, x: sp.Symbol, definitions: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """The expression with those named intermediates put in that rest on x."""
    while True:
        inside = {s: definitions[s] for s in expr.free_symbols if rests_on(s, x, definitions)}
        if not inside:
            return expr
        expr = expr.xreplace(inside)


def rests_on(symbol: sp.Symbol, x: sp.Symbol, definitions: Mapping[sp.Symbol, sp.Expr]) -> bool:
    """Does a named intermediate rest on x, directly or through others?"""
    expr = definitions.get(symbol)
    return expr is not None and any(s == x or rests_on(s, x, definitions) for s in expr.free_symbols)


def exact_number(value: Decimal) -> sp.Expr:
    """All digits of a value as a rational."""
    return sp.Rational(str(value))
