"""Coefficients in their plainest form, at a price that is bounded.

Roots, sines and other functions are hidden behind letters, so that only quotients of polynomials with rational
coefficients are cancelled and factored; sin² + cos² = 1 is used by hand. SymPy's own trigonometric and algebraic
simplification may search for minutes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import factor_terms, together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer

LONG = 100
"""Longer expressions stay as they are."""
MANY_LETTERS = 12
FEW, FEW_OF_NUMBERS = 2, 20
NESTED = 3
KEPT = 4
"""So many forms by sin² + cos² = 1 are followed from angle to angle."""


def hidden(expressions: Iterable[Any]) -> tuple[list[sp.Expr], dict[sp.Symbol, sp.Expr]]:
    """The expressions as quotients of polynomials, everything else behind letters; and what the letters stand for."""
    behind: dict[sp.Expr, sp.Symbol] = {}

    def hide(e: sp.Expr) -> sp.Expr:
        if e.is_Rational or e.is_Symbol:
            return e
        if e.is_Add or e.is_Mul:
            return e.func(*(hide(a) for a in e.args))
        if e.is_Pow and e.exp.is_Integer:
            return hide(e.base) ** e.exp
        if e.is_Pow and e.exp.is_Rational and e.exp.q == 2:
            return hide_letter(sp.sqrt(e.base)) ** (2 * e.exp)
        return hide_letter(e)

    def hide_letter(e: sp.Expr) -> sp.Expr:
        if not (e.is_Pow or e.is_Function or e.is_NumberSymbol):
            return hide(e)
        return behind.setdefault(e, sp.Dummy(f"h{len(behind)}"))

    flat = [hide(sp.sympify(e)) for e in expressions]
    return flat, {letter: e for e, letter in behind.items()}


def rationally(work: Callable[..., Any], *expressions: Any) -> Any:
    """Work on quotients of polynomials, done with everything else hidden; the result shown again."""
    flat, shown = hidden(expressions)
    return work(*flat).xreplace(shown)


def plainer(expr: Any) -> sp.Expr:
    """A coefficient in its plainest form; a long one as it is."""
    return _plainer(sp.sympify(expr))


@lru_cache(maxsize=5000)
def _plainer(expr: sp.Expr) -> sp.Expr:
    if not expr.args or expr.is_Rational or longer(expr, LONG):
        return expr
    (flat,), shown = hidden([expr])
    if not flat.args and not flat.is_Rational:
        return _inner(expr)
    if len(flat.free_symbols) > MANY_LETTERS:
        return expr
    shown = {letter: _inner(e) for letter, e in shown.items()}
    forms = [expanded(flat), flat]
    if operations(flat) > FEW:
        whole = cancelled(flat)
        forms += [expanded(whole), whole, *_quotients(whole, shown)]
        forms = [*forms, *(factor_terms(f) for f in forms), together(flat)]
    found = [_with_tan(f.xreplace(shown)) for f in dict.fromkeys(forms)]
    best = min(found, key=_effort)
    return sp.radsimp(expanded(best)) if best.is_number and not longer(best, FEW_OF_NUMBERS) else best


def _quotients(whole: sp.Expr, shown: dict[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """Numerator and denominator shortened by sin² + cos² = 1, and what cancels then."""
    if longer(whole, LONG // 2):
        return []
    above, below = sp.fraction(whole)
    tops, bottoms = _ones(above, shown), _ones(below, shown)
    if len(tops) == len(bottoms) == 1:
        return []
    forms = []
    for top in tops:
        for bottom in bottoms:
            quotient = top / bottom if bottom.is_number else cancelled(top / bottom)
            forms += [expanded(quotient), quotient]
    return forms


def _inner(expr: sp.Expr) -> sp.Expr:
    """A function with its arguments tidied."""
    if not expr.args:
        return expr
    if expr.is_Pow and expr.exp.is_Rational:
        return sp.powdenest(plainer(expr.base) ** expr.exp)
    return expr.func(*(plainer(a) for a in expr.args))


def _ones(flat: sp.Expr, shown: dict[sp.Symbol, sp.Expr]) -> list[sp.Expr]:
    """The expression, and its shortest forms with sin² = 1 - cos² put in or the other way round, angle by angle."""
    waves = {e: s for s, e in shown.items() if isinstance(e, sp.sin | sp.cos)}
    if not flat.is_polynomial(*waves.values()):
        return [flat]
    forms = [flat]
    for angle in sorted({w.args[0] for w in waves}, key=str):
        pair = sp.sin(angle), sp.cos(angle)
        for high, other in (pair, pair[::-1]):
            if high not in waves or not flat.has(waves[high]) or sp.degree(flat, waves[high]) < 2:
                continue
            if other not in waves:
                waves[other] = sp.Dummy(f"o{len(waves)}")
                shown[waves[other]] = other
            forms += [_lowered(f, waves[high], waves[other]) for f in forms]
        forms = sorted(dict.fromkeys(forms), key=operations)[:KEPT]
    return forms


def _lowered(flat: sp.Expr, high: sp.Symbol, other: sp.Symbol) -> sp.Expr:
    whole = expanded(flat)
    poly = sp.Poly(whole, high)
    if poly.degree() < 2:
        return whole
    return expanded(sum(c * (1 - other**2) ** (n // 2) * high ** (n % 2) for (n,), c in poly.terms()))


def _with_tan(expr: sp.Expr) -> sp.Expr:
    """sin u/cos u as tan u."""
    if not expr.has(sp.sin):
        return expr
    return expr.replace(lambda e: e.is_Mul and e.has(sp.sin), _tangents)


def _tangents(product: sp.Expr) -> sp.Expr:
    powers = product.as_powers_dict()
    for f, n in list(powers.items()):
        if isinstance(f, sp.sin):
            other = sp.cos(f.args[0])
            m = powers.get(other, 0)
            if n.is_Integer and n > 0 and m == -n:
                product = product * other**n / f**n * sp.tan(f.args[0]) ** n
    return product


def _effort(expr: sp.Expr) -> int:
    """What an expression costs its reader: operations, and fractions inside a fraction."""
    reversed_signs = sum(all(a.could_extract_minus_sign() for a in s.args) for s in expr.atoms(sp.Add))
    return operations(expr) + NESTED * _nested(expr, inside=False) + 2 * reversed_signs


def _nested(expr: sp.Expr, inside: bool) -> int:
    if not expr.args:
        return 0
    below = expr.is_Pow and expr.exp.could_extract_minus_sign()
    return int(inside and below) + sum(_nested(a, inside or (below and a.is_Add)) for a in expr.args)
