"""Going through syntax trees: every node of a side, relation or statement, outermost first."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction

from planar_cli.problem.language.expression import (
    Binary,
    Extreme,
    Function,
    Grouped,
    Name,
    Negate,
    Number,
    PointPair,
    Quantity,
    Relation,
    Scaled,
    Side,
    Statement,
)

Tree = Side | Statement | PointPair


def children(tree: Tree) -> tuple[Tree, ...]:
    """The nodes directly below; a quantity's are its argument and the directions of its parts."""
    match tree:
        case Negate() | Scaled() | Grouped():
            return (tree.operand,)
        case Binary() | Relation():
            return (tree.left, tree.right)
        case Function():
            return (tree.argument,)
        case Extreme():
            return (tree.side,)
        case Quantity():
            directions = tuple(part.direction for part in tree.parts if part.direction is not None)
            return directions if tree.argument is None else (tree.argument, *directions)
        case _:
            return ()


def walk(tree: Tree) -> Iterator[Tree]:
    """All nodes of a tree, the tree itself first."""
    yield tree
    for child in children(tree):
        yield from walk(child)


def names_of_states(tree: Tree) -> set[str]:
    """All states that stand behind an `@`."""
    found: set[str] = set()
    for node in walk(tree):
        at = node.at if isinstance(node, Quantity | Name | Grouped | Function) else None
        found |= {at} if isinstance(at, str) else set(at or ())
    return found


def changed(side: Side, rule: Callable[[Side], Side | None]) -> Side:
    """The side with every node that the rule changes in the place of the old one; None: it looks below the node."""
    new = rule(side)
    if new is not None:
        return new
    match side:
        case Negate() | Scaled() | Grouped():
            return replace(side, operand=changed(side.operand, rule))
        case Binary():
            return replace(side, left=changed(side.left, rule), right=changed(side.right, rule))
        case Function():
            return replace(side, argument=changed(side.argument, rule))
    return side


def rational(side: Side) -> Fraction | None:
    """The value of a side of plain numbers, such as `1/2` or `-(3)`; None for anything else."""
    match side:
        case Number(value=value, unit=None):
            return value
        case Negate(operand=operand):
            inner = rational(operand)
            return None if inner is None else -inner
        case Binary(operator=operator, left=first, right=second):
            left, right = rational(first), rational(second)
            if left is None or right is None or operator == "^" or (operator == "/" and right == 0):
                return None
            return {"+": left + right, "-": left - right, "*": left * right}.get(operator, left / (right or 1))
        case _:
            return None


def is_endless(relations: Iterable[Statement]) -> bool:
    """Do the relations of a state speak of infinity, so that it is only approached?"""
    return any(isinstance(n, Name) and n.name == "infinity" for r in relations for n in walk(r))


def written_alike(one: object, other: object) -> bool:
    """Are two formulas written alike, wherever they stand?"""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(written_alike, one, other))
    if type(one) is not type(other) or not is_dataclass(one):
        return one == other
    return all(written_alike(getattr(one, f.name), getattr(other, f.name)) for f in fields(one) if f.name != "mark")
