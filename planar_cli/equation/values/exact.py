"""Values of expressions to sixty digits, and the decisions that rest on them: zero, sign, order.

A decision is never taken on a machine float. An expression counts as zero when it vanishes to `CERTAIN` digits relative
to the size of its own terms; where letters without a number occur, it must vanish for two independent draws of them.
"""

from __future__ import annotations

import decimal
import math
import operator
from collections.abc import Callable, Container, Mapping
from decimal import Decimal
from functools import lru_cache
from itertools import pairwise
from typing import Any, NewType

import mpmath
import sympy as sp

from planar_cli.equation.algebra.quadrature import breaks, quad, switching, to_decimal
from planar_cli.errors import NoValue

DIGITS = 60
CERTAIN = Decimal(10) ** -40
decimal.getcontext().prec = DIGITS
ZERO = Decimal(0)
ONE = Decimal(1)
REMEMBERED = 10_000
"""So many sines and the like are kept: the same few angles are asked again and again."""

OF_INTEGRAL, AT_TURNING = 44, 25
"""Certain digits of an integral, and of one whose integrand grows without bound at an end."""
ROUGHLY = 13, 10
"""The same where it is only to be told whether something holds."""

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899862803")
ROUNDED = Decimal(10) ** (8 - DIGITS)  # angles that differ by less than this part of them are one


def _through_mpmath(function: str, zeros: bool = False) -> Callable[[Decimal], Decimal]:
    """`zeros`: it vanishes where of it only the rounding of the angle is left."""

    @lru_cache(maxsize=REMEMBERED)
    def call(x: Decimal) -> Decimal:
        with mpmath.workdps(DIGITS + 5):
            value = getattr(mpmath, function)(mpmath.mpf(str(x)) if x.is_finite() else math.copysign(math.inf, x))
            if mpmath.isnan(value):
                raise NoValue(f"{function} has no value at {x}")
            found = Decimal(mpmath.nstr(value, DIGITS + 2))
            return ZERO if zeros and abs(found) < ROUNDED * abs(x) else found

    return call


def _to_one(function: str) -> Callable[[Decimal], Decimal]:
    """asin and acos: an argument that is ±1 to all certain digits counts as ±1."""
    call = _through_mpmath(function)
    return lambda x: call(ONE.copy_sign(x) if 1 < abs(x) < 1 + CERTAIN else x)


@lru_cache(maxsize=REMEMBERED)
def _atan2(y: Decimal, x: Decimal) -> Decimal:
    with mpmath.workdps(DIGITS + 5):
        return Decimal(mpmath.nstr(mpmath.atan2(mpmath.mpf(str(y)), mpmath.mpf(str(x))), DIGITS + 2))


FUNCTIONS: dict[type, Callable[..., Decimal]] = {
    sp.sin: _through_mpmath("sin", zeros=True),
    sp.cos: _through_mpmath("cos", zeros=True),
    sp.tan: _through_mpmath("tan", zeros=True),
    sp.cot: _through_mpmath("cot", zeros=True),  # SymPy writes them where it reduces fractions
    sp.sec: _through_mpmath("sec"),
    sp.csc: _through_mpmath("csc"),
    sp.asin: _to_one("asin"),
    sp.acos: _to_one("acos"),
    sp.atan: _through_mpmath("atan"),
    sp.atan2: _atan2,
    sp.sinh: _through_mpmath("sinh"),
    sp.cosh: _through_mpmath("cosh"),
    sp.tanh: _through_mpmath("tanh"),
    sp.asinh: _through_mpmath("asinh"),
    sp.acosh: _through_mpmath("acosh"),
    sp.atanh: _through_mpmath("atanh"),
    sp.exp: Decimal.exp,
    sp.log: Decimal.ln,
    sp.Abs: abs,
    sp.sign: lambda x: ZERO if not x else ONE.copy_sign(x),
    sp.Max: max,
    sp.Min: min,
}


SLOPES: dict[type, Callable[[Decimal], Decimal]] = {
    sp.sin: FUNCTIONS[sp.cos],
    sp.cos: FUNCTIONS[sp.sin],
    sp.tan: lambda x: ONE + FUNCTIONS[sp.tan](x) ** 2,
}
"""The sizes of the derivatives of functions that vanish at more than one place."""

COMPARISONS: dict[type, Callable[[Decimal, Decimal], bool]] = {
    sp.StrictLessThan: operator.lt,
    sp.LessThan: operator.le,
    sp.StrictGreaterThan: operator.gt,
    sp.GreaterThan: operator.ge,
    sp.Equality: operator.eq,
    sp.Unequality: operator.ne,
}


