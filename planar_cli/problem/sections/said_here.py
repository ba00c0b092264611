"""Relations of a state without an `@` that names the state itself: there `v(b) @ 2` and `v(b)` say the same."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.language.expression import Extreme, Function, Grouped, Name, Quantity, Relation, Side, Statement
from planar_cli.problem.language.walk import changed


def said_here(statement: Statement, state: str) -> Statement:
    """A statement of a state; what is told of this very state is told of now."""

    def rule(side: Side) -> Side | None:
        match side:
            case Name() | Quantity() if side.at == state:
                return replace(side, at=None)
            case Function() if side.at == state:
                return replace(side, argument=now(side.argument), at=None)
            case Grouped() if side.at == state:
                return now(side.operand)
            case Function() | Grouped() if side.at is not None:
                return side
        return None

    def now(side: Side) -> Side:
        return changed(side, rule)

    match statement:
        case Relation():
            return replace(statement, left=now(statement.left), right=now(statement.right))
        case Extreme():
            return replace(statement, side=now(statement.side))
    return statement
