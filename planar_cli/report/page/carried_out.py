"""An equation that has its unknown alone on the left goes on with its numbers, and is not written once more.

(4)   v_G = v_C + 1/2 b ω = 0.5511 + 1/2 · 0.4 · 0.4862 = 0.6483 m/s
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.report.document.blocks import Block, Equation, Math, Text

LONGEST = 24
"""The sides of longer equations are not compared but by their looks."""


def carried_out(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part, each such equation together with the line in which it is solved."""
    found: list[Block] = []
    for block in blocks:
        whole = _whole(found[-1], block) if found else None
        if whole is None:
            found.append(block)
        else:
            found[-1] = whole
    return found


def _whole(one: Block, other: Block) -> Equation | None:
    """An equation and its solution as one; None: the second is no solution of the first alone, or of another form."""
    if not isinstance(one, Equation) or not isinstance(other, Equation) or one.number is None:
        return None
    if one.note or one.relation != "=" or len(one.sides) != 2 or not _is_solution(other, one.number):
        return None
    match (one.sides, other.sides):
        case ((Math() as own, Math() as told), (Math() as unknown, Math() as formula, *_)):
            if own.expr == unknown.expr and own.expr.is_Symbol and _are_same(told, formula):
                return replace(one, sides=(own, *other.sides[1:]), note=other.note)
    return None


def _is_solution(equation: Equation, number: int) -> bool:
    """Does it stand behind `(4):`?"""
    match equation.lead:
        case (Text(text),):
            return equation.number is None and text == f"({number}):"
    return False


def _are_same(one: Math, other: Math) -> bool:
    if one.expr == other.expr:
        return True
    if one.values or other.values or any(longer(m.expr, LONGEST) for m in (one, other)):
        return False
    return bool(expanded(sp.sympify(one.expr - other.expr)) == 0)
