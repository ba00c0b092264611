"""The lines before a balance of energies in no more rows than they need: heights of one value share a line, what has
its value at sight stands beside another such, and a kinetic energy is summed once, in the balance itself.

y_G,crank,3 = y_G,AB,3 = 0 m,  s_3 = 0.05 m
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Value, line
from planar_cli.report.energy.energy_pieces import STATE

WIDTH, INDENT, GAP = 110, 4, 3
"""Columns of a page; what stands before an equation at least, and between it and what stands beside it."""
NARROW = 64
"""Columns of a line of several values."""
WHOLE = 4
"""An energy by speeds, in letters, and by what is sought has so many sides."""
SPEEDS, WORK = ("v_", "omega_"), "U"


def in_few_lines(blocks: Sequence[Block], told: Equation) -> list[Block]:
    """The lines before a balance, `told`."""
    own = [_without_middle(b) if isinstance(b, Equation) else b for b in blocks if not _is_sum(b, told)]
    return _side_by_side(_with_equal_ends(own))


def breaks(equation: Equation, rows: int = 1) -> bool:
    """Is it wider than so many rows?"""
    number = len(f"({equation.number})  ") if equation.number is not None else 0
    head = len(as_text(equation.lead)) + GAP if equation.lead else 0
    note = len(as_text(equation.note)) + GAP if equation.note else 0
    whole = " = ".join(as_text(side) for side in equation.sides)
    return INDENT + number + head + len(whole) + note > WIDTH + (rows - 1) * (WIDTH - 2 * INDENT)


def ended(block: Block) -> str:
    """The letter of a height or a stretch at a state, where a line gives it; else nothing."""
    if not isinstance(block, Equation) or block.lead or block.number is not None:
        return ""
    first = block.sides[0]
    last = first[-1] if isinstance(first, tuple) else first
    name = str(last.expr.name) if isinstance(last, Math) and last.expr.is_Symbol else ""
    return name if STATE in name and not name.startswith(SPEEDS) else ""


def _is_sum(block: Block, told: Equation) -> bool:
    """Is it the sum of kinetic energies with which its balance ends?"""
    if not isinstance(block, Equation) or block.lead or len(block.sides) != 2 or not isinstance(block.sides[0], tuple):
        return False
    (left, *more), right = block.sides[0], block.sides[1]
    summed = isinstance(left, Name) and not more and isinstance(right, Math) and bool(right.values)
    return summed and as_text(right) == as_text(told.sides[-1]) and as_text(left) in as_text(told.lead)


def _without_middle(block: Equation) -> Equation:
    """An energy of a moving body that takes two rows only as it stands in letters twice."""
    own = block.sides
    twice = len(own) == WHOLE and all(isinstance(s, Math) for s in own[1:]) and isinstance(own[0], tuple)
    # The antiderivative of a work is what is learnt of it.
    twice = twice and not as_text(own[0]).startswith(WORK)
    if not twice or not isinstance(own[-1], Math) or not own[-1].values or not breaks(block):
        return block
    return replace(block, sides=(own[0], own[1], own[3]))


def _with_equal_ends(blocks: Sequence[Block]) -> list[Block]:
    """y_G,A,1 = y_G,B,1 = formula = value, of two at one state."""
    found: list[Block] = []
    for block in blocks:
        same = next((i for i, b in enumerate(found) if _are_equal(b, block)), None)
        one = found[same] if same is not None else None
        if same is not None and isinstance(one, Equation) and isinstance(block, Equation):
            found[same] = replace(one, sides=(one.sides[0], block.sides[0], *one.sides[1:]))
        else:
            found.append(block)
    return found


def _are_equal(one: Block, other: Block) -> bool:
    """Are they lines of one value, neither of which has words before it?"""
    if not isinstance(one, Equation) or not isinstance(other, Equation) or one.note != other.note:
        return False
    names = ended(one), ended(other)
    if not all(names) or any(isinstance(b.sides[0], tuple) for b in (one, other)):
        return False
    state, same = {name.partition(STATE)[2] for name in names}, one.sides[-len(other.sides) + 1 :]
    return len(state) == 1 and same == other.sides[1:]


def _side_by_side(blocks: Sequence[Block]) -> list[Block]:
    """Lines of letters that have their values at sight in one."""
    found: list[Block] = []
    place: int | None = None
    for block in blocks:
        if not isinstance(block, Equation) or not _is_at_sight(block):
            found.append(block)
            continue
        one = found[place] if place is not None else None
        if place is not None and isinstance(one, Equation):
            told = [p for i, side in enumerate(block.sides) for p in ((" = ",) if i else ()) + (side,)]
            both = replace(one, sides=(*one.sides[:-1], line(one.sides[-1], ",  ", *told)))
            if len(" = ".join(map(as_text, both.sides))) <= NARROW:
                found[place] = both
                continue
        place = len(found)
        found.append(block)
    return found


def _is_at_sight(block: Equation) -> bool:
    """Is it one letter, or several that are the same, and a value?"""
    letters = all(isinstance(s, Math) and s.expr.is_Symbol for s in block.sides[:-1])
    return letters and bool(ended(block)) and not block.note and isinstance(block.sides[-1], Value)