Settled = NewType("Settled", Decimal)
"""An SI number that the file fixes, made by `Valuation.settled` alone: what answers consist of."""


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
        self._sizes: dict[Any, Decimal] = {}
        self._of_integrals = OF_INTEGRAL, AT_TURNING

    def roughly(self) -> Valuation:
        """The same values, with integrals to fewer digits: to tell whether something holds, not to answer."""
        rough = Valuation(self.values, self.definitions)
        rough._of_integrals = ROUGHLY
        return rough

    def extended(self, more: Mapping[sp.Symbol, Decimal]) -> Valuation:
        """A new valuation with some more (or other) values; a letter that was drawn stays one that was."""
        return Valuation({**self.values, **more}, self.definitions)

    def without(self, gone: Container[sp.Symbol]) -> Valuation:
        """A new valuation in which these symbols have no value of their own."""
        return Valuation({s: v for s, v in self.values.items() if s not in gone}, self.definitions)

    def knowing(self, found: Mapping[sp.Symbol, Decimal]) -> Valuation:
        """A new valuation with values that were worked out, also of what was drawn before."""
        return self.without(found).extended(found)

    def updated(self, other: Valuation) -> Valuation:
        """A new valuation with the values of another, which knows the same definitions."""
        return _of({**self.values, **other.values}, self.definitions, other.drawn)

    def defining(self, more: Mapping[sp.Symbol, sp.Expr]) -> Valuation:
        """A new valuation that knows more symbols by expressions."""
        return _of(self.values, {**more, **self.definitions}, self.drawn)

    @property
    def drawn(self) -> frozenset[sp.Symbol]:
        """The symbols whose values mean nothing, as they were drawn."""
        return frozenset()

    def settled(self, expr: Any, closed: Any) -> Settled:
        """The number of an answer. `closed`: the same as a formula, as far down to the names of the file as there is
        one. Unvalued: numbers that were drawn would have to tell it.
        """
        if expr in (sp.oo, -sp.oo):
            return Settled(Decimal("Infinity") if expr == sp.oo else Decimal("-Infinity"))
        number = self(expr)
        return Settled(ZERO if number and self.is_zero(expr) else number)

    def __call__(self, expr: Any) -> Decimal:
        """The value of an expression. Unvalued: a symbol has none; NoValue: it has no real value."""
        if isinstance(expr, int):
            return Decimal(expr)
        known = self._known.get(expr)
        if known is None:
            try:
                known = self._known[expr] = self._evaluate(expr)
            except decimal.DecimalException as error:
                raise NoValue("a formula has no real value here") from error
        return known

    def known(self, expr: Any) -> Decimal | None:
        """The value of an expression; None where it has none: a symbol has none, or it is not real here."""
        try:
            return self(expr)
        except (Unvalued, NoValue):
            return None

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
            if isinstance(expr, sp.Piecewise):
                return self(next((e for e, c in expr.args if self.holds(c)), sp.nan))
            if isinstance(expr, sp.Integral):
                return integral(expr, self, *self._of_integrals)
            raise NoValue(f"{expr.func.__name__} has no real value here")
        return function(*(self(a) for a in expr.args))

    def _symbol(self, symbol: sp.Symbol) -> Decimal:
        value = self.values.get(symbol)
        if value is None:
            definition = self.definitions.get(symbol)
            if definition is None:
                raise Unvalued(str(symbol))
            return self(definition)
        return value

    def holds(self, condition: Any) -> bool:
        """Does a condition of comparisons hold?"""
        if condition in (sp.true, sp.false):
            return bool(condition)
        if isinstance(condition, sp.And | sp.Or):
            return (all if isinstance(condition, sp.And) else any)(self.holds(a) for a in condition.args)
        if isinstance(condition, sp.Not):
            return not self.holds(condition.args[0])
        compare = COMPARISONS.get(condition.func)
        if compare is None:
            raise NoValue(f"{condition} is no comparison")
        return compare(self(condition.lhs), self(condition.rhs))

    def size(self, expr: Any) -> Decimal:
        """The size of the terms of an expression: what a remainder is measured against. NoValue: it has none."""
        known = self._sizes.get(expr)
        if known is None:
            try:
                known = self._sizes[expr] = self._size(expr)
            except decimal.DecimalException as error:
                raise NoValue("a formula has no real value here") from error
        return known

    def _size(self, expr: Any) -> Decimal:
        if getattr(expr, "is_Add", False):
            return sum((self.size(a) for a in expr.args), ZERO)
        if getattr(expr, "is_Mul", False):
            product = ONE
            for a in expr.args:
                product *= self.size(a)
            return product
        if getattr(expr, "is_Pow", False) and expr.exp.is_Integer and expr.exp > 0:
            return self.size(expr.base) ** int(expr.exp)
        slope = SLOPES.get(getattr(expr, "func", type(None)))
        if slope is not None:
            # What is lost in the argument is lost in the value: cos(pi/2) is no small number, it is zero.
            return abs(self(expr)) + self.size(expr.args[0]) * abs(slope(self(expr.args[0])))
        return abs(self(expr))

    def is_zero(self, expr: Any) -> bool:
        """Does the expression vanish to all certain digits?"""
        value = self(expr)
        return not value or abs(value) <= CERTAIN * max(self.size(expr), CERTAIN)

    def vanishes(self, expr: Any) -> bool:
        """Has the expression a value, and is it zero to all certain digits?"""
        return self.known(expr) is not None and self.is_zero(expr)


