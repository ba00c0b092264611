"""Values of expressions to sixty digits, and the decisions that rest on them: zero, sign, order.

A decision is never taken on a machine float. An expression counts as zero when it vanishes to `CERTAIN` digits relative
to the size of its own terms; where letters without a number occur, it must vanish for two independent draws of them.
"""

from __future__ import annotations

import decimal
from collections.abc import Callable, Mapping
from decimal import Decimal
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp

DIGITS = 60
CERTAIN = Decimal(10) ** -40
decimal.getcontext().prec = DIGITS
ZERO = Decimal(0)
ONE = Decimal(1)
REMEMBERED = 10_000
"""So many sines and the like are kept: the same few angles are asked again and again."""

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")


def _through_mpmath(function: str) -> Callable[[Decimal], Decimal]:
    @lru_cache(maxsize=REMEMBERED)
    def call(x: Decimal) -> Decimal:
        with mpmath.workdps(DIGITS + 5):
            return Decimal(mpmath.nstr(getattr(mpmath, function)(mpmath.mpf(str(x))), DIGITS + 2))

    return call


@lru_cache(maxsize=REMEMBERED)
def _atan2(y: Decimal, x: Decimal) -> Decimal:
    with mpmath.workdps(DIGITS + 5):
        return Decimal(mpmath.nstr(mpmath.atan2(mpmath.mpf(str(y)), mpmath.mpf(str(x))), DIGITS + 2))


FUNCTIONS: dict[type, Callable[..., Decimal]] = {
    sp.sin: _through_mpmath("sin"),
    sp.cos: _through_mpmath("cos"),
    sp.tan: _through_mpmath("tan"),
    sp.asin: _through_mpmath("asin"),
    sp.acos: _through_mpmath("acos"),
    sp.atan: _through_mpmath("atan"),
    sp.atan2: _atan2,
    sp.exp: Decimal.exp,
    sp.log: Decimal.ln,
    sp.Abs: abs,
    sp.sign: lambda x: ZERO if not x else ONE.copy_sign(x),
    sp.Max: max,
    sp.Min: min,
}


class Unvalued(LookupError):
    """A symbol has no value in this valuation."""


class Valuation:
    """Numbers for symbols, and through them for any expression; results are remembered.

    `values`: decimals by symbol. `definitions`: expressions by symbol, evaluated when first needed.
    """

    def __init__(
        self, values: Mapping[sp.Symbol, Decimal], definitions: Mapping[sp.Symbol, sp.Expr] | None = None
    ) -> None:
        self.values: dict[sp.Symbol, Decimal] = dict(values)
        self.definitions = definitions if definitions is not None else {}
        self._known: dict[Any, Decimal] = {}

    def extended(self, more: Mapping[sp.Symbol, Decimal]) -> Valuation:
        """A new valuation with some more (or other) values."""
        return Valuation({**self.values, **more}, self.definitions)

    def __call__(self, expr: Any) -> Decimal:
        """The value of an expression. Unvalued: a symbol has none; ArithmeticError: it has no real value."""
        if isinstance(expr, int):
            return Decimal(expr)
        known = self._known.get(expr)
        if known is None:
            known = self._known[expr] = self._evaluate(expr)
        return known

    def _evaluate(self, expr: Any) -> Decimal:
        if expr.is_Rational:
            return Decimal(int(expr.p)) / Decimal(int(expr.q))
        if expr.is_Symbol:
            return self._symbol(expr)
        if expr.is_Add:
            return sum((self(a) for a in expr.args), ZERO)
        if expr.is_Mul:
            product = ONE
            for a in expr.args:
                product *= self(a)
            return product
        if expr.is_Pow:
            return power(self(expr.base), expr.exp, self)
        if expr is sp.pi:
            return +PI
        if expr is sp.E:
            return ONE.exp()
        function = FUNCTIONS.get(expr.func)
        if function is None:
            raise ArithmeticError(f"{expr.func.__name__} has no real value here")
        return function(*(self(a) for a in expr.args))

    def _symbol(self, symbol: sp.Symbol) -> Decimal:
        value = self.values.get(symbol)
        if value is None:
            definition = self.definitions.get(symbol)
            if definition is None:
                raise Unvalued(str(symbol))
            return self(definition)
        return value

    def size(self, expr: Any) -> Decimal:
        """The size of the terms of an expression: what a remainder is measured against."""
        if getattr(expr, "is_Add", False):
            return sum((self.size(a) for a in expr.args), ZERO)
        if getattr(expr, "is_Mul", False):
            product = ONE
            for a in expr.args:
                product *= self.size(a)
            return product
        if getattr(expr, "is_Pow", False) and expr.exp.is_Integer and expr.exp > 0:
            return self.size(expr.base) ** int(expr.exp)
        return abs(self(expr))

    def is_zero(self, expr: Any) -> bool:
        """Does the expression vanish to all certain digits?"""
        value = self(expr)
        return not value or abs(value) <= CERTAIN * max(self.size(expr), CERTAIN)


def power(base: Decimal, exponent: Any, value: Valuation) -> Decimal:
    """base^exponent; integer and half-integer exponents without logarithms."""
    if exponent.is_Integer:
        return base ** int(exponent)
    if exponent.is_Rational and exponent.q == 2:
        if base < 0:
            if abs(base) < CERTAIN:
                return ZERO
            raise ArithmeticError("square root of a negative number")
        return base.sqrt() ** int(exponent.p)
    if base < 0:
        raise ArithmeticError("root of a negative number")
    return base ** value(exponent)
