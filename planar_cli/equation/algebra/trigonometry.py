"""Products of sines and cosines in a plainer form: the steps of SymPy's `trigsimp`, at a part of its price.

They are those of H. Fu, X. Zhong, Z. Zeng, Automated and readable simplification of trigonometric expressions
(2006), in the order of `sympy.simplify.trigsimp.futrig`, which takes every part of an expression through all of them.
Here what a part comes to is remembered, as formulas of one problem have most parts in common; and while a sum or a
product is worked on, roots and other functions with angles inside, which are in their plainer form already, stand in it
as one letter each, and so do angles that no identity can relate. Fewer letters are much less to factor.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache

import sympy as sp
from sympy.core.function import expand_multinomial
from sympy.functions.elementary.trigonometric import TrigonometricFunction
from sympy.simplify.fu import (
    TR1,
    TR2,
    TR3,
    TR5,
    TR6,
    TR10,
    TR11,
    TR12,
    TR14,
    TR15,
    TR16,
    TR22,
    TR111,
    TR2i,
    TR10i,
    TRmorrie,
)

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.product_to_sum import as_sums

KEPT = 20_000
"""So many parts are remembered."""
Step = Callable[[sp.Expr], sp.Expr]


def put_together(expr: sp.Expr) -> sp.Expr:
    """The plainest form that the identities of angles give."""
    if not expr.has(TrigonometricFunction) or not _only_numbers(expr):
        return expr
    found = sp.bottom_up(expr, _part)
    if found != expr and found.is_Mul and found.args[0].is_Rational:
        # A number before a sum of two goes into it.
        found = sp.Mul(*found.as_coeff_Mul())
    return found


def _only_numbers(expr: sp.Expr) -> bool:
    """Does it consist of expressions, and not of conditions as a table does?"""
    return all(isinstance(part, sp.Expr) for part in sp.preorder_traversal(expr))


def _part(expr: sp.Expr) -> sp.Expr:
    """One part of an expression, whose own parts have been seen to."""
    if not _turning(expr):
        return expr
    rest = sp.S.One
    if expr.is_Mul:
        rest, expr = expr.as_independent(TrigonometricFunction)
    return rest * _as_letters(expr)


@lru_cache(maxsize=KEPT)
def _turning(expr: sp.Basic) -> bool:
    """Does it hold functions of angles?"""
    return isinstance(expr, TrigonometricFunction) or any(map(_turning, expr.args))


def _as_letters(expr: sp.Expr) -> sp.Expr:
    """The part with letters for what need not be looked into."""
    if not _rational(expr):
        # What stands inside a root or another function has been seen to; a root may be one of factors.
        return _worked(expr) if isinstance(expr, TrigonometricFunction) else _plainest(expr, factored)
    letters: dict[sp.Expr, sp.Symbol] = {k: _letter(k) for k in sorted(_kernels(expr), key=sp.default_sort_key)}
    plain = expr.xreplace(letters)
    turned: dict[sp.Expr, sp.Symbol] = {}
    if plain.has(TrigonometricFunction):
        functions = plain.atoms(TrigonometricFunction)
        angles = {f.args[0] for f in functions}
        if any(a.is_Add for a in angles) and _unrelated(angles):
            known = {f: f.func(_angle(f.args[0])) for f in functions}
            turned = {a: _angle(a) for a in angles}
            plain = plain.xreplace(known)
        plain = _worked(plain)
    # The angles first: they hold letters of roots.
    for own in (turned, letters):
        plain = plain.xreplace({letter: e for e, letter in own.items()})
    return plain


def _rational(expr: sp.Expr) -> bool:
    return bool(expr.is_Add or expr.is_Mul or (expr.is_Pow and expr.exp.is_Integer))


def _kernels(expr: sp.Expr) -> set[sp.Expr]:
    """The roots and functions in a rational expression that hold angles."""
    found: set[sp.Expr] = set()
    waiting = [expr]
    while waiting:
        part = waiting.pop()
        if _rational(part):
            waiting += part.args
        elif not isinstance(part, TrigonometricFunction) and part.has(TrigonometricFunction):
            found.add(part)
    return found


@lru_cache(maxsize=KEPT)
def _letter(expr: sp.Expr) -> sp.Symbol:
    """A letter for an expression, with what is known of its sign."""
    return sp.Dummy("k", positive=True) if expr.is_positive else sp.Dummy("k", real=expr.is_real)


@lru_cache(maxsize=KEPT)
def _angle(expr: sp.Expr) -> sp.Symbol:
    return sp.Dummy("u", real=True)


def _unrelated(angles: Iterable[sp.Expr]) -> bool:
    """Is none of these angles a sum of multiples of the others?"""
    if any(a.is_number for a in angles):
        return False
    parts: list[Mapping[sp.Expr, sp.Expr]] = [a.as_coefficients_dict() for a in angles]
    terms = sorted({t for p in parts for t in p}, key=sp.default_sort_key)
    return bool(sp.Matrix([[p.get(t, 0) for t in terms] for p in parts]).rank() == len(parts))


# --- steps ------------------------------------------------------------------------------------------------------------


@lru_cache(maxsize=KEPT)
def _cost(expr: sp.Expr) -> tuple[int, ...]:
    nodes = sum(1 for _ in sp.preorder_traversal(expr))
    functions = int(expr.count(TrigonometricFunction))
    return functions, operations(expr), nodes, len(expr.args), int(bool(expr.is_Add))


@lru_cache(maxsize=KEPT)
def _reduced(expr: sp.Expr) -> sp.Expr:
    """Factored, with common factors of numerator and denominator gone."""
    return expr if factored(expr) == expr else factored(expr.normal())


@lru_cache(maxsize=KEPT)
def _expanded(expr: sp.Expr) -> sp.Expr:
    return sp.expand_mul(expand_multinomial(expr))


def _plainest(expr: sp.Expr, *steps: Step) -> sp.Expr:
    """What one of these steps makes of it, or itself, whichever is plainer."""
    return min((expr, *(step(expr) for step in steps)), key=_cost)


def _alone(expr: sp.Expr) -> bool:
    """Does each term hold one sine or cosine at most, of angles that no identity relates, not twice an angle either?"""
    functions = expr.atoms(TrigonometricFunction)
    return (
        all(isinstance(f, sp.sin | sp.cos) and f.args[0].as_coeff_Mul()[0] % 2 for f in functions)
        and all(_degree(t) < 2 for t in sp.Add.make_args(expr))
        and _unrelated({f.args[0] for f in functions})
    )


def _degree(expr: sp.Expr) -> int:
    """How many functions of angles are multiplied or divided by each other at most."""
    if expr.is_Pow:
        return _degree(expr.base) * abs(int(expr.exp)) if expr.exp.is_Integer else 2 * _degree(expr.base)
    if expr.is_Mul:
        return sum(_degree(a) for a in expr.args)
    return int(isinstance(expr, TrigonometricFunction)) or max((_degree(a) for a in expr.args), default=0)


@lru_cache(maxsize=KEPT)
def _worked(whole: sp.Expr) -> sp.Expr:
    """A part taken through all steps; as it was, where these make it no plainer."""
    if _alone(whole):
        plain = sp.expand_mul(_plainest(factored(whole), _expanded))
        return min((whole, _plainest(plain, factor_terms)), key=_cost)
    expr = factored(TR12(TR1(TR3(whole))))
    expr = TR2i(_plainest(TR2(expr), _expanded))
    expr = TR6(TR11(TR10(TR5(TR14(_reduced(expr))))))
    expr = TRmorrie(TR10i(_plainest(TR14(factored(expr)), _expanded)))
    expr = _plainest(_plainest(expr, as_sums), lambda e: TR2i(TR2(e)))
    expr = min((sp.expand_mul(f(expr)) for f in (TR5, TR15)), key=_cost)
    expr = min((sp.expand_mul(f(expr)) for f in (TR6, TR16)), key=_cost)
    expr = _plainest(TR111(expr), TR2i)
    expr = _plainest(expr, lambda e: sp.expand_mul(TR22(e)))
    expr = _plainest(TR2i(TR2(TR1(expr))), lambda e: factor_terms(TR12(e)))
    return min((whole, expr), key=_cost)
