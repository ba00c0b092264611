"""An equation that is solved in numbers comes with these at once, where its letters are known: of a later state that
stood in letters for an earlier one, or a long balance of energies all of whose parts were told.

(2)  0 = l sin θ_AB,2 + r_c sin θ_crank,2          (5)  0 = 0.45 sin θ_AB,4 + 0.15 sin θ_crank,4   in m
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Text
from planar_cli.report.energy.few_lines import WORK, breaks

OF_STATE, IN_NUMBERS = re.compile(r"__\w+"), re.compile(r"\((\d+)\) in numbers:")


def numbers_alone(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part."""
    put_in = {n: b for b in blocks if isinstance(b, Equation) and (n := _number(b)) is not None}
    if not put_in:
        return list(blocks)
    found: list[Block] = []
    told: set[str] = set()
    left_out: list[Equation] = []
    for block in blocks:
        form = _form(block) if isinstance(block, Equation) else ""
        other = put_in.get(block.number) if isinstance(block, Equation) and block.number is not None else None
        known = bool(form) and form in told
        if isinstance(block, Equation) and other is not None and (known or _is_told_in_parts(block, found)):
            found.append(replace(other, number=block.number, lead=block.lead))
            left_out.append(other)
        elif block not in left_out:
            found.append(block)
        told |= {form} if form else set()
    return found


def _is_told_in_parts(block: Equation, before: Sequence[Block]) -> bool:
    """Is it a balance whose works stand above it: the first if it takes more than two rows, a later one if it takes
    more than one?
    """
    if not _is_balance(block):
        return False
    parts = takewhile(lambda b: isinstance(b, Equation) and b.number is None, reversed(before))
    works = any(isinstance(b, Equation) and _is_work(b.sides[0]) for b in parts)
    return works and breaks(block, 1 if any(map(_is_balance, before)) else 2)


def _is_balance(block: Block) -> bool:
    """Does `T_1 + U = T_2:` stand before it?"""
    lead = block.lead if isinstance(block, Equation) and block.number is not None else ()
    return len(lead) > 1 and isinstance(lead[0], Name) and lead[1] == Text(" + ")


def _is_work(side: Inline | Line) -> bool:
    first = side[0] if isinstance(side, tuple) else side
    return isinstance(first, Name) and first.name.startswith(WORK)


def _number(block: Equation) -> int | None:
    """The number of the equation that it gives in numbers."""
    match block.lead:
        case (Text(text),) if block.number is None and (own := IN_NUMBERS.fullmatch(text)):
            return int(own[1])
    return None


def _form(block: Equation) -> str:
    """What a numbered equation in letters says, whatever the states; else nothing."""
    sides = [s for s in block.sides if isinstance(s, Math) and not s.values]
    if block.number is None or block.note or len(sides) < len(block.sides):
        return ""
    said = f"{block.lead} {' = '.join(str(s.expr) for s in sides)}"
    return OF_STATE.sub("__", said) if OF_STATE.search(said) else ""
