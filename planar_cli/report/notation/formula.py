"""SymPy expression in, printable formula out: a small tree that both notations write.

SymPy keeps sums and products in an order of its own; here they get a reader's order. An expression that was built
unevaluated keeps the order of its author.
"""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from planar_cli.equation.algebra.plain import simplified
from planar_cli.records import record
from planar_cli.report.notation.fractional_powers import absorbed, with_whole_powers
from planar_cli.report.notation.names import plain_name
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import in_order, term_key
from planar_cli.report.notation.whole_squares import whole_square, without_sign

Values = Mapping[sympy.Symbol, str]


@record
class Numeral:
    """A number as text, perhaps with a minus sign or a degree sign; `given`: it stands for a symbol."""

    text: str
    given: bool = False


@record
class Variable:
    """A name of the file."""

    name: str


@record
class Sum:
    """Terms; True: the term is subtracted."""

    terms: tuple[tuple[bool, Formula], ...]


@record
class Negative:
    inside: Formula


@record
class Product:
    factors: tuple[Formula, ...]


@record
class Quotient:
    above: Formula
    below: Formula


@record
class Power:
    base: Formula
    exponent: Formula


@record
class Root:
    inside: Formula


@record
class Bars:
    """An absolute value."""

    inside: Formula


@record
class Call:
    """A function of arguments, raised to a power (1: not raised); `bare` if it needs no brackets: cos θ."""

    function: str
    arguments: tuple[Formula, ...]
    exponent: int
    bare: bool


@record
class Compared:
    """An equation or inequality."""

    left: Formula
    relation: str
    right: Formula


@record
class Pieces:
    """A formula in pieces, each with its condition (None: in all other cases)."""

    pieces: tuple[tuple[Formula, Formula | None], ...]


@record
class Integration:
    """A definite integral over a variable."""

    inside: Formula
    variable: Formula
    lower: Formula
    upper: Formula


Formula = (
    Numeral
    | Variable
    | Sum
    | Negative
    | Product
    | Quotient
    | Power
    | Root
    | Bars
    | Call
    | Compared
    | Pieces
    | Integration
)

_ONE = Numeral("1")
_NAMES_OF_NUMBERS = {sympy.pi: "π", sympy.E: "e", sympy.oo: "∞", sympy.I: "i"}
_RELATIONS = {"==": "=", "!=": "≠", "<": "<", "<=": "≤", ">": ">", ">=": "≥"}
_ANGULAR = frozenset({"sin", "cos", "tan", "cot", "sec", "csc"})
_FUNCTIONS = {
    **{f"a{f}": f"arc{f}" for f in ("sin", "cos", "tan")},
    **{f"a{f}h": f"ar{f}h" for f in ("sin", "cos", "tan")},
    "atan2": "atan2",
    "log": "ln",
    "Max": "max",
    "Min": "min",
}
# Coefficients such as 2/5 (a sphere) and 5/12 (a plate) are read as fractions, 0.45 as a decimal number.
_FRACTION_DENOMINATORS = frozenset({2, 3, 4, 5, 6, 7, 8, 9, 12, 16, 18, 24, 32, 48, 64})
_LONG, _FIGURES_OF_LONG = 7, 6


def read(expr: Any, values: Values | None = None) -> Formula:
    """The formula of an expression; `values` are texts to stand for symbols."""
    return _Reader(values or {}).read(sympy.sympify(expr))


