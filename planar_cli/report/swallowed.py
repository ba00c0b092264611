"""Formulas whose numbers hold a unit: x = 0.5 m/tan θ, not 1/(2 tan θ), where the file gives 0.5 m as a number."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.ledger import Ledger
from planar_cli.report.blocks import Math
from planar_cli.report.clean import Mixed, dimension_of
from planar_cli.report.numbers import significant
from planar_cli.report.ordering import NUMBER
from planar_cli.report.page_units import coherent_unit
from planar_cli.units import LENGTH, PURE, TIME, Dimension, pretty_unit

MISSING = (LENGTH, PURE / LENGTH, TIME, PURE / TIME, TIME / LENGTH, LENGTH / TIME)
"""Units that a number of a file may hold; a formula that lacks another one is no such product."""


def with_unit(expr: sp.Expr, dimension: Dimension, ledger: Ledger, figures: int) -> Math | None:
    """A product with its number and the unit that this holds; None: its letters make the unit, or it is no product."""
    if expr == 0 or expr.is_number or expr.is_Add or ledger.us or not expr.free_symbols <= set(ledger.units):
        return None
    try:
        missing = dimension / dimension_of(expr, ledger)
    except Mixed:
        return None
    if missing not in MISSING:
        return None
    factor, rest = expr.as_coeff_Mul()
    # The number itself, as the file gives it: 2 in the denominator of 1/(2 tan θ) is 0.5 m.
    shown = significant(Decimal(str(sp.N(abs(factor), 30))), figures)
    unit = pretty_unit(coherent_unit(missing).text)
    own = sp.Symbol(f"{NUMBER}unit", positive=True)
    text = f"{shown}{unit[1:]}" if unit.startswith("1/") else f"{shown} {unit}"
    return Math(sp.sign(factor) * own * rest, {own: text})


def with_its_number(expr: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, Decimal]]:
    """A product with a letter for its number, and that number: 0.5/tan θ, not 1/(2 tan θ)."""
    factor, rest = expr.as_coeff_Mul()
    own = sp.Symbol(f"{NUMBER}unit", positive=True)
    return sp.sign(factor) * own * rest, {own: Decimal(str(sp.N(abs(factor), 30)))}
