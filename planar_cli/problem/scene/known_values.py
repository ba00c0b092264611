"""What the formulas of a file amount to where all their names have numbers: the size of the number, or why it is none.

Rational numbers stay exact; anything else is a float with a bound of its rounding, so that a difference that only
rounding keeps from zero is neither called negative nor positive. Nothing larger than LARGEST is ever computed.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Binary, Function, Grouped, Name, Negate, Number, Scaled, Side
from planar_cli.problem.language.limits import MAX_EXP
from planar_cli.problem.scene.scene import Symbol
from planar_cli.records import record
from planar_cli.units import UnitError, parse_unit

BITS = 20_000
"""So long may a numerator or denominator become on the way."""
LARGEST = 1e300
LARGEST_ANGLE = 1e9
"""rad; of a larger one hardly a digit of its direction is left in the numbers of a machine."""
ROUNDING = 4 * 2.0**-52


@record
class Rough:
    """A number that is not rational, or not told as such: within `doubt` of `value`."""

    value: float
    doubt: float


Known = Fraction | Rough


class NoNumber(Exception):
    """A formula has no real, finite value; `text` says why, `mark` where."""

    def __init__(self, mark: Mark, code: str, text: str, hint: str = "") -> None:
        super().__init__(text)
        self.mark, self.code, self.text, self.hint = mark, code, text, hint


class KnownValues:
    """Evaluates sides in SI units; None where a letter, a quantity or the time has its part in it.

    The names must not go in long chains (chains.py).
    """

    def __init__(self, names: Mapping[str, Symbol]) -> None:
        self.names = names
        self._found: dict[str, Known | None] = {}

    def value(self, side: Side) -> Known | None:
        """The value. Raises NoNumber."""
        match side:
            case Number():
                return _in_si(side.value * side.sense, side.unit)
            case Scaled():
                return _product(self.value(side.operand), _in_si(Fraction(side.sense), side.unit))
            case Negate():
                return _negative(self.value(side.operand))
            case Name():
                return self._named(side)
            case Grouped():
                return self.value(side.operand)
            case Function():
                return _called(side, self.value(side.argument))
            case Binary():
                return _combined(side, self.value(side.left), self.value(side.right))
            case _:
                return None

    def number(self, side: Side) -> float | None:
        """The value as a plain number; None also where there is none."""
        try:
            found = self.value(side)
        except NoNumber:
            return None
        return None if found is None else found.value if isinstance(found, Rough) else float(found)

    def _named(self, name: Name) -> Known | None:
        if name.name == "infinity":
            text = "`infinity` is no number to calculate with"
            raise NoNumber(name.mark, "PL217", text, "a state may say `t = infinity`, or so of a coordinate")
        if name.name == "pi":
            return Rough(math.pi, ROUNDING)
        symbol = self.names.get(name.name)
        if symbol is None or symbol.value is None or name.at is not None:
            return None
        if name.name not in self._found:
            # What goes in a circle has no value (PL436).
            self._found[name.name] = None
            try:
                self._found[name.name] = self.value(symbol.value)
            except NoNumber:
                return None  # It is told where the name is defined.
        return self._found[name.name]


def order(value: Known) -> int | None:
    """The power of ten that is next to a value; None for zero."""
    if isinstance(value, Rough):
        return round(math.log10(abs(value.value))) if value.value else None
    if not value:
        return None
    return round((value.numerator.bit_length() - value.denominator.bit_length()) * math.log10(2))


def _rough(value: Known) -> Rough:
    """As a float; NoNumber is for the caller, who knows the place: OverflowError."""
    if isinstance(value, Rough):
        return value
    number = float(value)
    return Rough(number, ROUNDING * abs(number))


def _in_si(number: Fraction, unit: str | None) -> Known | None:
    if unit is None:
        return number
    try:
        known = parse_unit(unit)
    except UnitError:
        return None
    number *= known.factor
    if not known.pi_power:
        return number
    turned = float(number) * math.pi**known.pi_power
    return Rough(turned, ROUNDING * abs(turned))


def _negative(value: Known | None) -> Known | None:
    return Rough(-value.value, value.doubt) if isinstance(value, Rough) else None if value is None else -value


def _product(left: Known | None, right: Known | None) -> Known | None:
    if left is None or right is None:
        return None
    if isinstance(left, Fraction) and isinstance(right, Fraction):
        return left * right
    a, b = _rough(left), _rough(right)
    value = a.value * b.value
    return Rough(value, abs(a.value) * b.doubt + abs(b.value) * a.doubt + ROUNDING * abs(value))


def _sum(left: Known, right: Known) -> Known:
    if isinstance(left, Fraction) and isinstance(right, Fraction):
        return left + right
    a, b = _rough(left), _rough(right)
    return Rough(a.value + b.value, a.doubt + b.doubt + ROUNDING * (abs(a.value) + abs(b.value)))


def _inverse(value: Known) -> Known:
    """1/value, not of zero."""
    if isinstance(value, Fraction):
        return 1 / value
    inverse = 1 / value.value
    return Rough(inverse, inverse * inverse * value.doubt + ROUNDING * abs(inverse))


def _combined(side: Binary, left: Known | None, right: Known | None) -> Known | None:
    if left is None or right is None:
        return None
    if (side.operator == "/" and _vanishes(right)) or (side.operator == "^" and _vanishes(left) and _below_zero(right)):
        raise NoNumber(side.mark, "PL505", "division by zero", "correct a number: what it is divided by comes to 0")
    try:
        match side.operator:
            case "+":
                found: Known | None = _sum(left, right)
            case "-":
                found = _sum(left, _negative(right) or Fraction(0))
            case "*":
                found = _product(left, right)
            case "/":
                found = _product(left, _inverse(right))
            case _:
                found = _power(side, left, right)
    except (OverflowError, ZeroDivisionError):
        raise _too_large(side.mark) from None
    return _bounded(found, side.mark)


def _vanishes(value: Known) -> bool:
    """Is it zero, or nothing but rounding, as the cosine of a right angle?"""
    return abs(value.value) <= value.doubt if isinstance(value, Rough) else value == 0


def _below_zero(value: Known) -> bool:
    return (value.value + value.doubt if isinstance(value, Rough) else value) < 0


def _bounded(value: Known | None, mark: Mark) -> Known | None:
    if isinstance(value, Fraction):
        if max(value.numerator.bit_length(), value.denominator.bit_length()) > BITS:
            raise _too_large(mark)
    elif value is not None and not (math.isfinite(value.value) and abs(value.value) < LARGEST):
        raise _too_large(mark)
    return value


def _too_large(mark: Mark) -> NoNumber:
    return NoNumber(mark, "PL207", f"a number beyond 10^{round(math.log10(LARGEST))} comes up here")


def _power(side: Binary, base: Known, exponent: Known) -> Known | None:
    if isinstance(exponent, Fraction) and exponent.denominator == 1:
        times = abs(exponent.numerator)
        if isinstance(base, Fraction):
            if times * max(base.numerator.bit_length(), base.denominator.bit_length()) > 2 * BITS:
                raise _too_large(side.mark)
            raised: Known = base**times
        else:
            value = base.value**times
            raised = Rough(value, times * abs(base.value) ** (times - 1) * base.doubt + ROUNDING * abs(value))
        return raised if exponent >= 0 else _inverse(raised)
    a, b = _rough(base), _rough(exponent)
    if a.value < -a.doubt:
        hint = "write the sign before the power: `-(8^(1/3))`"
        raise NoNumber(side.mark, "PL217", f"a power of the negative number {a.value:.6g} is no real number", hint)
    if a.value <= a.doubt:
        return None
    value = a.value**b.value
    return Rough(value, abs(value) * (abs(b.value) * a.doubt / a.value + abs(math.log(a.value)) * b.doubt + ROUNDING))


def _called(side: Function, argument: Known | None) -> Known | None:
    """A function of a number, where it has a real value."""
    if argument is None:
        return None
    if side.name == "abs":
        return abs(argument) if isinstance(argument, Fraction) else Rough(abs(argument.value), argument.doubt)
    try:
        x = _rough(argument)
    except OverflowError:
        raise _too_large(side.mark) from None
    if abs(x.value) > LARGEST or (side.name == "exp" and x.value > MAX_EXP):
        raise _too_large(side.mark)
    if side.name in ("sin", "cos", "tan"):
        demand_direction(x, side.mark)
    _demand_real(side, x, exact=isinstance(argument, Fraction))
    value, slope = _value_and_slope(side.name, x)
    return None if value is None else Rough(value, slope * x.doubt + ROUNDING * abs(value))


def demand_direction(angle: Known, mark: Mark) -> None:
    """NoNumber for an angle so large that nobody can say which way it points."""
    size = abs(angle.value) if isinstance(angle, Rough) else abs(angle)
    if size > LARGEST_ANGLE:
        text = f"an angle of about 10^{order(angle)} rad leaves no digits for its direction"
        raise NoNumber(mark, "PL207", text, f"angles lie within 10^{round(math.log10(LARGEST_ANGLE))} rad")


def _demand_real(side: Function, x: Rough, exact: bool) -> None:
    """NoNumber where the function has no real value."""
    doubt = 0.0 if exact else x.doubt
    number = f"{x.value:.6g}"
    if side.name == "sqrt" and x.value < -doubt:
        raise NoNumber(side.mark, "PL217", f"the root of the negative number {number} is no real number")
    if side.name == "log" and (x.value < -doubt or (exact and x.value <= 0)):
        raise NoNumber(side.mark, "PL217", f"log of {number} is no number: its argument is more than zero")
    if side.name in ("asin", "acos") and abs(x.value) > 1 + doubt:
        raise NoNumber(side.mark, "PL217", f"{side.name} of {number} is no real number: its argument lies in -1 to 1")
    if side.name == "tan" and abs(math.cos(x.value)) <= max(x.doubt, ROUNDING):
        raise NoNumber(side.mark, "PL217", "tan of a right angle is infinite")


def _value_and_slope(name: str, x: Rough) -> tuple[float | None, float]:
    """The value, and a bound of how fast it changes there; no value where that is open within the doubt."""
    match name:
        case "sin" | "cos" | "tan":
            # Of a large angle nothing but its doubt is left.
            slope = 1.0 if name != "tan" else 1 / math.cos(x.value) ** 2
            return float(getattr(math, name)(x.value)), slope
        case "atan":
            return math.atan(x.value), 1.0
        case "exp":
            return math.exp(x.value), math.exp(x.value)
        case "sqrt":
            return (math.sqrt(x.value), 0.5 / math.sqrt(x.value)) if x.value > x.doubt else (None, 0.0)
        case "log":
            return (math.log(x.value), 1 / x.value) if x.value > x.doubt else (None, 0.0)
        case _:
            rest = 1 - x.value * x.value
            return (float(getattr(math, name)(x.value)), 1 / math.sqrt(rest)) if rest > 2 * x.doubt else (None, 0.0)
