"""Another frame: mirrored, or turned about the origin; and what is done with formulas to write them in it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from decimal import Decimal
from fractions import Fraction
from typing import Any

from planar_cli.errors import NOWHERE
from planar_cli.problem.language.expression import (
    Binary,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    Part,
    Quantity,
    Scaled,
    Side,
)
from planar_cli.problem.language.walk import walk


class NotWritten(Exception):
    """The problem cannot be written in this frame; the text is the reason."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Angles go from a to sense a + turn."""

    name: str
    sense: int
    turn: Side
    radians: float
    """The turn in numbers."""
    quarters: int | None
    """The turn in quarters, where it is so many."""

    def __str__(self) -> str:
        return self.name

    @property
    def mirrors_across_y(self) -> bool:
        """x -> -x and nothing else: what weighs still falls downwards."""
        return self.sense < 0 and self.quarters == 2

    def vector(self, x: Any, y: Any) -> tuple[Any, Any]:
        """T (x, y) in numbers."""
        cosine, sine = self._unit()
        kind = type(x)
        c, s = kind(cosine), kind(sine)
        return c * x - s * y * self.sense, s * x + c * y * self.sense

    def _unit(self) -> tuple[Decimal, Decimal]:
        if self.quarters is not None:
            found = ((1, 0), (0, 1), (-1, 0), (0, -1))[self.quarters % 4]
            return Decimal(found[0]), Decimal(found[1])
        return Decimal("0.6"), Decimal("0.8")


def degrees(number: int) -> Side:
    return Number(Fraction(number), "deg", 1, NOWHERE)


MIRROR = Frame("mirrored", -1, degrees(180), math.pi, 2)
QUARTER = Frame("turned by a quarter", 1, degrees(90), math.pi / 2, 1)
ASKEW = Frame(
    "turned askew",
    1,
    Function(
        "atan",
        Binary("/", Number(Fraction(4), None, 1, NOWHERE), Number(Fraction(3), None, 1, NOWHERE), NOWHERE),
        None,
        NOWHERE,
    ),
    math.atan2(4, 3),
    None,
)
"""By the angle with the cosine 3/5 and the sine 4/5."""


# --- formulas ---------------------------------------------------------------------------------------------------------


def is_side(value: Any) -> bool:
    return isinstance(value, Number | Name | Negate | Binary | Scaled | Function | Grouped | Quantity)


def parts_in(side: Side) -> list[Part]:
    """The parts of quantities in a formula."""
    return [part for node in walk(side) if isinstance(node, Quantity) for part in node.parts]


def negated(side: Side) -> Side:
    match side:
        case Number(value=value) if value == 0:
            return side
        case Number():
            return replace(side, value=-side.value)
        case Negate():
            return side.operand
    return Negate(side, NOWHERE)


def times(factor: Side, side: Side) -> Side:
    return side if isinstance(side, Number) and side.value == 0 else Binary("*", factor, side, NOWHERE)


def in_degrees(side: Side) -> Fraction | None:
    """A number of degrees."""
    match side:
        case Number(value=value) if side.unit == "deg":
            return value * side.sense
        case Number(value=value) if value == 0:
            return Fraction(0)
        case Negate():
            inner = in_degrees(side.operand)
            return None if inner is None else -inner
    return None


def wrapped(angle: Fraction) -> Fraction:
    """The same direction in (-180, 180] deg."""
    return 180 - (180 - angle) % 360


def substituted(side: Side, name: str, other: Side) -> Side:
    match side:
        case Name() if side.name == name:
            return other
        case Negate() | Scaled() | Grouped():
            return replace(side, operand=substituted(side.operand, name, other))
        case Binary():
            left, right = (substituted(s, name, other) for s in (side.left, side.right))
            return replace(side, left=left, right=right)
        case Function():
            return replace(side, argument=substituted(side.argument, name, other))
    return side
