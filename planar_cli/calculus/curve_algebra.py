"""The parameter eliminated by solving one coordinate for it, by powers, or by a resultant."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_conics import Plane, of_polynomial, sloping
from planar_cli.calculus.curve_plain import plainer
from planar_cli.calculus.curve_polar import inverted
from planar_cli.calculus.curve_waves import eliminated
from planar_cli.calculus.curve_words import CURVE, HYPERBOLA, LINE, PARABOLA, Curve, Step
from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer

HIGHEST_POWER = 6


def _equal(left: Any, right: Any) -> sp.Eq:
    return sp.Eq(left, right, evaluate=False)


def straight(plane: Plane) -> Curve | None:
    """A straight line: a constant coordinate, or dy/dx the same everywhere (x' y'' = y' x'')."""
    p, (x, y), trial = plane.trial.parameter, plane.path, plane.trial
    dx, dy = sp.diff(x, p), sp.diff(y, p)
    for axis, rate, place in ((plane.x, dx, x), (plane.y, dy, y)):
        if trial.zero(rate):
            equation = _equal(axis, _constant(place, p))
            return Curve(LINE, equation, ((f"{axis} does not change", equation),))
    if not trial.zero(dx * sp.diff(dy, p) - dy * sp.diff(dx, p)):
        return None
    slope = _constant(dy / dx, p)
    if slope.has(p):
        return None
    rest = _constant(expanded(y - slope * x), p)
    if rest.has(p):
        return None
    equation = sloping(plane, slope, rest)
    if not plane.true(equation):
        return None
    solved = inverted(x, p, plane.x)
    if solved is not None and solved[1][0] < 0 and not x.has(sp.exp):
        return Curve(LINE, equation, ((f"from {plane.x}", _equal(p, solved[0])), (f"in {plane.y}", equation)))
    steps = (("", _equal(plane.x, x)), ("", _equal(plane.y, y)))
    return Curve(LINE, equation, (*steps, (f"{plane.y} changes in proportion to {plane.x}", equation)))


def _constant(expr: sp.Expr, p: sp.Symbol) -> sp.Expr:
    """An expression that does not change with p, without p."""
    expr = plainer(expr)
    for value in (0, 1, sp.pi / 2, sp.Rational(1, 3)):
        if not expr.has(p):
            break
        trial = expr.subs(p, value)
        if not trial.has(sp.nan, sp.zoo, sp.oo):
            expr = plainer(trial)
    return expr


def by_solving(plane: Plane, simple: bool) -> Curve | None:
    """p from one coordinate, put into the other. `simple`: only where that coordinate is linear in p."""
    p, (x, y) = plane.trial.parameter, plane.path
    for known, first, other, second in ((plane.x, x, plane.y, y), (plane.y, y, plane.x, x)):
        found = inverted(first, p, known)
        if found is None or (simple and found[1][0] >= 0) or (simple and first.has(sp.exp)):
            continue
        solution, where, words = found
        right = _put_in(second, p, known, first, solution)
        if right is None:
            continue
        equation = _equal(other, right)
        places = {plane.x: x, plane.y: y}
        holds = ""
        if not plane.trial.true(equation.lhs - equation.rhs, places):
            if not plane.trial.true(equation.lhs - equation.rhs, places, p, where):
                continue
            holds = words
        steps: tuple[Step, ...] = ((f"from {known}", _equal(p, solution)),)
        curve = replace(_named(plane, known, other, right), holds=holds)
        if curve.equation != equation:
            steps += ((f"in {other}", equation),)
        words = f"in {other}" if curve.equation == equation else ""
        return replace(curve, steps=(*steps, (words, curve.equation)))
    return None


def _put_in(second: sp.Expr, p: sp.Symbol, known: sp.Symbol, first: sp.Expr, solution: sp.Expr) -> sp.Expr | None:
    """The other coordinate with p put in; powers of (x - x_0) kept together where x_0 is a letter."""
    whole = expanded(second)
    if whole.is_polynomial(p) and expanded(first).is_polynomial(p) and sp.degree(expanded(first), p) == 1:
        size, start = sp.Poly(expanded(first), p).all_coeffs()
        base = known - plainer(start)
        terms = [plainer(c / size**n) * base**n for (n,), c in sp.Poly(whole, p).terms()]
        right = sp.Add(*terms)
        return right if start.free_symbols else expanded(right)
    right = second.xreplace({p: solution})
    if right.has(p) or longer(right, 3 * MANY):
        return None
    return sp.powdenest(plainer(right)) if not longer(right, MANY) else right


def _named(plane: Plane, known: sp.Symbol, other: sp.Symbol, right: sp.Expr) -> Curve:
    """The kind of y = f(x), in the form of a conic if it is one."""
    equation = _equal(other, right)
    polynomial = expanded(right)
    if polynomial.is_polynomial(known):
        degree = sp.degree(polynomial, known)
        return Curve({1: LINE, 2: PARABOLA}.get(int(degree), CURVE), equation)
    algebraic = _without_roots(other - right, known)
    if algebraic is not None:
        found = of_polynomial(plane, algebraic)
        if found is not None and found.kind != CURVE:
            return found
    constant, moving = right.as_independent(known, as_Add=True)
    shape = moving.as_independent(known, as_Add=False)[1]
    if isinstance(shape, sp.sin | sp.cos) and not sp.diff(shape.args[0], known).has(known):
        return Curve("sine curve", equation)
    if isinstance(shape, sp.exp) and not sp.diff(shape.args[0], known).has(known):
        return Curve("exponential curve", equation)
    if isinstance(shape, sp.log) and constant is not None:
        return Curve("logarithmic curve", equation)
    return Curve(CURVE, equation)


def _without_roots(expr: sp.Expr, known: sp.Symbol) -> sp.Expr | None:
    """A numerator in which at most two square roots were squared away; None if something else is left."""
    for _ in range(3):
        roots = {q.base for q in expr.atoms(sp.Pow) if q.exp.is_Rational and q.exp.q == 2 and q.has(known)}
        if not roots:
            return expr if expr.is_rational_function(*expr.free_symbols & {known}) else None
        if longer(expr, 2 * MANY):
            return None
        inside = max(roots, key=lambda q: (sp.count_ops(q), str(q)))
        root = sp.Dummy("q")
        own = [q for q in expr.atoms(sp.Pow) if q.base == inside and q.exp.is_Rational and q.exp.q == 2]
        flat = expanded(sp.fraction(together(expr.xreplace({q: root ** (2 * q.exp) for q in own})))[0])
        if not flat.is_polynomial(root):
            return None
        parts = [sp.S.Zero, sp.S.Zero]
        for (n,), c in sp.Poly(flat, root).terms():
            parts[n % 2] += c * inside ** (n // 2)
        expr = expanded(parts[0] ** 2 - parts[1] ** 2 * inside)
    return None


def by_powers(plane: Plane) -> Curve | None:
    """x - x_0 = a p^m and y - y_0 = b p^n: ((x - x_0)/a)^n = ((y - y_0)/b)^m in whole powers."""
    p = plane.trial.parameter
    rows = []
    for axis, place in ((plane.x, plane.path[0]), (plane.y, plane.path[1])):
        start, moving = expanded(place).as_independent(p, as_Add=True)
        size, shape = moving.as_independent(p, as_Add=False)
        base, power = shape.as_base_exp()
        if base != p or not power.is_Rational:
            return None
        rows.append((axis, plainer(start), size, power))
    (x, x0, a, m), (y, y0, b, n) = rows
    share = sp.gcd(m, n)
    i, j = int(n / share), int(m / share)
    if i < 0:
        i, j = -i, -j
    if j < 0:
        equation = _equal(sp.Mul((x - x0) ** i, (y - y0) ** (-j)), plainer(a**i * b ** (-j)))
    elif j == 1:
        equation = _equal(y, y0 + plainer(b / a**i) * (x - x0) ** i)
    elif i == 1:
        equation = _equal(x, x0 + plainer(a / b**j) * (y - y0) ** j)
    elif i < j:
        equation = _equal((x - x0) ** i, plainer(a**i / b**j) * (y - y0) ** j)
    else:
        equation = _equal((y - y0) ** j, plainer(b**j / a**i) * (x - x0) ** i)
    if not plane.true(equation):
        return None
    kinds = {(1, 1): LINE, (1, -1): HYPERBOLA, (1, 2): PARABOLA, (2, 1): PARABOLA}
    kind = kinds.get((i, j), "semicubical parabola" if {i, j} == {2, 3} else CURVE)
    steps: tuple[Step, ...] = (("", _equal(x, plane.path[0])), ("", _equal(y, plane.path[1])))
    return Curve(kind, equation, (*steps, (f"without {p}, by powers of both", equation)))


def by_resultant(plane: Plane) -> Curve | None:
    """Both coordinates polynomials or quotients of polynomials in p, or with square roots of such."""
    p, (x, y) = plane.trial.parameter, plane.path
    sides = []
    for axis, place in ((plane.x, x), (plane.y, y)):
        squared = _without_roots(axis - place, p)
        if squared is None:
            return None
        side = expanded(sp.fraction(together(squared))[0])
        if not side.is_polynomial(p) or sp.degree(side, p) > HIGHEST_POWER:
            return None
        sides.append(side)
    found = eliminated(plane, sides[0], sides[1], p)
    if found is None:
        return None
    steps: tuple[Step, ...] = (("", _equal(plane.x, x)), ("", _equal(plane.y, y)))
    return replace(found, steps=(*steps, (f"{p} eliminated from both", found.equation)))


def in_exponential(plane: Plane) -> tuple[Plane, sp.Expr] | None:
    """The path in E = exp(k p), if p occurs only so; also with cosh, sinh; and what E stands for."""
    p = plane.trial.parameter
    path = [e.rewrite(sp.exp) if e.has(sp.cosh, sp.sinh, sp.tanh) else e for e in plane.path]
    found = {f for e in path for f in e.atoms(sp.exp) if f.has(p)}
    if not found:
        return None
    parts = {f: expanded(f.args[0]).as_independent(p, as_Add=True) for f in found}
    first = next(iter(sorted((m for _, m in parts.values()), key=lambda m: (sp.count_ops(m), str(m)))))
    ratios = {f: cancelled(m / first) for f, (_, m) in parts.items()}
    if not all(r.is_Rational for r in ratios.values()):
        return None
    share = sp.gcd_list(list(ratios.values()))
    e = sp.Dummy("E", positive=True)
    into = {f: sp.exp(parts[f][0]) * e ** (ratios[f] / share) for f in found}
    new = tuple(expanded(x.xreplace(into)) for x in path)
    if any(x.has(p) for x in new):
        return None
    trial = plane.trial.over(e)
    return Plane(plane.x, plane.y, (new[0], new[1]), trial), sp.exp(expanded(first * share))
