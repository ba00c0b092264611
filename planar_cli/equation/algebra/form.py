"""Expressions that are linear in the unknowns, taken apart without expanding anything else."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import letters
from planar_cli.records import record


class Nonlinear(ValueError):
    """An unknown stands in a power, a function or a product with another unknown."""


@record
class Form:
    """constant + Σ coefficient · unknown; the coefficients hold no unknowns."""

    terms: dict[sp.Symbol, sp.Expr]
    constant: sp.Expr

    def expression(self) -> sp.Expr:
        return sp.Add(self.constant, *(c * x for x, c in self.terms.items()))


def linear_form(expr: Any, unknowns: Container[sp.Symbol]) -> Form:
    """Take `expr` apart. Raises Nonlinear where it is not linear in `unknowns`."""
    terms: dict[sp.Symbol, list[sp.Expr]] = {}
    constant: list[sp.Expr] = []
    _collect(sp.sympify(expr), sp.S.One, unknowns, terms, constant)
    return Form({x: sp.Add(*parts) for x, parts in terms.items()}, sp.Add(*constant))


def _collect(
    expr: sp.Expr,
    factor: sp.Expr,
    unknowns: Container[sp.Symbol],
    terms: dict[sp.Symbol, list[sp.Expr]],
    constant: list[sp.Expr],
) -> None:
    if not mentions(expr, unknowns):
        constant.append(factor * expr)
    elif expr.is_Symbol:
        terms.setdefault(expr, []).append(factor)
    elif expr.is_Add:
        for part in expr.args:
            _collect(part, factor, unknowns, terms, constant)
    elif expr.is_Mul:
        with_unknown = [a for a in expr.args if mentions(a, unknowns)]
        if len(with_unknown) > 1:
            raise Nonlinear(expr)
        rest = sp.Mul(factor, *(a for a in expr.args if a is not with_unknown[0]))
        _collect(with_unknown[0], rest, unknowns, terms, constant)
    else:
        raise Nonlinear(expr)


def mentions(expr: sp.Expr, unknowns: Container[sp.Symbol]) -> bool:
    """Does any of the unknowns occur in the expression?"""
    return any(s in unknowns for s in letters(expr))
