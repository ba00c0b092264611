"""Antiderivatives by the class of the integrand, each in milliseconds and each confirmed by differentiation.

SymPy's `integrate` is not used: it may take minutes, and is wrong for |sin x cos x|. What is known here: polynomials,
powers of linear terms, polynomial x exponential x sine or cosine, products of sines and cosines, rational functions,
square roots of quadratics, pieces (with continuous antiderivative), and one substitution u(x). Anything else: None.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.calculus.deciding import confirmed, sign, vanishes
from planar_cli.calculus.forcing import particular
from planar_cli.calculus.pieces import pieces
from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer, simplified
from planar_cli.equation.values.exact import Valuation

DEPTH = 5
MOST_TRIED, MOST_TERMS = 6, 24
"""So many substitutions are tried, and so many terms are integrated one by one."""
HIGHEST_BELOW = 6
"""The highest degree of a denominator that is taken apart."""


def definite(f: sp.Expr, x: sp.Symbol, a: sp.Expr, b: sp.Expr, value: Valuation | None = None) -> sp.Expr | None:
    """∫ f dx from a to b in closed form; logarithms are put together to ln(u(b)/u(a)). None: no closed form is known.

    The integrand must be continuous from a to b.
    """
    if f == 0:
        return sp.S.Zero
    found = antiderivative(f, x, value)
    if found is None:
        return None
    total = []
    for term in sp.Add.make_args(found):
        factor, rest = term.as_independent(x, as_Add=False)
        if isinstance(rest, sp.log):
            ratio = rest.args[0].xreplace({x: b}) / rest.args[0].xreplace({x: a})
            total.append(factor * sp.log(ratio))
        elif rest == x:
            total.append(factor * (b - a))
        else:
            total.append(term.xreplace({x: b}) - term.xreplace({x: a}))
    return sp.Add(*total)


def antiderivative(f: sp.Expr, x: sp.Symbol, value: Valuation | None = None) -> sp.Expr | None:
    """A confirmed antiderivative of f(x); None: none is known. Logarithms stand without bars."""
    if longer(f, 3 * MANY):
        return None
    found = _find(f, x, value, DEPTH)
    if found is None or not confirmed(sp.Add(sp.diff(found, x), -f), value, (x,)):
        return None
    return found


def where_real(found: sp.Expr, value: Valuation) -> sp.Expr:
    """An antiderivative with ln(-u) instead of ln(u) where u is negative: the derivative is the same."""
    turned = {p: sp.log(-p.args[0]) for p in found.atoms(sp.log) if sign(p.args[0], value) == -1}
    return found.xreplace(turned)


def _find(f: sp.Expr, x: sp.Symbol, value: Valuation | None, depth: int) -> sp.Expr | None:
    if not f.has(x):
        return f * x
    if depth == 0:
        return None
    if f.has(sp.Piecewise):
        return pieces(f, x, lambda e: _find(e, x, value, depth - 1), value)
    factor, own = f.as_independent(x, as_Add=False)
    found = _sum(own.args, x, value, depth) if own.is_Add else _single(own, x, value, depth)
    return None if found is None else sp.Add(*(factor * term for term in sp.Add.make_args(found)))


def _sum(terms: tuple[sp.Expr, ...], x: sp.Symbol, value: Valuation | None, depth: int) -> sp.Expr | None:
    if len(terms) > MOST_TERMS:
        return None
    found = []
    for term in terms:
        one = _find(term, x, value, depth)
        if one is None:
            return None
        found.append(one)
    return sp.Add(*found)


def _single(f: sp.Expr, x: sp.Symbol, value: Valuation | None, depth: int) -> sp.Expr | None:
    """One product: the classes in the order of their price."""
    found = _of_linear(f, x)
    if found is None:
        found = particular((sp.S.Zero, sp.S.One), f, x, value)
    if found is None:
        found = _rational(f, x, value, depth)
    if found is None:
        found = _root_of_quadratic(f, x, value)
    if found is None:
        apart = expanded(f)
        found = _sum(apart.args, x, value, depth - 1) if apart.is_Add else None
    return _substituted(f, x, value, depth) if found is None else found


def _of_linear(f: sp.Expr, x: sp.Symbol) -> sp.Expr | None:
    """A power, exponential or trigonometric function of b + c x."""
    if f == x:
        return x**2 / 2
    if f.is_Pow and not f.exp.has(x):
        u, n = f.base, f.exp
        c = sp.diff(u, x)
        if c.has(x):
            return None
        return sp.log(u) / c if n == -1 else u ** (n + 1) / ((n + 1) * c)
    table = {
        sp.tan: lambda u: -sp.log(sp.cos(u)),
        sp.tanh: lambda u: sp.log(sp.cosh(u)),
        sp.log: lambda u: u * sp.log(u) - u,
    }
    if f.func in table and not (c := sp.diff(f.args[0], x)).has(x):
        return table[f.func](f.args[0]) / c
    return None


def _rational(f: sp.Expr, x: sp.Symbol, value: Valuation | None, depth: int) -> sp.Expr | None:
    """Rational functions: polynomial part, then partial fractions down to linear and quadratic denominators."""
    if not f.is_rational_function(x):
        return None
    above, below = (sp.Poly(p, x) for p in sp.fraction(cancelled(f)))
    if below.degree() > HIGHEST_BELOW or below.degree() == 0:
        return _sum(sp.Add.make_args((above.as_expr() / below.as_expr()).expand()), x, value, depth - 1)
    if above.degree() >= below.degree():
        whole, rest = sp.div(above, below)
        return _sum((whole.as_expr(), rest.as_expr() / below.as_expr()), x, value, depth - 1)
    if below.degree() == 1:
        return above.as_expr() / below.LC() * sp.log(below.as_expr())
    if below.degree() == 2:
        return _over_quadratic(above, below, x, value)
    parts = sp.apart(f, x)
    return _sum(parts.args, x, value, depth - 1) if parts.is_Add else None


def _over_quadratic(above: sp.Poly, below: sp.Poly, x: sp.Symbol, value: Valuation | None) -> sp.Expr | None:
    """(n1 x + n0)/(a x² + b x + c)."""
    a, b, c = below.all_coeffs()
    n1, n0 = above.coeff_monomial(x), above.coeff_monomial(1)
    first, rest = n1 / (2 * a), simplified(n0 - n1 * b / (2 * a))
    found = first * sp.log(below.as_expr()) if n1 != 0 else sp.S.Zero
    if rest == 0:
        return found
    inner = simplified(4 * a * c - b**2)
    kind = sign(inner, value)
    if kind is None:
        return None
    slope = 2 * a * x + b
    if kind > 0:
        root = sp.sqrt(inner)
        return found + rest * 2 / root * sp.atan(simplified(slope / root))
    if kind == 0:
        return found - rest * 2 / slope
    root = sp.sqrt(-inner)
    return found + rest / root * sp.log(simplified((slope - root) / (slope + root)))


def _root_of_quadratic(f: sp.Expr, x: sp.Symbol, value: Valuation | None) -> sp.Expr | None:
    """(n1 x + n0) R^(n/2), n = 1, -1 or -3, with a quadratic R."""
    roots = [p for p in sp.Mul.make_args(f) if p.is_Pow and p.exp in (sp.S.Half, -sp.S.Half, sp.Rational(-3, 2))]
    if len(roots) != 1:
        return None
    r, n, rest = roots[0].base, roots[0].exp, f / roots[0]
    if not r.is_polynomial(x) or sp.degree(r, x) != 2 or not rest.is_polynomial(x) or sp.degree(rest, x) > 1:
        return None
    a, b, c = sp.Poly(r, x).all_coeffs()
    by = sp.Poly(rest, x)
    n1, n0 = by.coeff_monomial(x), by.coeff_monomial(1)
    found = n1 / (2 * a) * r ** (n + 1) / (n + 1)
    left = simplified(n0 - n1 * b / (2 * a))
    if left == 0:
        return found
    slope, inner = 2 * a * x + b, simplified(4 * a * c - b**2)
    if n == sp.Rational(-3, 2):
        return None if vanishes(inner, value) else found + left * 2 * slope / (inner * sp.sqrt(r))
    under = _under_root(r, a, slope, inner, value)
    if under is None:
        return None
    if n == sp.S.Half:
        under = slope / (4 * a) * sp.sqrt(r) + inner / (8 * a) * under
    return found + left * under


def _under_root(r: sp.Expr, a: sp.Expr, slope: sp.Expr, inner: sp.Expr, value: Valuation | None) -> sp.Expr | None:
    """∫ dx/sqrt(R)."""
    opened = sign(a, value)
    if not opened:
        return None
    if opened > 0:
        return sp.log(2 * sp.sqrt(a) * sp.sqrt(r) + slope) / sp.sqrt(a)
    return sp.asin(simplified(-slope / sp.sqrt(-inner))) / sp.sqrt(-a)


def _substituted(f: sp.Expr, x: sp.Symbol, value: Valuation | None, depth: int) -> sp.Expr | None:
    """∫ g(u) u' dx for a u that stands in f."""
    u_new = sp.Dummy("u", positive=True)
    for u in _candidates(f, x):
        rest = sp.powsimp(f / sp.diff(u, x))
        g = rest.subs(u, u_new)
        if g.has(x) and u.is_polynomial(x) and sp.degree(u, x) == 2 and sp.Poly(u, x).coeff_monomial(x) == 0:
            by = sp.Poly(u, x)
            g = g.subs(x**2, (u_new - by.coeff_monomial(1)) / by.coeff_monomial(x**2))
        if g.has(x):
            g = cancelled(g) if g.is_rational_function(x, u_new) else g
        if not g.has(x):
            found = _find(g, u_new, value, depth - 1)
            if found is not None:
                return found.xreplace({u_new: u})
    return None


def _candidates(f: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """What a substitution may take for u, the shortest first."""
    found = {p.base for p in f.atoms(sp.Pow)} | {p for p in f.atoms(sp.Pow) if p.exp.is_Integer}
    for function in f.atoms(sp.Function):
        found |= {function, *function.args}
    moving = [u for u in found if u.has(x) and u != x and not isinstance(u, sp.Abs | sp.sign)]
    own = [u for u in moving if u != f or u.is_Function]
    return sorted(own, key=lambda u: (sp.count_ops(u), sp.default_sort_key(u)))[:MOST_TRIED]