class _Reader:
    """Reads one expression; `values` stand for symbols."""

    def __init__(self, values: Values) -> None:
        self.values = values

    def read(self, expr: Any) -> Formula:
        if expr.is_Symbol:
            text = self.values.get(expr)
            return Variable(expr.name) if text is None else Numeral(text, given=True)
        if expr in _NAMES_OF_NUMBERS:
            return Numeral(_NAMES_OF_NUMBERS[expr])
        if expr.is_Number:
            return number(expr)
        if expr.is_Add:
            return self._sum(expr)
        if expr.is_Mul:
            return self._product(factors_of(expr))
        if expr.is_Pow:
            return self._product([expr]) if _is_below(expr) or _is_root(expr) else self._power(expr)
        if expr.is_Relational:
            return Compared(self.read(expr.lhs), _RELATIONS[expr.rel_op], self.read(expr.rhs))
        return self._function(expr, 1)

    def _sum(self, expr: Any) -> Formula:
        terms = sorted(expr.args, key=lambda t: (is_negative(t), term_key(t))) if is_canonical(expr) else expr.args
        read = [self.read(whole_square(t)) for t in terms]
        return Sum(tuple((True, r.inside) if isinstance(r, Negative) else (False, r) for r in read))

    def _product(self, factors: list[Any], together: bool = False) -> Formula:
        split = _Split(with_whole_powers(factors))
        above = [self._power(f) for f in split.above]
        below = [self._power(f) for f in split.below]
        if split.root_above and (split.root_below or not _all_numbers(split.root_above)):
            inside = self._product(split.root_above + [1 / f for f in split.root_below], together=True)
            above.insert(_place_of_root(above), Root(inside))
        else:
            above[:0] = [Root(self._product(split.root_above))] if split.root_above else []
            below += [Root(self._product(split.root_below))] if split.root_below else []
        whole = _with_coefficient(abs(split.coefficient), above, below, together)
        return Negative(whole) if split.coefficient < 0 else whole

    def _power(self, expr: Any) -> Formula:
        if not expr.is_Pow:
            return self.read(expr)
        base, exponent = expr.args
        if base.func.__name__ in _ANGULAR and exponent.is_Integer and exponent > 1:
            return self._function(base, int(exponent))
        inside = self.read(without_sign(base) if exponent.is_even else base)
        if isinstance(inside, Numeral) and inside.given and exponent.is_even:
            inside = Numeral(inside.text.removeprefix("-"), given=True)  # (-3)² is 3²
        return Power(inside, self.read(exponent))

    def _function(self, expr: Any, exponent: int) -> Formula:
        if isinstance(expr, sympy.Abs):
            return Bars(self.read(expr.args[0]))
        if isinstance(expr, sympy.Piecewise):
            return Pieces(tuple((self.read(e), None if c == sympy.true else self.read(c)) for e, c in expr.args))
        if isinstance(expr, sympy.Integral):
            return self._integral(expr)
        name = expr.func.__name__
        if isinstance(expr, AppliedUndef):
            return Variable(name)
        if isinstance(expr, sympy.Tuple):
            return Call("", tuple(self.read(a) for a in expr.args), 1, False)
        if name in _ANGULAR:
            argument = self._angle(expr.args[0])
            return Call(name, (argument,), exponent, _needs_no_brackets(argument))
        return Call(
            _FUNCTIONS.get(name, name), tuple(self.read(a) for a in expr.args if not _is_deep(a)), exponent, False
        )

    def _integral(self, expr: Any) -> Formula:
        """Of several variables the innermost is written first."""
        found = self.read(expr.function)
        for variable, lower, upper in expr.limits:
            found = Integration(found, Variable(variable.name), self.read(lower), self.read(upper))
        return found

    def _angle(self, expr: Any) -> Formula:
        """An argument of a trigonometric function, with multiples of π in degrees."""
        if expr.is_number and expr.has(sympy.pi):
            return _degrees(expr)
        if not expr.is_Add:
            return self.read(expr)
        terms = sorted(expr.args, key=lambda t: (is_negative(t), bool(t.is_number), term_key(t)))
        read = [self._angle(t) for t in terms]
        return Sum(tuple((True, r.inside) if isinstance(r, Negative) else (False, r) for r in read))


class _Split:
    """The factors of a product, sorted into coefficient, numerator, denominator and what stands under a root."""

    def __init__(self, factors: list[Any]) -> None:
        self.coefficient: Any = sympy.Integer(1)
        self.above: list[Any] = []
        self.below: list[Any] = []
        self.root_above: list[Any] = []
        self.root_below: list[Any] = []
        for factor in factors:
            self._take(factor)
        beside = bool(self.above or self.below)
        self.coefficient, self.root_above = absorbed(self.coefficient, self.root_above, self.root_below, beside)

    def _take(self, factor: Any) -> None:
        if factor.is_Rational or factor.is_Float:
            self.coefficient *= factor
        elif _is_root(factor):
            (self.root_below if _is_below(factor) else self.root_above).extend(factors_of(factor.base))
        elif _is_below(factor):
            self.below.append(1 / factor if factor.exp == -1 else sympy.Pow(factor.base, -factor.exp, evaluate=False))
        else:
            self.above.append(factor)


def number(expr: Any) -> Formula:
    """A rational or floating-point number."""
    if expr.is_Rational:
        shown = _rational(abs(expr), coefficient=False)
    else:
        shown = Numeral(significant(Decimal(str(abs(expr))), _FIGURES_OF_LONG))
    return Negative(shown) if expr.is_negative else shown


def factors_of(expr: Any) -> list[Any]:
    """The factors of a product in reading order; nested products are opened, their author's order kept."""
    if not expr.is_Mul:
        return [expr]
    if is_canonical(expr):
        return in_order(expr.args)
    return [f for arg in expr.args for f in factors_of(arg)]


def is_canonical(expr: Any) -> bool:
    """True if SymPy itself would arrange the arguments so: then the order says nothing of the author."""
    rebuilt = expr.func(*expr.args)
    return bool(rebuilt.func is expr.func and rebuilt.args == expr.args)


