"""A further component of a vector that two bodies share stands behind its own words:

(4)  likewise v_D along x:   0.4 ω_QD - 0.2 ω_AB + 0.2 ω_slab = 0.8
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.as_printed import as_text
from planar_cli.report.blocks import Block, Equation, Paragraph, Text, line

LIKEWISE = "Likewise "
SHORT = 24
"""Characters of such words."""


def with_components_beside(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page with the short words before an equation in one line with it, where no vector equation goes
    on below it.
    """
    found: list[Block] = []
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        last = found[-1] if found else None
        goes_on = isinstance(after, Equation) and after.number is None and not after.lead
        if isinstance(last, Paragraph) and isinstance(block, Equation) and not goes_on and _leads(last, block):
            found[-1] = replace(block, lead=line(*last.line[1:]))
        else:
            found.append(block)
    return found


def _leads(words: Paragraph, equation: Equation) -> bool:
    """Is it `Likewise v_D along x:`, right before the equation?"""
    if equation.number is None or equation.lead or words.line[0] != Text(LIKEWISE):
        return False
    said = as_text(words.line)
    return len(said) <= SHORT and said.endswith(":") and " along " in said
