"""Sums of logarithms of quantities with units: `log(m0) - log(m0 - q*T)` is one of a pure number, written in two parts.

In other units of mass every log(m) grows by the same addend, the log of their ratio. Where these addends cancel, the
sum is the same in all units, and so means something though its parts do not.
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from fractions import Fraction

from planar_cli import units
from planar_cli.problem.language.evaluation import ARITHMETIC
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Quantity,
    Scaled,
    Side,
)
from planar_cli.units import Dimension

SAME = 1e-9
"""So large a part of a sum may change by rounding."""
UNITS = (units.MASS, units.LENGTH, units.TIME)

DimensionOf = Callable[[Side], Dimension | None]
"""The dimension of a side; None: it is not known."""


def same_in_all_units(side: Side, dimension_of: DimensionOf) -> bool:
    """Does a sum stay the same when the argument of each of its logarithms is told in other units?"""
    try:
        first = _Draw(dimension_of, None).value(side)
        return all(abs(_Draw(dimension_of, u).value(side) - first) <= SAME * abs(first) for u in UNITS)
    except (ArithmeticError, ValueError, _Unknown):
        return False


class _Unknown(Exception):
    """Something whose dimension or value is not told stands in the sum."""


class _Draw:
    """The value of a side where names and quantities have random sizes, the same in every draw."""

    def __init__(self, dimension_of: DimensionOf, unit: Dimension | None) -> None:
        self.dimension_of = dimension_of
        self.unit = unit
        """The unit that is taken twice as small inside logarithms; None: none."""

    def value(self, side: Side) -> complex:
        """Complex, as a logarithm may be of a difference that is negative in this draw."""
        match side:
            case Number():
                return complex(side.value) * side.sense
            case Name() | Quantity():
                return _drawn(side)
            case Negate():
                return -self.value(side.operand)
            case Grouped() | Scaled():
                return self.value(side.operand)
            case Function():
                return self._function(side)
            case Binary():
                return complex(ARITHMETIC[side.operator](self.value(side.left), self.value(side.right)))
            case _:
                raise _Unknown

    def _function(self, side: Function) -> complex:
        argument = self.value(side.argument)
        if side.name == "abs":
            return complex(abs(argument))
        if side.name != "log":
            return complex(getattr(cmath, side.name)(argument))
        dimension = self.dimension_of(side.argument)
        if dimension is None:
            raise _Unknown
        more = 0.0 if self.unit is None else float(_exponent(dimension, self.unit))
        return cmath.log(argument) + more * cmath.log(2)


def _drawn(side: Name | Quantity) -> complex:
    """The same size wherever the same stands."""
    # Few files have logarithms.
    import random

    if isinstance(side, Name):
        key = f"{side.name} {side.at}"
    else:
        if side.argument is not None or any(p.direction is not None for p in side.parts):
            raise _Unknown
        key = f"{side.word} {side.things} {[p.kind for p in side.parts]} {side.at}"
    return complex(random.Random(key).uniform(0.5, 2))


def _exponent(dimension: Dimension, unit: Dimension) -> Fraction:
    """How often a unit stands in a dimension."""
    return dimension.mass * unit.mass + dimension.length * unit.length + dimension.time * unit.time
