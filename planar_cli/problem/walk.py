"""Going through syntax trees: every node of a side, relation or statement, outermost first."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.problem.expression import (
    Binary,
    Extreme,
    Function,
    Grouped,
    Negate,
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
