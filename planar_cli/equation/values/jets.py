"""A quantity with its first and second time derivative, so that a relation that holds all the time can be
differentiated.

`rate` or `second` is None where the derivative is beyond what one instant knows (the rate of an acceleration).
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record


@record
class Jet:
    """value, d/dt, d²/dt² as expressions; None: not known at one instant."""

    value: sp.Expr
    rate: sp.Expr | None = sp.S.Zero
    second: sp.Expr | None = sp.S.Zero

    def __add__(self, other: Jet) -> Jet:
        return Jet(self.value + other.value, _sum(self.rate, other.rate), _sum(self.second, other.second))

    def __neg__(self) -> Jet:
        return Jet(-self.value, _scaled(self.rate, -1), _scaled(self.second, -1))

    def __sub__(self, other: Jet) -> Jet:
        return self + (-other)

    def __mul__(self, other: Jet) -> Jet:
        rate = _sum(_product(self.rate, other.value), _product(self.value, other.rate))
        cross = _scaled(_product(self.rate, other.rate), 2)
        second = _sum(_sum(_product(self.second, other.value), cross), _product(self.value, other.second))
        return Jet(self.value * other.value, rate, second)

    def __truediv__(self, other: Jet) -> Jet:
        return self * other.power(sp.Integer(-1))

    def power(self, exponent: sp.Expr) -> Jet:
        """self^exponent with a constant exponent."""
        base = self.value
        if base == 0:
            return Jet(base**exponent, self.rate if exponent == 1 else sp.S.Zero if exponent > 1 else None, None)
        return self.chain(
            base**exponent, exponent * base ** (exponent - 1), exponent * (exponent - 1) * base ** (exponent - 2)
        )

    def chain(self, value: sp.Expr, first: sp.Expr, second: sp.Expr) -> Jet:
        """f(self) from f, f' and f'' at self.value."""
        square = _product(self.rate, self.rate)
        return Jet(value, _product(first, self.rate), _sum(_product(second, square), _product(first, self.second)))

    def through(self, function: Any) -> Jet:
        """A SymPy function of the jet."""
        if self.rate == 0 and self.second == 0:
            return Jet(function(self.value))
        x, slopes = _slopes(function)
        first, second = (slope.subs(x, self.value) for slope in slopes)
        return self.chain(function(self.value), first, second)

    def dotted(self) -> Jet:
        """The rate as a jet of its own. ValueError: it is not known at one instant."""
        if self.rate is None:
            raise ValueError("the rate is not known at one instant")
        return Jet(self.rate, self.second, None)


@lru_cache(maxsize=64)
def _slopes(function: Any) -> tuple[sp.Dummy, tuple[sp.Expr, sp.Expr]]:
    """A variable, and the first and second derivative of a function of it."""
    x = sp.Dummy("x", real=True)
    first = derivative(function(x), x)
    return x, (first, derivative(first, x))


def constant(value: Any) -> Jet:
    return Jet(sp.S(value))


def only(value: sp.Expr) -> Jet:
    """A quantity whose rate one instant does not tell."""
    return Jet(value, None, None)


def _sum(a: sp.Expr | None, b: sp.Expr | None) -> sp.Expr | None:
    return None if a is None or b is None else a + b


def _scaled(a: sp.Expr | None, factor: int) -> sp.Expr | None:
    return None if a is None else a * factor


def _product(a: sp.Expr | None, b: sp.Expr | None) -> sp.Expr | None:
    """a b, where zero times what is not known is zero."""
    if (a is not None and a == 0) or (b is not None and b == 0):
        return sp.S.Zero
    return None if a is None or b is None else a * b


def vector_jet(r: Vec, v: Vec | None, a: Vec | None) -> Vec:
    """A Vec of jets from position, velocity and acceleration."""
    return Vec(
        Jet(r.x, None if v is None else v.x, None if a is None else a.x),
        Jet(r.y, None if v is None else v.y, None if a is None else a.y),
    )


def magnitude(v: Vec) -> Jet:
    """|v| of a Vec of jets."""
    one: Jet
    if v.x.value == 0 and v.y.value == 0:
        return Jet(sp.S.Zero, None, None)
    for one, other in ((v.x, v.y), (v.y, v.x)):
        if other.value == 0 and other.rate == 0 and other.second == 0:
            return one.through(sp.Abs) if not one.value.is_positive else one
    square: Jet = v.x * v.x + v.y * v.y
    return square.power(sp.Rational(1, 2))


def direction_angle(v: Vec) -> Jet:
    """The direction of a Vec of jets; its rate is (x ẏ - y ẋ)/(x² + y²)."""
    value = sp.atan2(v.y.value, v.x.value)
    if (v.x.value == 0 and v.y.value == 0) or v.x.rate is None or v.y.rate is None:
        return only(value)
    rate: Jet = (v.x * v.y.dotted() - v.y * v.x.dotted()) / v.dot(v)
    return Jet(value, rate.value, rate.rate)


def resolved(v: Vec, unit: Vec, along: bool) -> Jet:
    """The part of a Vec of jets along a unit vector, or across it (turned by 90 deg counterclockwise)."""
    found: Jet = v.dot(unit if along else unit.turned())
    return found
