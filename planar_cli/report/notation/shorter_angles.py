"""Closed formulas of an angle written shortly: half angles of arctan and arccos, and fractions of sines and cosines.

g/(μ sin² β + sin β cos β) - g/tan β  =  g (sin β - μ cos β)/(μ sin β + cos β)
tan(1/2 arctan(d/h))                  =  (√(d² + h²) - h)/d
2 v (sin θ - tan β cos θ)/g           =  2 v sin(θ - β)/(g cos β)
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction, TrigonometricFunction
from sympy.simplify.fu import TR8

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.factoring import factored
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.algebra.trigonometry import put_together

MOST = 70
"""Formulas of more operations stay as they are."""
HARD = 4
"""A formula with one of these may have so many operations more without it."""
S, C = sp.symbols("S C", real=True)
R = sp.Symbol("R", positive=True)


def shorter(expr: sp.Expr) -> sp.Expr:
    """The same formula in its shortest form; itself where none is shorter."""
    if not expr.has(TrigonometricFunction) or expr.has(sp.Integral, sp.Piecewise) or operations(expr) > MOST:
        return expr
    halved = expr.replace(_is_half_power, _half_power).replace(_is_half, _half)
    found = halved if halved == expr else simplified(halved)
    found = found.replace(_is_root, lambda e: _in_sines(e.base) ** e.exp)
    both = dict.fromkeys((found, of_two_angles(found)))
    forms = (expr, *(form for e in both for form in (e, _in_sines(e), _by_square(e))))
    return min(forms, key=lambda e: (_effort(e), int(e.count(TrigonometricFunction))))


def of_two_angles(expr: sp.Expr) -> sp.Expr:
    """Sums with a tangent that an addition theorem makes one function: sin θ - tan β cos θ as sin(θ - β)/cos β."""
    sums = [a for a in expr.atoms(sp.Add) if a.has(sp.tan) and not a.has(InverseTrigonometricFunction)]
    return sp.sympify(expr.xreplace({a: _added(a) for a in sums})) if sums else expr


def _added(total: sp.Expr) -> sp.Expr:
    above, below = sp.fraction(sp.together(total.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))))
    found = put_together(above)
    return total if found.is_Add else found / below


def _by_square(expr: sp.Expr) -> sp.Expr:
    """A product of roots by its square, in which one root √(d² + h²) is a letter."""
    roots = [f for f in sp.Mul.make_args(expr) if f.is_Pow and not f.exp.is_integer]
    square = sp.powdenest(expr**2, force=False)
    inner = [p for p in square.atoms(sp.Pow) if p.exp == sp.Rational(1, 2)]
    if not roots or len(inner) != 1 or expr.has(TrigonometricFunction) or any(f.is_negative for f in expr.args):
        return expr
    if not all(f.is_nonnegative or f in roots for f in sp.Mul.make_args(expr)):
        return expr
    (root,) = inner
    circle = root.base - R**2
    parts = sp.fraction(sp.together(square.xreplace({root: R})))
    if not all(p.is_polynomial(*root.base.free_symbols, R) for p in (*parts, root.base)):
        return expr
    letters = sorted(root.base.free_symbols, key=str)
    ways = [[p, *(sp.expand(sp.rem(p, circle, x)) for x in letters)] for p in parts]
    forms = [factored(sp.cancel(one / other)).xreplace({R: root}) for one in ways[0] for other in ways[1] if other != 0]
    return min((expr, *(sp.sqrt(f) for f in forms)), key=_effort)


def _is_root(e: sp.Expr) -> bool:
    return bool(e.is_Pow and abs(e.exp) == sp.Rational(1, 2))


def _effort(expr: sp.Expr) -> int:
    """Operations; a sum of fractions and functions of inverse functions are harder to read, and so is a difference
    below the bar, which hides its sign: 1 + 3 sin² β rather than 3 cos² β - 4.
    """
    halves = [f for f in expr.atoms(TrigonometricFunction) if f.has(InverseTrigonometricFunction)]
    below = [p.base for p in expr.atoms(sp.Pow) if p.exp.is_negative and p.base.is_Add]
    differences = [a for a in below if any(t.could_extract_minus_sign() for t in a.args)]
    return int(operations(expr)) + HARD * (len(halves) + len(differences) + bool(expr.is_Add))


def _of_inverse(e: sp.Basic) -> bool:
    return len(e.args) == 1 and isinstance(2 * e.args[0], InverseTrigonometricFunction)


def _is_half_power(e: sp.Expr) -> bool:
    """Is it an even power of the sine or cosine of half an inverse function?"""
    return bool(e.is_Pow and e.exp.is_even and isinstance(e.base, sp.sin | sp.cos) and _of_inverse(e.base))


def _half_power(e: sp.Expr) -> sp.Expr:
    sign = -1 if isinstance(e.base, sp.sin) else 1
    whole: sp.Expr = ((1 + sign * sp.cos(2 * e.base.args[0])) / 2) ** (e.exp / 2)
    return whole


def _is_half(e: sp.Expr) -> bool:
    return isinstance(e, sp.tan | sp.cot) and _of_inverse(e)


def _half(e: sp.Expr) -> sp.Expr:
    whole = 2 * e.args[0]
    found: sp.Expr = ((1 - sp.cos(whole)) if isinstance(e, sp.tan) else (1 + sp.cos(whole))) / sp.sin(whole)
    return factored(sp.radsimp(found))


def _in_sines(expr: sp.Expr) -> sp.Expr:
    """A fraction in the sine and cosine of the one angle in it, shortened by sin² + cos² = 1."""
    angles = {s for f in expr.atoms(TrigonometricFunction) for s in f.free_symbols}
    if len(angles) != 1 or expr.has(sp.Abs, InverseTrigonometricFunction):
        return expr
    (angle,) = angles
    plain = sp.expand_trig(TR8(sp.expand(expr.replace(sp.cot, lambda a: sp.cos(a) / sp.sin(a)))))
    plain = plain.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))
    fraction = sp.expand_trig(plain).xreplace({sp.sin(angle): S, sp.cos(angle): C})
    if fraction.has(TrigonometricFunction) or angle in fraction.free_symbols:
        return expr
    back = {S: sp.sin(angle), C: sp.cos(angle)}
    return min((expr, *(f.xreplace(back) for f in _forms(fraction))), key=_effort)


def _forms(fraction: sp.Expr) -> Iterator[sp.Expr]:
    """Its numerator and denominator as polynomials in which either square is replaced by the other, cancelled."""
    above, below = sp.fraction(sp.together(fraction))
    if not above.is_polynomial(S, C) or not below.is_polynomial(S, C):
        return
    for one in _written(above):
        for other in _written(below):
            if other != 0:
                yield factored(sp.cancel(one / other))


def _written(part: sp.Expr) -> list[sp.Expr]:
    rests = (sp.rem(part, S**2 + C**2 - 1, letter) for letter in (S, C))
    return list(dict.fromkeys((part, *(sp.expand(rest) for rest in rests))))
