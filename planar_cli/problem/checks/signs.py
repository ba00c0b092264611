"""The sign that a formula has whatever its letters are: letters of `symbols` stand for positive numbers."""

from __future__ import annotations

from collections.abc import Mapping

from planar_cli.problem.language.expression import Binary, Function, Name, Negate, Number, Scaled, Side
from planar_cli.problem.language.walk import rational
from planar_cli.problem.scene.scene import Symbol


def certain_sign(side: Side, letters: Mapping[str, Symbol], values: Mapping[str, Symbol]) -> int | None:
    """1, 0 or -1; None: it depends on the letters, or on what is sought or varies. The names of `values`, which are
    given, must not go in long chains.
    """
    match side:
        case Number():
            return (side.value > 0) * side.sense - (side.value < 0) * side.sense
        case Scaled():
            inner = certain_sign(side.operand, letters, values)
            return None if inner is None else inner * side.sense
        case Negate():
            inner = certain_sign(side.operand, letters, values)
            return None if inner is None else -inner
        case Name(name=name, at=None) if name in letters or name == "pi":
            return 1
        case Name(name=name, at=None) if name in values:
            value = values[name].value
            rest = {other: symbol for other, symbol in values.items() if other != name}
            return None if value is None else certain_sign(value, letters, rest)
        case Binary():
            return _combined(side, letters, values)
        case Function(name="exp"):
            return 1
        case Function(name="sqrt", argument=argument):
            inner = certain_sign(argument, letters, values)
            return None if inner == -1 else inner
        case _:
            return None


def _combined(side: Binary, letters: Mapping[str, Symbol], values: Mapping[str, Symbol]) -> int | None:
    left = certain_sign(side.left, letters, values)
    if side.operator == "^":
        power = rational(side.right)
        even = power is not None and power.denominator == 1 and not power.numerator % 2 and power != 0
        return 1 if left == 1 or (left == -1 and even) else None
    right = certain_sign(side.right, letters, values)
    if left is None or right is None:
        return None
    match side.operator:
        case "*":
            return left * right
        case "/":
            return left * right if right else None
        case _:
            other = right if side.operator == "+" else -right
            return left or other if left * other >= 0 else None
