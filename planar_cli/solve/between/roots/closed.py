"""Closed roots of one equation of a motion: polynomial, or with the unknown in one angle, one exponential, one root.

A cos u + B sin u = C:  u = ... + 2 n pi          a e^(ku) + b = 0:  u = ln(-b/a)/k          cosh u = a:  u = ± arcosh a
"""

from __future__ import annotations

from collections.abc import Collection
from decimal import Decimal
from typing import Any

import sympy as sp
from sympy.simplify.fu import TR8

from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import PI, Valuation
from planar_cli.errors import Undecided
from planar_cli.solve.instant.roots import Root, real_roots

TURNS = 3
LONGEST = 60
HYPERBOLIC = (sp.cosh, sp.sinh, sp.tanh)


def closed_roots(residual: sp.Expr, x: sp.Symbol, value: Valuation, truth: Decimal, symbolic: bool) -> list[Root]:
    """The roots that have a closed form; of periodic ones those next to the true value and in the first turns."""
    numerator = sp.fraction(together(residual))[0] if not residual.has(sp.Integral) else residual
    if numerator.is_polynomial(x):
        return _tidied(real_roots(residual, x, value, symbolic, False), value)
    numerator = _without_tangents(numerator, x)
    found: list[Root] = []
    for factor in _factors(numerator, x):
        try:
            found += _of_factor(factor, x, value, truth, symbolic)
        except Undecided:
            if value.extended({x: truth}).is_zero(factor):
                raise
    return _tidied(found, value)


