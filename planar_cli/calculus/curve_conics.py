"""Lines and conics in the form that a textbook writes them in.

y = m x + c; (x - a)² + (y - b)² = r²; (x - a)²/p² + (y - b)²/q² = 1; y as a polynomial of second degree in x; and,
where the axes are oblique, a polynomial. The kind follows from the discriminant B² - 4 A C of
A x² + B x y + C y² + D x + E y + F = 0.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.calculus.curve_plain import hidden, plainer, rationally
from planar_cli.calculus.curve_trial import Trial
from planar_cli.calculus.curve_words import CIRCLE, CONIC, ELLIPSE, HYPERBOLA, LINE, PARABOLA, Curve
from planar_cli.equation.algebra.cancelling import cancelled
from planar_cli.equation.algebra.common_factors import together
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer
from planar_cli.records import record

FACTORED = 60
"""A polynomial of more terms is not factored."""


@record
class Plane:
    """The two axes, what they are along the path, and the numbers to decide with."""

    x: sp.Symbol
    y: sp.Symbol
    path: tuple[sp.Expr, sp.Expr]
    trial: Trial

    def true(self, equation: sp.Eq) -> bool:
        """Does an equation in the axes hold all along the path?"""
        return self.trial.true(equation.lhs - equation.rhs, {self.x: self.path[0], self.y: self.path[1]})


def root_of(square: sp.Expr) -> sp.Expr:
    """The root of a square that is not negative."""
    return sp.sqrt(square if longer(square, MANY) else rationally(sp.factor, square))


def line(plane: Plane, a: Any, b: Any, c: Any) -> Curve:
    """The straight line a x + b y + c = 0: y = m x + k, or x = k."""
    if plane.trial.zero(b):
        return Curve(LINE, sp.Eq(plane.x, plainer(-c / a), evaluate=False))
    return Curve(LINE, sloping(plane, plainer(-a / b), plainer(-c / b)))


def sloping(plane: Plane, slope: sp.Expr, rest: sp.Expr) -> sp.Eq:
    """y = m x + c, or y = m (x - k) where that is shorter."""
    right = slope * plane.x + rest
    if slope.free_symbols and rest != 0:
        together = sp.Mul(slope, plane.x + plainer(rest / slope))
        right = min((right, together), key=operations)
    return sp.Eq(plane.y, right, evaluate=False)


def polynomial_terms(expr: sp.Expr, x: sp.Symbol, y: sp.Symbol, trial: Trial) -> dict[tuple[int, int], sp.Expr] | None:
    """The coefficients by powers of x and y, those that vanish left out; None if it is no polynomial."""
    whole = expanded(expr)
    if not whole.is_polynomial(x, y):
        return None
    terms = {(int(m[0]), int(m[1])): plainer(c) for m, c in sp.Poly(whole, x, y).terms()}
    return {m: c for m, c in terms.items() if not trial.zero(c)}


def conic(plane: Plane, expr: sp.Expr) -> Curve | None:
    """The line or conic expr = 0; None if it is none, or one that falls apart into lines."""
    terms = polynomial_terms(expr, plane.x, plane.y, plane.trial)
    if not terms or max(i + j for i, j in terms) > 2:
        return None
    a, b, c, d, e, f = (terms.get(m, sp.S.Zero) for m in ((2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)))
    if not (a or b or c):
        return line(plane, d, e, f)
    if b:
        return _crossed(plane, (a, b, c, d, e, f))
    if a and c:
        return _centred(plane, a, c, d, e, f)
    return _parabola(plane, plane.x, plane.y, (a, d, e, f)) if a else _parabola(plane, plane.y, plane.x, (c, e, d, f))


def _parabola(plane: Plane, x: sp.Symbol, y: sp.Symbol, terms: tuple[sp.Expr, ...]) -> Curve | None:
    """A x² + D x + E y + F = 0, the axis of the parabola along y."""
    a, d, e, f = terms
    if not e:
        return None
    equation = sp.Eq(y, plainer(-a / e) * x**2 + plainer(-d / e) * x + plainer(-f / e), evaluate=False)
    return Curve(PARABOLA, equation)


def _centred(plane: Plane, a: sp.Expr, c: sp.Expr, d: sp.Expr, e: sp.Expr, f: sp.Expr) -> Curve | None:
    """A x² + C y² + D x + E y + F = 0: squares completed."""
    middle = plainer(-d / (2 * a)), plainer(-e / (2 * c))
    rest = plainer(a * middle[0] ** 2 + c * middle[1] ** 2 - f)
    if plane.trial.zero(rest):
        return None
    return axes_parallel(plane, middle, plainer(rest / a), plainer(rest / c))


def axes_parallel(plane: Plane, middle: tuple[sp.Expr, sp.Expr], p: sp.Expr, q: sp.Expr) -> Curve:
    """(x - x_0)²/p + (y - y_0)²/q = 1: circle, ellipse or hyperbola by the signs of p and q."""
    trial = plane.trial
    if trial.zero(p - q):
        return circle(plane, middle, p)
    across, up = plane.x - middle[0], plane.y - middle[1]
    signs = trial.sign(p), trial.sign(q)
    kind = CONIC if None in signs else ELLIPSE if signs == (1, 1) else HYPERBOLA
    p, q = (e if e.is_number or longer(e, MANY) else rationally(sp.factor, e) for e in (p, q))
    return Curve(kind, sp.Eq(across**2 / p + up**2 / q, 1, evaluate=False), centre=middle)


def circle(plane: Plane, middle: tuple[sp.Expr, sp.Expr], square: sp.Expr) -> Curve:
    """(x - x_0)² + (y - y_0)² = r²."""
    equation = sp.Eq((plane.x - middle[0]) ** 2 + (plane.y - middle[1]) ** 2, square, evaluate=False)
    return Curve(CIRCLE, equation, centre=middle, radius=root_of(square))


def _crossed(plane: Plane, terms: tuple[sp.Expr, ...]) -> Curve | None:
    """A conic with a term in x y: (x - x_0) (y - y_0) = k, or an oblique one as a polynomial."""
    a, b, c, d, e, f = terms
    x, y, trial = plane.x, plane.y, plane.trial
    whole = 4 * a * c * f + b * d * e - a * e**2 - c * d**2 - f * b**2
    if trial.zero(whole):
        return None
    if not a and not c:
        middle = plainer(-e / b), plainer(-d / b)
        product = plainer(middle[0] * middle[1] - f / b)
        equation = sp.Eq(sp.Mul(x - middle[0], y - middle[1]), product, evaluate=False)
        return Curve(HYPERBOLA, equation, centre=middle)
    turning = trial.sign(b**2 - 4 * a * c)
    kind = CONIC if turning is None else {-1: ELLIPSE, 0: PARABOLA, 1: HYPERBOLA}[turning]
    centre = None
    if turning:
        under = b**2 - 4 * a * c
        centre = plainer((2 * c * d - b * e) / under), plainer((2 * a * e - b * d) / under)
    return Curve(kind, polynomial_equation(plane, terms_of(terms)), centre=centre)


def terms_of(terms: tuple[sp.Expr, ...]) -> dict[tuple[int, int], sp.Expr]:
    """The six coefficients of a conic by powers, those that are there."""
    powers = ((2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0))
    return {m: c for m, c in zip(powers, terms, strict=True) if c}


ORIGIN = (sp.S.Zero, sp.S.Zero)


def polynomial_equation(
    plane: Plane, terms: dict[tuple[int, int], sp.Expr], middle: tuple[sp.Expr, sp.Expr] = ORIGIN
) -> sp.Eq:
    """Σ c (x - x_0)^i (y - y_0)^j = k without common factors; the first term positive."""
    terms = _cleared(terms)
    constant = terms.pop((0, 0), sp.S.Zero)
    across, up = plane.x - middle[0], plane.y - middle[1]
    left = sp.Add(*(c * across**i * up**j for (i, j), c in terms.items()))
    return sp.Eq(left, -constant, evaluate=False)


def _cleared(terms: dict[tuple[int, int], sp.Expr]) -> dict[tuple[int, int], sp.Expr]:
    """Fractions and common factors taken out of coefficients."""
    flat, shown = hidden(terms.values())
    parts = [sp.fraction(cancelled(c)) for c in flat]
    below = sp.lcm_list([under for _, under in parts])
    cleared = [cancelled(above * below / under) for above, under in parts]
    common = sp.gcd_list(cleared)
    lead = max(range(len(cleared)), key=list(terms).__getitem__)
    if cancelled(cleared[lead] / common).xreplace(shown).could_extract_minus_sign():
        common = -common
    return {m: plainer(cancelled(c / common).xreplace(shown)) for m, c in zip(terms, cleared, strict=True)}


def of_polynomial(plane: Plane, expr: sp.Expr) -> Curve | None:
    """The curve of a polynomial equation expr = 0 in the axes: the factor that holds along the path, well written."""
    x, y, trial = plane.x, plane.y, plane.trial
    flat, shown = hidden([expr])
    numerator = sp.fraction(together(flat[0]))[0].xreplace(shown)
    terms = polynomial_terms(numerator, x, y, trial)
    if not terms:
        return None
    if max(i + j for i, j in terms) > 2 or len(terms) == 1:
        terms = _true_factor(plane, terms)
    if not terms:
        return None
    polynomial = sp.Add(*(c * x**i * y**j for (i, j), c in terms.items()))
    found = conic(plane, polynomial)
    if found is None:
        equation = _two_powers(plane, terms) or polynomial_equation(plane, terms)
        kind = "semicubical parabola" if set(terms) in ({(3, 0), (0, 2)}, {(2, 0), (0, 3)}) else "curve"
        found = Curve(kind, equation)
    return found if found.equation is not None and plane.true(found.equation) else None


def _true_factor(plane: Plane, terms: dict[tuple[int, int], sp.Expr]) -> dict[tuple[int, int], sp.Expr] | None:
    x, y, trial = plane.x, plane.y, plane.trial
    polynomial = sp.Add(*(c * x**i * y**j for (i, j), c in terms.items()))
    if len(terms) > FACTORED or longer(polynomial, 6 * MANY):
        return terms
    (flat,), shown = hidden([polynomial])
    for hidden_factor, _ in sp.factor_list(flat)[1]:
        factor = hidden_factor.xreplace(shown)
        if factor.has(x, y) and plane.true(sp.Eq(factor, 0, evaluate=False)):
            return polynomial_terms(factor, x, y, trial)
    return None


def _two_powers(plane: Plane, terms: dict[tuple[int, int], sp.Expr]) -> sp.Eq | None:
    """a y^n = b x^m as y^n = (b/a) x^m, the lower power on the left."""
    if len(terms) != 2:
        return None
    (m, a), (n, b) = sorted(terms.items(), key=lambda item: sum(item[0]))
    left, right = (plane.x ** k[0] * plane.y ** k[1] for k in (m, n))
    return sp.Eq(left, plainer(-b / a) * right, evaluate=False)