def is_negative(expr: Any) -> bool:
    """True if a term prints with a minus sign."""
    if expr.is_Mul:
        return sum(is_negative(f) for f in expr.args if f.is_Number or f.is_Mul) % 2 == 1
    return bool(expr.is_Number and expr.is_negative)


_TENTHS = 10
_DECIMALS = 6
_LARGEST_PART = 10_000
"""A rational that does not end within so many decimals stays a fraction if its parts are smaller than this."""


def _rational(value: Any, coefficient: bool) -> Formula:
    """A positive rational: whole, fraction or decimal, whatever is shortest to read."""
    if value.q == 1:
        return Numeral(_digits(value))
    fraction = value.q in _FRACTION_DENOMINATORS and value.p < 100
    endless = 10**_DECIMALS % value.q != 0 and value.p < _LARGEST_PART and value.q < _LARGEST_PART
    if endless or (fraction and (coefficient or value.q % 5)):
        return Quotient(Numeral(str(value.p)), Numeral(str(value.q)))
    return Numeral(_digits(value))


def _digits(value: Any) -> str:
    decimal = Decimal(int(value.p)) / Decimal(int(value.q))
    if value.q == 1 and len(str(value.p)) <= _LONG:
        return str(value.p)
    return significant(decimal, _FIGURES_OF_LONG)


def _with_coefficient(q: Any, above: list[Formula], below: list[Formula], together: bool) -> Formula:
    """Coefficient, numerator and denominator as one formula: 5 g/6, 1/2 m v², 3 g/(2 L); `together`: one fraction."""
    if not above and not below:
        return number(q)
    coefficient = _rational(q, coefficient=True) if q.is_Rational else number(q)
    if q.is_Rational and q.q == _TENTHS and q.p < _TENTHS and any(isinstance(f, Variable) for f in below):
        # 7 J²/(10 m): one fraction.
        coefficient = Quotient(Numeral(str(q.p)), Numeral(str(q.q)))
    if not isinstance(coefficient, Quotient):
        above = above if coefficient == _ONE else [coefficient, *above]
        return Quotient(_times(above), _times(below)) if below else _times(above)
    numbers = [f for f in above if _is_numeric(f)]
    letters = [f for f in above if not _is_numeric(f)]
    if coefficient.above != _ONE:
        numbers.insert(0, coefficient.above)
    alone = len(letters) == 1 and not _stands_apart(letters[0], coefficient)
    if together or below or not letters or alone:
        return Quotient(_times([*numbers, *letters]), _times([coefficient.below, *below]))
    return _times([Quotient(_times(numbers), coefficient.below), *letters])


def _stands_apart(node: Formula, coefficient: Quotient) -> bool:
    """Does a number stand before it as a fraction: 1/2 sin β, 1/2 v², 4/5 v_B/A, whose name has a stroke of its own?"""
    squared = isinstance(node, Power) and coefficient.below == Numeral("2")
    return isinstance(node, Call) or squared or (isinstance(node, Variable) and "/" in plain_name(node.name))


def _is_numeric(node: Formula) -> bool:
    """True for numbers of the formula itself, which join its coefficient."""
    inside = node.inside if isinstance(node, Root) else node
    return isinstance(inside, Numeral) and not inside.given


def _times(factors: list[Formula]) -> Formula:
    if not factors:
        return _ONE
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _place_of_root(above: list[Formula]) -> int:
    """A root stands after the letters, before functions without brackets."""
    return next((i for i, f in enumerate(above) if isinstance(f, Call) and f.bare), len(above))


def _degrees(expr: Any) -> Formula:
    degrees = simplified(expr * 180 / sympy.pi)
    shown = Numeral(significant(Decimal(str(sympy.N(abs(degrees), 20))), 5) + "°")
    return Negative(shown) if degrees.is_negative else shown


def _needs_no_brackets(argument: Formula) -> bool:
    match argument:
        case Variable():
            return True
        case Numeral(text):
            return not text.startswith("-") and (text.endswith("°") or text == "π")
    return False


def _is_below(expr: Any) -> bool:
    return bool(expr.is_Pow and expr.exp.is_Rational and expr.exp.is_negative)


def _is_root(expr: Any) -> bool:
    return bool(expr.is_Pow and abs(expr.exp) == sympy.Rational(1, 2))


def _all_numbers(factors: list[Any]) -> bool:
    return all(f.is_Number for f in factors)


def _is_deep(argument: Any) -> bool:
    """Arguments that are no formulas (pairs of a piecewise function) are left out."""
    return not isinstance(argument, sympy.Expr)