def _factors(numerator: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The factors that hold x; a root belongs to one of them."""
    if longer(numerator, LONGEST) or numerator.has(sp.Integral):
        return [numerator]
    inside = {}
    if len(_kernels(numerator, x)) > 1 or numerator.is_Mul:
        inside = {a: sp.expand_trig(a) for a in numerator.atoms(sp.sin, sp.cos) if x in a.free_symbols}
    product = factored(numerator.xreplace(inside))
    return [f.base if f.is_Pow else f for f in sp.Mul.make_args(product) if x in f.free_symbols]


def _of_factor(numerator: sp.Expr, x: sp.Symbol, value: Valuation, truth: Decimal, symbolic: bool) -> list[Root]:
    """The roots of one factor."""
    if numerator.is_polynomial(x):
        return real_roots(numerator, x, value, symbolic, False)
    kernels = _kernels(numerator, x)
    if len(kernels) > 1 and (outer := _around(kernels)) is not None:
        return _one_function(numerator, x, outer, value, truth, symbolic)
    if len(kernels) > 1 and all(isinstance(k, HYPERBOLIC) for k in kernels):
        return _of_exponentials(numerator, x, kernels, value, truth, symbolic)
    if len(kernels) > 1:
        numerator = _summed(numerator)
        kernels = _kernels(numerator, x)
    if len(kernels) != 1:
        return []
    kernel = kernels.pop()
    if isinstance(kernel, (sp.exp, sp.log, *HYPERBOLIC)):
        return _one_function(numerator, x, kernel, value, truth, symbolic)
    if isinstance(kernel, sp.Pow):
        return _rooted(numerator, x, kernel, value, symbolic)
    try:
        return _angle(numerator, x, kernel, value, truth, symbolic)
    except Undecided:
        doubled = _summed(numerator)
        kernels = _kernels(doubled, x)
        if len(kernels) != 1 or kernel in kernels:
            raise
        return _angle(doubled, x, kernels.pop(), value, truth, symbolic)


def _summed(numerator: sp.Expr) -> sp.Expr:
    """Products of sines and cosines as sums."""
    return expanded(TR8(expanded(numerator))) if not longer(numerator, LONGEST) else numerator


def _without_tangents(numerator: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """Tangents of x as sines over cosines, without fractions; cos x + sin x tan x is 1/cos x, which has no root."""
    tangents = {a: sp.sin(a.args[0]) / sp.cos(a.args[0]) for a in numerator.atoms(sp.tan) if x in a.free_symbols}
    if not tangents:
        return numerator
    whole = sp.fraction(together(numerator.xreplace(tangents)))[0]
    return whole if longer(whole, LONGEST) else sp.fraction(together(simplified(whole)))[0]


def _kernels(expr: sp.Expr, x: sp.Symbol) -> set[sp.Expr]:
    """What hides x: arguments of sines and cosines, exponentials, hyperbolic functions, logarithms, roots. Multiples of
    one argument are reduced to the smallest.
    """
    found: set[sp.Expr] = set()
    for atom in expr.atoms(sp.sin, sp.cos, sp.tan):
        if x in atom.free_symbols:
            found.add(expanded(atom.args[0]))
    for atom in expr.atoms(sp.exp, sp.log, *HYPERBOLIC):
        if x in atom.free_symbols:
            found.add(atom)
    for atom in expr.atoms(sp.Pow):
        if x in atom.base.free_symbols and not atom.exp.is_Integer:
            found.add(sp.Pow(atom.base, sp.Rational(1, 2)) if (2 * atom.exp).is_Integer else atom)
    return found


def _around(kernels: Collection[sp.Expr]) -> sp.Expr | None:
    """The exponential or logarithm inside which all the others stand, as in ln cosh u; None: there is none."""
    outer = (k for k in kernels if isinstance(k, sp.exp | sp.log) and all(k.has(other) for other in kernels))
    return next(outer, None)


def _one_function(
    numerator: sp.Expr, x: sp.Symbol, kernel: sp.Expr, value: Valuation, truth: Decimal, symbolic: bool
) -> list[Root]:
    """One exponential, hyperbolic function or logarithm: its value first, then x."""
    y = sp.Dummy("y", real=True)
    flat = numerator.xreplace({kernel: y})
    flat = flat if x not in flat.free_symbols else sp.expand(flat, log=False).subs(kernel, y)
    if x in flat.free_symbols or not flat.is_polynomial(y):
        return []
    return [
        found
        for root in real_roots(flat, y, value, symbolic, False)
        if root.expression is not None
        for inside in _undone(kernel.func, root.expression, root.value)
        for found in closed_roots(kernel.args[0] - inside, x, value, truth, symbolic)
    ]


def _undone(function: Any, found: sp.Expr, number: Decimal) -> list[sp.Expr]:
    """All that a function makes `found` of; none outside of its range."""
    if function is sp.cosh:
        return [sp.acosh(found), -sp.acosh(found)] if number >= 1 else []
    if function is sp.tanh:
        return [sp.atanh(found)] if abs(number) < 1 else []
    if function is sp.exp:
        return [sp.log(found)] if number > 0 else []
    return [sp.asinh(found) if function is sp.sinh else sp.exp(found)]


def _of_exponentials(
    numerator: sp.Expr, x: sp.Symbol, kernels: Collection[sp.Expr], value: Valuation, truth: Decimal, symbolic: bool
) -> list[Root]:
    """Hyperbolic functions of one argument: a polynomial in its exponential."""
    argument, *others = {expanded(k.args[0]) for k in kernels}
    if others:
        return []
    e = sp.exp(argument)
    own = {sp.cosh: (e + 1 / e) / 2, sp.sinh: (e - 1 / e) / 2, sp.tanh: (e**2 - 1) / (e**2 + 1)}
    flat = expanded(sp.fraction(together(numerator.xreplace({k: own[k.func] for k in kernels})))[0] * e ** len(kernels))
    return _one_function(flat, x, e, value, truth, symbolic)


def _rooted(numerator: sp.Expr, x: sp.Symbol, kernel: sp.Pow, value: Valuation, symbolic: bool) -> list[Root]:
    """One square root: isolated and squared; what does not satisfy the equation itself leaves."""
    y = sp.Dummy("y", nonnegative=True)
    flat = expanded(numerator.xreplace({kernel: y}).subs(kernel, y))
    if not flat.is_polynomial(y) or sp.degree(flat, y) != 1:
        return []
    slope, rest = flat.coeff(y, 1), flat.coeff(y, 0)
    squared = expanded(slope**2 * kernel.base - rest**2)
    if not squared.is_polynomial(x):
        return []
    found = []
    for root in real_roots(squared, x, value, symbolic, False):
        here = value.extended({x: root.value})
        number = here.known(numerator)
        if number is not None and abs(number) <= Decimal("1e-15") * here.size(numerator):
            found.append(root)
    return found


def _angle(
    numerator: sp.Expr, x: sp.Symbol, argument: sp.Expr, value: Valuation, truth: Decimal, symbolic: bool
) -> list[Root]:
    """One angle u, linear in x: all u of a turn, then x for as many turns as reach the true value."""
    rate = sp.diff(argument, x)
    if x in rate.free_symbols:
        return []
    u = sp.Dummy("u", real=True)
    flat = numerator.replace(
        lambda e: isinstance(e, sp.sin | sp.cos | sp.tan) and expanded(e.args[0] - argument) == 0, lambda e: e.func(u)
    )
    if x in flat.free_symbols:
        return []
    start = simplified((argument - rate * x).expand())
    there = value(rate) * truth + value(start)
    found = []
    for root in real_roots(flat, u, value, symbolic, True):
        if root.expression is None:
            continue
        turns = round(float((there - value(root.expression)) / (2 * PI)))
        first = 0 if abs(turns) <= TURNS else turns
        for n in range(min(first, turns), max(first, turns) + 1):
            expr = (root.expression + 2 * sp.pi * n - start) / rate
            number = value(expr)
            found.append(Root(expr, number))
    return found


def _unwound(expr: sp.Expr, value: Valuation) -> sp.Expr:
    """The angle whose tangent is the cotangent of another: the complement of that."""

    def plain(e: sp.Expr) -> sp.Expr:
        below = 1 / e.args[0]
        if not isinstance(below, sp.tan):
            return e
        angle = sp.pi / 2 - below.args[0]
        turns = (value(e) - value(angle)) / PI
        whole = round(turns)
        return angle + whole * sp.pi if abs(turns - whole) <= Decimal("1e-20") else e

    found: sp.Expr = expr.replace(lambda e: isinstance(e, sp.atan), plain)
    return found


def _tidied(roots: list[Root], value: Valuation) -> list[Root]:
    """Plainer expressions, each still with its value."""
    found = []
    for r in roots:
        expr = r.expression
        if expr is not None and not longer(expr, LONGEST):
            expr = simplified(_unwound(expr, value))
        found.append(Root(expr, r.value))
    return sorted(found, key=lambda r: r.value)
