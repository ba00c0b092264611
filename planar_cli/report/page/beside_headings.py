"""A heading that only says of which state something is, beside the single line that stands under it.

At 2:   v_B = ω r = 1.213 m/s
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.document.blocks import Block, Equation, Paragraph, Result, Table, Text
from planar_cli.report.document.joined_lines import in_fewer_lines

HEADING = re.compile(r"(Hence|(Hence, a|A)t [\w, ]+|(Hence, i|I)n state \w+):")


def beside_headings(blocks: Sequence[Block]) -> list[Block]:
    """`At 2:` and the only line under it as one, `At 2:   v_B = ω r = 1.213 m/s`; so too its values alone."""
    found: list[Block] = []
    blocks = in_fewer_lines(blocks)
    for i, block in enumerate(blocks):
        last, following = found[-1] if found else None, blocks[i + 1] if i + 1 < len(blocks) else None
        alone = not isinstance(following, Equation | Result | Table)
        if isinstance(block, Equation) and not block.lead and block.number is None and alone and _is_plain(last):
            assert isinstance(last, Paragraph)
            found[-1] = replace(block, lead=last.line)
        else:
            found.append(block)
    return found


def _is_plain(block: Block | None) -> bool:
    """Is it a heading that says no more than at which state something is?"""
    match block:
        case Paragraph((Text(text),)):
            return HEADING.fullmatch(text) is not None
    return False
