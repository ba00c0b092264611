"""A step of a motion that only writes down what stands under Given: it is left out, and the motion begins."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.document.blocks import Block, Equation, Heading, Paragraph, line
from planar_cli.report.given.data import GIVEN

GROUPS = (line("Velocities:"), line("Accelerations:"))


def is_restated(blocks: Sequence[Block], converted: bool = False) -> bool:
    """Do the blocks of a general position only say `letter = datum`, none of them in another unit? `converted`: or in
    that of the page too.
    """
    data = [b for b in blocks if isinstance(b, Equation)]
    headings = [b for b in blocks if isinstance(b, Heading)]
    groups = [b for b in blocks if isinstance(b, Paragraph)]
    whole = len(data) + len(headings) + len(groups) == len(blocks)
    plain = all(b.lead == GIVEN and len(b.sides) <= 2 + converted for b in data)
    return whole and bool(data) and plain and len(headings) == 1 and all(b.line in GROUPS for b in groups)
