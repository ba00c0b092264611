"""A joint of two moving bodies, whose point is told by both, in one line:

a_B = a_A + α_AB × r_B/A - ω_AB² r_B/A = α_CB × r_B/C - ω_CB² r_B/C
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeGuard

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Name, line

WIDTH = 92
"""Characters of formulas that have room in one row."""
TURNS = " × "


def with_both_ways(blocks: Sequence[Block]) -> list[Block]:
    """Blocks in which two vector equations of one point that follow each other are one."""
    found: list[Block] = []
    for block in blocks:
        last = found[-1] if found else None
        if _is_of_a_point(last) and _is_of_a_point(block) and _is_short(both := _joined(last, block)):
            found[-1] = both
        else:
            found.append(block)
    return found


def _is_of_a_point(block: Block | None) -> TypeGuard[Equation]:
    """Is it the vector equation of a point in letters, with nothing beside it?"""
    if not isinstance(block, Equation) or block.number is not None or block.lead or block.note or len(block.sides) != 2:
        return False
    left, right = block.sides
    named = isinstance(left, tuple) and len(left) == 1 and isinstance(left[0], Name)
    return named and isinstance(right, tuple) and TURNS in as_text(right)


def _joined(one: Equation, other: Equation) -> Equation | None:
    """Both as one chain; None: they are of two points."""
    return Equation((*one.sides, other.sides[1])) if one.sides[0] == other.sides[0] else None


def _is_short(both: Equation | None) -> TypeGuard[Equation]:
    return both is not None and sum(len(as_text(line(side))) + 3 for side in both.sides) <= WIDTH