class Sample(Valuation):
    """Numbers where some letters have none: these are `drawn`, and stand for any.

    It tells what vanishes, what is larger, which root it is. It is no answer: whatever was worked out beside letters
    that were drawn may rest on them, so that only a formula in names with numbers settles something.
    """

    def __init__(
        self,
        values: Mapping[sp.Symbol, Decimal],
        definitions: Mapping[sp.Symbol, sp.Expr],
        drawn: frozenset[sp.Symbol],
    ) -> None:
        super().__init__(values, definitions)
        self._drawn = drawn

    @property
    def drawn(self) -> frozenset[sp.Symbol]:
        return self._drawn

    def extended(self, more: Mapping[sp.Symbol, Decimal]) -> Sample:
        return Sample({**self.values, **more}, self.definitions, self._drawn)

    def without(self, gone: Container[sp.Symbol]) -> Valuation:
        left = {s: v for s, v in self.values.items() if s not in gone}
        return _of(left, self.definitions, frozenset(s for s in self._drawn if s not in gone))

    def updated(self, other: Valuation) -> Valuation:
        drawn = self._drawn.difference(other.values) | other.drawn
        return _of({**self.values, **other.values}, self.definitions, drawn)

    def settled(self, expr: Any, closed: Any) -> Settled:
        return Valuation({}, self.definitions).settled(closed, closed)


def _of(
    values: Mapping[sp.Symbol, Decimal], definitions: Mapping[sp.Symbol, sp.Expr], drawn: frozenset[sp.Symbol]
) -> Valuation:
    return Sample(values, definitions, drawn) if drawn else Valuation(values, definitions)


def power(base: Decimal, exponent: Any, value: Valuation) -> Decimal:
    """base^exponent; integer and half-integer exponents without logarithms."""
    if exponent.is_Integer:
        return base ** int(exponent)
    if exponent.is_Rational and exponent.q == 2:
        if base < 0:
            if abs(base) < CERTAIN:
                return ZERO
            raise NoValue("square root of a negative number")
        return base.sqrt() ** int(exponent.p)
    if base < 0:
        raise NoValue("root of a negative number")
    return base ** value(exponent)


def integral(expr: sp.Integral, value: Valuation, digits: int, at_least: int) -> Decimal:
    """The value of a definite integral over one variable, with so many certain digits, or so many at least."""
    if [len(limit) for limit in expr.limits] != [3]:
        raise NoValue("an integral without two limits")
    x, start, end = expr.limits[0]
    # The rest has the same value for many letters, and is worked out once.
    factor, rest = expr.function.as_independent(x, as_Add=False)
    letters = tuple((s, value(s)) for s in sorted(rest.free_symbols - {x}, key=lambda s: s.name))
    found = _integral(rest, x, value(start), value(end), letters, digits, at_least)
    if isinstance(found, ArithmeticError):
        raise type(found)(*found.args)
    return value(factor) * found


@lru_cache(maxsize=REMEMBERED)
def _integral(
    function: sp.Expr,
    x: sp.Symbol,
    low: Decimal,
    high: Decimal,
    inside: tuple[tuple[sp.Symbol, Decimal], ...],
    most: int,
    least: int,
) -> Decimal | ArithmeticError:
    """The same with the values of letters; or why there is none, which takes longest to find.

    A root has a corner where what stands under it touches zero: among the places where that is stationary.
    """
    rest = Valuation(dict(inside))
    plain = [s for s in switching(function) if s.has(x)]
    roots = [sp.diff(p.base, x) for p in function.atoms(sp.Pow) if not p.exp.is_integer and p.base.has(x)]
    f = _along(function, x, rest)

    def g(point: Any) -> Any:
        return mpmath.mpf(str(f(to_decimal(point))))

    tries = [(most, plain), *([(most, [*plain, *roots])] if roots else []), (least, plain)]
    for digits, switches in tries:
        try:
            places = breaks([_along(s, x, rest) for s in switches], low, high)
            return sum((quad(g, a, b, digits) for a, b in pairwise(places)), ZERO)
        except ArithmeticError as error:
            if digits == least:
                return error.with_traceback(None)
    return ZERO


def _along(expr: sp.Expr, x: sp.Symbol, rest: Valuation) -> Callable[[Decimal], Decimal]:
    """An expression as a function of x; what does not hold x is worked out once."""
    known: dict[Any, Decimal] = {}

    def look(part: sp.Expr) -> None:
        """NoValue: a part has no value, whatever x is."""
        if not part.has(x):
            known[part] = rest(part)
        elif isinstance(part, sp.Expr) and not isinstance(part, sp.Piecewise | sp.Integral):
            for a in part.args:
                look(a)

    look(expr)

    def at(point: Decimal) -> Decimal:
        here = Valuation({**rest.values, x: +point})
        here._known.update(known)
        return here(expr)

    return at
