"""Relations of a state without an `@` that names the state itself: there `v(b) @ 2` and `v(b)` say the same."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.expression import (
    Binary,
    Extreme,
    Function,
    Grouped,
    Name,
    Negate,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
)


def said_here(statement: Statement, state: str) -> Statement:
    """A statement of a state; what is told of this very state is told of now."""
    match statement:
        case Relation():
            return replace(statement, left=_now(statement.left, state), right=_now(statement.right, state))
        case Extreme():
            return replace(statement, side=_now(statement.side, state))
    return statement


def _now(side: Side, state: str) -> Side:
    match side:
        case Name() | Quantity() if side.at == state:
            return replace(side, at=None)
        case Function() if side.at is None or side.at == state:
            return replace(side, argument=_now(side.argument, state), at=None)
        case Grouped() if side.at == state:
            return _now(side.operand, state)
        case Negate() | Scaled():
            return replace(side, operand=_now(side.operand, state))
        case Binary():
            return replace(side, left=_now(side.left, state), right=_now(side.right, state))
    return side
