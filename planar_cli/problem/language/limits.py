"""Guards on the size of what an expression says, so that no arithmetic later can take for ever.

The values of constant parts are followed while the tree is built; nothing is computed that is larger than the guard.
"""

from __future__ import annotations

from fractions import Fraction

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
    Word,
)
from planar_cli.problem.language.tokens import Cursor, Token

MAX_DEPTH = 60
MAX_NODES = 500
MAX_BITS = 1100
MAX_EXPONENT = 12
MAX_ROOT = 6
MAX_TOWER = 2
MAX_EXP = 700


class Guard:
    """Counts depth, nodes and powers of one expression and follows its constants."""

    def __init__(self, cursor: Cursor) -> None:
        self.cursor = cursor
        self.depth = 0
        self.nodes = 0
        self.tower = 0
        # The key is the identity of a node, which the value keeps alive; None is not a constant.
        self._constants: dict[int, tuple[Side, Fraction | None]] = {}

    def enter(self) -> None:
        self.depth += 1
        if self.depth > MAX_DEPTH:
            self.cursor.fail(f"brackets are nested more than {MAX_DEPTH} deep", "name the inner parts", "PL207")

    def leave(self) -> None:
        self.depth -= 1

    def enter_power(self) -> None:
        self.tower += 1
        if self.tower > MAX_TOWER:
            self.cursor.fail(f"more than {MAX_TOWER} powers stand on top of each other", "name the exponent", "PL207")

    def leave_power(self) -> None:
        self.tower -= 1

    def node(self, side: Side, token: Token) -> Side:
        """Count one node and refuse it if its constant value is too large, or not defined."""
        self.nodes += 1
        if self.nodes > MAX_NODES:
            self.cursor.fail(f"an expression has at most {MAX_NODES} parts", "name some of them", "PL207", token)
        value = self._value(side, token)
        if value is not None and max(value.numerator.bit_length(), value.denominator.bit_length()) > MAX_BITS:
            self.cursor.fail("a number is too large", "", "PL207", token)
        self._constants[id(side)] = (side, value)
        return side

    def constant(self, side: Side) -> Fraction | None:
        """The value of a constant side, in the units that are written; None if it is not constant or not rational."""
        entry = self._constants.get(id(side))
        return entry[1] if entry else None

    def _value(self, side: Side, token: Token) -> Fraction | None:
        match side:
            case Number(value=value):
                return value
            case Negate(operand=operand):
                inner = self.constant(operand)
                return None if inner is None else -inner
            case Scaled(operand=operand) | Grouped(operand=operand):
                return self.constant(operand)
            case Binary():
                return self._binary(side, token)
            case Function(name="exp", argument=argument):
                power = self.constant(argument)
                if power is not None and abs(power) > MAX_EXP:
                    self.cursor.fail("a number is too large", "", "PL207", token)
                return None
            case Function() | Name() | Word() | Quantity():
                return None

    def _binary(self, side: Binary, token: Token) -> Fraction | None:
        left, right = self.constant(side.left), self.constant(side.right)
        if side.operator == "^":
            return self._power(left, right, token)
        if side.operator == "/" and right == 0:
            self.cursor.fail("division by zero", "", "PL216", token)
        if left is None or right is None:
            return None
        found: Fraction = ARITHMETIC[side.operator](left, right)
        return found

    def _power(self, base: Fraction | None, exponent: Fraction | None, token: Token) -> Fraction | None:
        if exponent is None:
            return None
        if abs(exponent) > MAX_EXPONENT or exponent.denominator > MAX_ROOT:
            message = f"an exponent is at most {MAX_EXPONENT}, with a denominator of at most {MAX_ROOT}"
            self.cursor.fail(message, "write `exp(n*log(x))` if another is meant", "PL215", token)
        if base is None:
            return None
        if base == 0 and exponent < 0:
            self.cursor.fail("division by zero", "", "PL216", token)
        if exponent.denominator != 1:
            return None
        bits = max(base.numerator.bit_length(), base.denominator.bit_length())
        if bits * abs(exponent) > 2 * MAX_BITS:
            self.cursor.fail("a number is too large", "", "PL207", token)
        return base**exponent.numerator
