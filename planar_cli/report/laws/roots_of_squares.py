"""A speed as the root of its own line: v² = m g (1 - e)/c gives v = √(m g (1 - e)/c), in no other form."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.laws.integrals import in_times
from planar_cli.report.words.origins import letter_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RouteStep, RouteTrace

LONGEST, ROOT = 60, 20
"""A longer right side is left to the formula that was found; a longer root to its equation in numbers."""


def rooted(told: tuple[RouteStep, RouteTrace], found: MotionTrace) -> tuple[RouteStep, RouteTrace]:
    """A derivation and its route, where it is one relation v² = … that tells v: with the root of that right side."""
    step, route = told
    (e, *more), (r, *others) = step.relations, step.results
    if more or others or e.kind != "v(q)" or e.law is None or r.formula is None:
        return told
    residual = e.residual.xreplace(dict(route.plain))
    x = letter_of(e, found.ledger)
    if x != r.unknown or longer(residual, LONGEST) or residual.coeff(x, 2) != 1:
        return told
    square = in_times(simplified(x**2 - residual), found)
    if x in square.free_symbols:
        return told
    root = sp.sqrt(square)
    if longer(root, r.formula.count_ops()):
        return told
    return replace(step, results=(replace(r, formula=-root if r.value < 0 else root),)), route


def is_long_root(formula: sp.Expr, phrases: Phrases) -> bool:
    """Is it (p ± √q)/r with a sum q, the root of a quadratic equation, and longer than that equation in numbers? As it
    is printed: the root of a square is none.
    """
    return _is_root(formula) and _is_root(phrases.math(formula).expr)


def _is_root(formula: sp.Expr) -> bool:
    if not longer(formula, ROOT):
        return False
    above, _ = sp.fraction(sp.together(formula, deep=False) if formula.is_Add else formula)
    terms = [t for f in sp.Mul.make_args(above) if f.is_Add for t in f.args]
    return any(f.is_Pow and f.exp == sp.S.Half and f.base.is_Add for t in terms for f in sp.Mul.make_args(t))
