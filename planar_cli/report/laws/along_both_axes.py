"""A constant velocity along both axes under one heading:

From 1 to 2, constant velocity of B:   x_B,2 = x_B,1 + v_Bx,1 t_2,   y_B,2 = v_By,1 t_2
"""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.report.document.blocks import Block, Equation, Paragraph, Text, line
from planar_cli.report.words.origins import told_once

STEADY, ALONG_X, ALONG_Y = ", constant velocity of ", " along x:", " along y:"


def headed_once(blocks: Iterable[Block]) -> list[Block]:
    """The blocks without a heading that is still in force, and with one over both axes that have one equation each, one
    after the other.
    """
    told = list(told_once(blocks))
    for i in range(len(told) - 3, 0, -1):
        first, own, second, other = told[i - 1 : i + 3]
        head = _words(first)
        if not head.endswith(ALONG_X) or STEADY not in head or not isinstance(own, Equation):
            continue
        whole = head.removesuffix(ALONG_X)
        if _words(second) == f"{whole}{ALONG_Y}" and isinstance(other, Equation):
            told[i - 1 : i + 3] = [Paragraph(line(f"{whole}:")), own, other]
    return told


def _words(block: Block) -> str:
    """The words of a heading without mathematics; "" of anything else."""
    if not isinstance(block, Paragraph) or not all(isinstance(p, Text) for p in block.line):
        return ""
    return "".join(p.text for p in block.line if isinstance(p, Text))
