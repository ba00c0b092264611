"""An equation of a later state that stood in letters for an earlier one comes with its numbers at once, where it is
solved in numbers.

(2)  0 = l sin θ_AB,2 + r_c sin θ_crank,2          (5)  0 = 0.45 sin θ_AB,4 + 0.15 sin θ_crank,4   in m
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.blocks import Block, Equation, Math, Text

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
        if isinstance(block, Equation) and other is not None and form and form in told:
            found.append(replace(other, number=block.number, lead=block.lead))
            left_out.append(other)
        elif block not in left_out:
            found.append(block)
        told |= {form} if form else set()
    return found


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
