"""Checks of vectors: parts only of vectors, no sums of a vector and a number, numbers where numbers are due."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.errors import Diagnostic, Mark
from planar_cli.problem.checks.check_dimensions import about
from planar_cli.problem.checks.formulas import formulas
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.expression import (
    Binary,
    Extreme,
    Function,
    Grouped,
    Negate,
    Number,
    Quantity,
    Relation,
    Side,
    Statement,
)

VECTORS = frozenset("r v a coriolis IC friction reaction force momentum impulse".split())
MOTIONS = frozenset("r v a coriolis".split())
CURVE_PARTS = frozenset(("t", "n"))
POLAR_PARTS = frozenset(("r", "theta"))


def vectors_are_vectors(scope: Scope) -> Iterator[Diagnostic]:
    """Vectors and numbers stand where each is due."""
    for formula in formulas(scope.problem):
        yield from _statement(formula.tree, scope, formula.what.startswith("the find"))


def _statement(tree: Side | Statement, scope: Scope, may_be_vector: bool) -> Iterator[Diagnostic]:
    wrong: list[Diagnostic] = []
    match tree:
        case Relation():
            left, right = is_vector(tree.left, scope, wrong), is_vector(tree.right, scope, wrong)
            if left != right and not _is_zero(tree.right if left else tree.left):
                wrong.append(_mixed(tree.mark, tree.left if left else tree.right, "is compared with a number"))
            elif left and right and tree.operator != "=":
                wrong.append(_mixed(tree.mark, tree.left, "cannot be larger or smaller"))
        case Extreme():
            if is_vector(tree.side, scope, wrong):
                wrong.append(_mixed(tree.mark, tree.side, "cannot be larger or smaller"))
        case _ if isinstance(tree, Side):
            if is_vector(tree, scope, wrong) and not may_be_vector:
                wrong.append(_mixed(tree.mark, tree, "stands where a number is due"))
        case _:
            pass
    yield from wrong


def _is_zero(side: Side) -> bool:
    return isinstance(side, Number) and side.value == 0


def _mixed(mark: Mark, side: Side, what: str) -> Diagnostic:
    name = f"{side.word}({'/'.join(side.things)})" if isinstance(side, Quantity) and side.things else "a vector"
    shown = name if name.endswith(")") else "v(P)"
    return Diagnostic(
        mark, "PL426", f"{name} is a vector and {what}", f"ask `{shown}.x`, `{shown}.mag` or `{shown}.along(30 deg)`"
    )


def is_vector(side: Side, scope: Scope, wrong: list[Diagnostic]) -> bool:
    """Is it a vector? What does not fit inside is appended to `wrong`."""
    match side:
        case Quantity():
            return _quantity(side, scope, wrong)
        case Negate() | Grouped():
            return is_vector(side.operand, scope, wrong)
        case Function():
            if is_vector(side.argument, scope, wrong):
                wrong.append(_mixed(side.mark, side.argument, f"stands in {side.name}(…)"))
            return False
        case Binary():
            return _binary(side, scope, wrong)
        case _:
            return False


def _binary(side: Binary, scope: Scope, wrong: list[Diagnostic]) -> bool:
    left, right = is_vector(side.left, scope, wrong), is_vector(side.right, scope, wrong)
    if side.operator in "+-":
        if left != right and not _is_zero(side.right if left else side.left):
            wrong.append(_mixed(side.mark, side.left if left else side.right, "is added to a number"))
        return left or right
    if (left and right) or (right and side.operator == "/") or (left and side.operator == "^"):
        wrong.append(_mixed(side.mark, side.left if left else side.right, f"stands at '{side.operator}'"))
    return left or right


def _quantity(quantity: Quantity, scope: Scope, wrong: list[Diagnostic]) -> bool:
    vector = _is_vector_word(quantity, scope, wrong)
    for part in quantity.parts:
        if not vector:
            said = (
                f"{quantity.word}({'/'.join(quantity.things)})" if part is quantity.parts[0] else "a part of a vector"
            )
            hint = (
                "leave the part out: positive is counterclockwise, a press or a pull"
                if part is quantity.parts[0]
                else ""
            )
            wrong.append(Diagnostic(part.mark, "PL425", f"{said} is a number and has no part .{part.kind}", hint))
            return False
        if part.kind in CURVE_PARTS and quantity.word not in ("v", "a", "coriolis"):
            hint = ".t and .n are parts of `v(P)` and `a(P)`"
            wrong.append(Diagnostic(part.mark, "PL425", f"{quantity.word}(…) has no part .{part.kind}", hint))
        if part.kind in POLAR_PARTS and quantity.word not in MOTIONS:
            hint = ".r and .theta are parts of `r(P/O)`, `v(P/O)` and `a(P/O)`"
            wrong.append(Diagnostic(part.mark, "PL425", f"{quantity.word}(…) has no part .{part.kind}", hint))
        vector = False
    return vector


def _is_vector_word(quantity: Quantity, scope: Scope, wrong: list[Diagnostic]) -> bool:
    argument = quantity.argument
    if argument is not None:
        if isinstance(argument, Relation):
            wrong.extend(_statement(argument, scope, False))
            return False
        return is_vector(argument, scope, wrong)
    if quantity.word == "impulse" and about(quantity, scope) is not None:
        return False
    return quantity.word in VECTORS
