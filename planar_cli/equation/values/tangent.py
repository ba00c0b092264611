"""What a nonlinear relation says to first order at a solution that is known: for what checks it by linear equations."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative, letters
from planar_cli.equation.values.exact import ZERO, Valuation
from planar_cli.records import record


@record
class Tangent:
    """constant + Σ slope · unknown, in numbers."""

    slopes: dict[sp.Symbol, Decimal]
    constant: Decimal


def tangent(expr: sp.Expr, there: Mapping[sp.Symbol, Decimal], value: Valuation) -> Tangent:
    """`expr` to first order where its unknowns have the values `there`; it vanishes there just where `expr` does."""
    numbers = value.extended(there)
    slopes = {x: numbers(derivative(expr, x)) for x in there if x in letters(expr)}
    return Tangent(slopes, numbers(expr) - sum((c * there[x] for x, c in slopes.items()), ZERO))
