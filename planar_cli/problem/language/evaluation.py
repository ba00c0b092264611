"""What a formula of the file is, put together from whatever numbers a scene is made of."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from typing import Any, Protocol

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
    Word,
)
from planar_cli.problem.language.no_number import mode_misplaced

ARITHMETIC: Mapping[str, Callable[[Any, Any], Any]] = {
    "+": operator.add,
    "-": operator.sub,
    "*": operator.mul,
    "/": operator.truediv,
    "^": operator.pow,
}
"""What the operator of a `Binary` makes of two numbers of whatever kind."""


class Arithmetic(Protocol):
    """The numbers of which formulas are made."""

    def number(self, number: Number) -> Any:
        """A written number with its unit."""

    def scaled(self, side: Scaled) -> Any:
        """A formula with a unit behind it."""

    def named(self, name: Name) -> Any: ...
    def combined(self, side: Binary) -> Any: ...
    def called(self, function: Function) -> Any: ...
    def asked(self, quantity: Quantity) -> Any: ...
    def at(self, state: str, side: Side) -> Any:
        """What stands before an `@`."""


def evaluated(side: Side, numbers: Arithmetic) -> Any:
    """The value of a side. FileProblem where it has none."""
    match side:
        case Number():
            return numbers.number(side)
        case Scaled():
            return numbers.scaled(side)
        case Name(at=str(state)):
            return numbers.at(state, Name(side.name, None, side.mark))
        case Name():
            return numbers.named(side)
        case Negate():
            return -evaluated(side.operand, numbers)
        case Binary():
            return numbers.combined(side)
        case Function(at=str(state)):
            return numbers.at(state, Function(side.name, side.argument, None, side.mark))
        case Function():
            return numbers.called(side)
        case Grouped():
            return numbers.at(side.at, side.operand)
        case Quantity():
            return numbers.asked(side)
        case Word():
            raise mode_misplaced(side.mark, side.word)
    raise TypeError(type(side).__name__)
