"""Fractions and roots inside fractions, which a person would clear away: (μ h + b)/b - 1, √g over √g."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp


def is_nested(term: sp.Expr, sums: set[sp.Expr]) -> bool:
    """Does a fraction stand inside a fraction or a bracket of a product, or a root of a letter over and under one?
    `sums`: those in it.
    """
    found = any(_is_nested(s) or holds_quotient(s) for s in sums) or any(map(holds_fraction, below(term)))
    return found or _shares_root(term) or _multiplies_back(term)


def _multiplies_back(term: sp.Expr) -> bool:
    """Does a letter multiply a sum of which it divides a term: R (m R + I/R)?"""
    for product in (p for p in sp.preorder_traversal(term) if p.is_Mul):
        letters = {1 / f for f in product.args if f.is_Symbol}
        inside = {g for f in product.args if f.is_Add for t in f.args for g in sp.Mul.make_args(t)}
        if not letters.isdisjoint(inside):
            return True
    return False


def _shares_root(term: sp.Expr) -> bool:
    """Is it divided by the root of a letter, which a term of a sum in it has as factor?"""
    factors = sp.Mul.make_args(term)
    roots = [1 / f for f in factors if f.is_Pow and f.base.is_Symbol and f.exp == sp.Rational(-1, 2)]
    inside = {g for f in factors if f.is_Add for t in f.args for g in sp.Mul.make_args(t)}
    return any(r in inside for r in roots)


def _is_nested(total: sp.Expr) -> bool:
    """Does a sum stand under a fraction stroke inside a sum?"""
    parts = sp.preorder_traversal(total)
    return any(p.is_Pow and p.base.is_Add and p.exp.is_Integer and p.exp.is_negative for p in parts)


def holds_quotient(total: sp.Expr) -> bool:
    """Is a term of a sum another sum that is divided by letters: (μ h + b)/b - 1?"""
    return any(any(f.is_Add for f in t.args) and holds_fraction(t) for t in total.args if t.is_Mul)


def below(term: sp.Expr) -> Iterator[sp.Expr]:
    """The sums by which a term is divided."""
    return (f.base for f in sp.Mul.make_args(term) if f.is_Pow and f.exp == -1 and f.base.is_Add)


def holds_fraction(total: sp.Expr) -> bool:
    """Is a term of a sum divided by letters?"""
    factors = (f for t in total.args for f in sp.Mul.make_args(t))
    return any(f.is_Pow and f.exp.is_Integer and f.exp.is_negative for f in factors)


def in_storeys(expr: sp.Expr) -> bool:
    """Does a fraction stand in the bracket of a product, or under a fraction stroke: (m/2 + (M R + I/R)/R) α?"""
    for p in sp.preorder_traversal(expr):
        if p.is_Mul and any(f.is_Add and holds_fraction(f) for f in p.args):
            return True
        if p.is_Pow and p.exp.is_negative and p.base.is_Add and holds_fraction(p.base):
            return True
    return False
