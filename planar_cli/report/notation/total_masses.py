"""Masses that go together: (m_0 + m_B) g for m_0 g + m_B g, (m_A + m_B) (v_1 - v_2) for all four products."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import letters
from planar_cli.equation.values.ledger import Ledger
from planar_cli.units import INERTIA, MASS

MOST = 12
"""Of more terms nobody looks for equal factors."""


def with_totals(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """The same value: in each sum the terms that differ in a mass alone, or in a moment of inertia, as one term with
    the total mass, and terms with the same total put together. An unknown mass stays in its own term.
    """
    amounts = {s for s in letters(expr) if _is_amount(s, ledger)}
    return _with_totals(expr, frozenset(amounts)) if len(amounts) > 1 else expr


def _is_amount(symbol: sp.Symbol, ledger: Ledger) -> bool:
    unit = ledger.units.get(symbol)
    return unit is not None and unit.dimension in (MASS, INERTIA) and symbol not in ledger.sought


def _with_totals(expr: sp.Expr, amounts: frozenset[sp.Symbol]) -> sp.Expr:
    if not expr.args or len(letters(expr) & amounts) < 2:
        return expr
    args = [_with_totals(a, amounts) for a in expr.args]
    if not all(a is b for a, b in zip(args, expr.args, strict=True)):
        expr = expr.func(*args)
    if not expr.is_Add or not 2 <= len(expr.args) <= MOST:
        return expr
    return _of_equal_totals(_of_equal_factors(expr, amounts), amounts)


def _of_equal_factors(total: sp.Expr, amounts: frozenset[sp.Symbol]) -> sp.Expr:
    """Terms of one sign that differ in the mass alone, and in how many there are of it, as one."""
    found: dict[tuple[sp.Expr, sp.Expr], list[sp.Expr]] = {}
    for term in total.args:
        own = [f for f in sp.Mul.make_args(term) if f in amounts]
        number, rest = (term / own[0]).as_coeff_Mul() if len(own) == 1 else (sp.S.One, term)
        times = abs(number) if number.is_Integer else sp.S.One
        found.setdefault((rest, number / times), []).append(times * own[0] if len(own) == 1 else sp.S.One)
    if all(len(own) == 1 or rest.is_number for (rest, _), own in found.items()):
        return total
    return sp.Add(*(_times(number * rest, own) for (rest, number), own in found.items()))


def _times(rest: sp.Expr, own: list[sp.Expr]) -> sp.Expr:
    """2 (m_1 + m_2) g, but (2 m_1 + m_2) g."""
    number, whole = sp.Add(*own).primitive()
    return number * rest * whole


def _of_equal_totals(total: sp.Expr, amounts: frozenset[sp.Symbol]) -> sp.Expr:
    """Terms with the same total mass and number as one product: a kinetic energy, with its 1/2, stays beside a work."""
    found: dict[tuple[sp.Expr, sp.Expr], list[sp.Expr]] = {}
    for term in sp.Add.make_args(total):
        own = [f for f in sp.Mul.make_args(term) if _is_total(f, amounts)]
        whole = own[0] if len(own) == 1 else sp.S.One
        found.setdefault((whole, abs(term.as_coeff_Mul()[0])), []).append(term / whole)
    if all(len(rest) == 1 or whole == 1 for (whole, _), rest in found.items()):
        return total
    return sp.Add(*(_put_together(whole, sp.Add(*rest)) for (whole, _), rest in found.items()))


def _is_total(factor: sp.Expr, amounts: frozenset[sp.Symbol]) -> bool:
    """m_1 + m_2, but not 2 m_1 + m_2, which may be m_1 + m_2/2 as the file writes it."""
    return factor.is_Add and amounts.issuperset(factor.args)


def _put_together(whole: sp.Expr, rest: sp.Expr) -> sp.Expr:
    """(m_1 + m_2) g (sin α - sin β), but (m_1 + m_2) (v²/l - g), not (m_1 + m_2) (v² - g l)/l."""
    shared = factor_terms(rest) if whole != 1 and rest.is_Add else rest
    return whole * (rest if sp.fraction(shared)[1].free_symbols else shared)
