"""Formulas whose numbers hold a unit: x = 0.5 m/tan θ, not 1/(2 tan θ), where the file gives 0.5 m as a number."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Name, Quantity
from planar_cli.report.document.blocks import Math
from planar_cli.report.notation.clean import Mixed, dimension_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import HELD
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.solve.solution import Found
from planar_cli.units import LENGTH, PURE, TIME, Dimension, pretty_unit

MISSING = (LENGTH, PURE / LENGTH, TIME, PURE / TIME, TIME / LENGTH, LENGTH / TIME)
"""Units that a number of a file may hold; a formula that lacks another one is no such product."""


ASKED = {"r": LENGTH, "x": LENGTH, "y": LENGTH, "rho": LENGTH, "v": LENGTH / TIME, "a": LENGTH / TIME**2, "t": TIME}
ANGLE = ("angle", "theta")
"""Parts of a vector that may be an angle."""


def asked_dimension(found: Found) -> Dimension | None:
    """Of a place, a velocity, an acceleration or a time that is asked in letters; None: it is another thing."""
    what = found.find.found.what if found.find is not None else None
    if isinstance(what, Name):
        return ASKED.get(what.name) if what.name == "t" else None
    if not isinstance(what, Quantity) or any(p.kind in ANGLE for p in what.parts):
        return None
    return ASKED.get(what.word)


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
    factor, rest = expr.as_independent(*expr.free_symbols, as_Add=False)
    own = sp.Symbol(HELD, positive=True)
    if missing == TIME / LENGTH:
        # D/(50 m/s), the speed that the file gives, rather than 0.02 s/m.
        speed = significant(Decimal(str(sp.N(abs(1 / factor), 30))), figures)
        text = f"{speed} {pretty_unit(coherent_unit(LENGTH / TIME).text)}"
        return Math(sp.sign(factor) * rest / own, {own: text})
    # The number itself, as the file gives it: 2 in the denominator of 1/(2 tan θ) is 0.5 m.
    shown = significant(Decimal(str(sp.N(abs(factor), 30))), figures)
    unit = pretty_unit(coherent_unit(missing).text)
    text = f"{shown}{unit[1:]}" if unit.startswith("1/") else f"{shown} {unit}"
    return Math(sp.sign(factor) * own * rest, {own: text})


def with_its_number(expr: sp.Expr) -> tuple[sp.Expr, dict[sp.Symbol, Decimal]]:
    """A product with a letter for its number, and that number: 0.5/tan θ, not 1/(2 tan θ)."""
    factor, rest = expr.as_independent(*expr.free_symbols, as_Add=False)
    own = sp.Symbol(HELD, positive=True)
    return sp.sign(factor) * own * rest, {own: Decimal(str(sp.N(abs(factor), 30)))}


def swallowed(expr: sp.Expr, found: Found, ledger: Ledger, figures: int) -> Math | None:
    """An answer in letters whose number holds a unit, with that; None: its letters make the unit."""
    dimension = asked_dimension(found)
    return None if dimension is None else with_unit(expr, dimension, ledger, figures)
