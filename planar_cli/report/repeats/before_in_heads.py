"""That the first lines of a step are as before stands in its heading, where nothing else has to:

STEP 1  Kinetic analysis                                as before: the diagram, (5) and (6)
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.document.as_printed import as_text
from planar_cli.report.document.blocks import Block, Forces, Heading, Paragraph, Text, line
from planar_cli.report.equations.one_motion import STEP
from planar_cli.report.equations.steps import SOLVING

BEFORE, DIAGRAM = "As before", "the diagram"
WIDTH = 70
"""Characters that have room behind a heading."""


def with_before_in_heads(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a case. The legend of diagrams goes where these are as before."""
    found: list[Block] = []
    for i, block in enumerate(blocks):
        heading = found[-1] if found else None
        if isinstance(heading, Heading) and isinstance(block, Paragraph) and _fits(heading, block, blocks[i + 1 :]):
            said = block.line[1:-1]
            found[-1] = replace(heading, aside=line(BEFORE.lower(), *said))
        else:
            found.append(block)
    return found


def _fits(heading: Heading, told: Paragraph, after: Sequence[Block]) -> bool:
    """Is it a step with no other aside, or with the legend of diagrams that are not drawn again?"""
    if told.line[0] != Text(BEFORE) or not heading.label.startswith(STEP) or heading.text == SOLVING:
        return False
    step = after[: next((i for i, b in enumerate(after) if isinstance(b, Heading)), len(after))]
    drawn = any(isinstance(b, Forces) for b in step)
    said = as_text(told.line)
    return bool(step) and not drawn and (not heading.aside or DIAGRAM in said) and len(said) <= WIDTH
