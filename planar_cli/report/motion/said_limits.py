"""What decides a motion that just succeeds, said before what leads to its last state: it comes to rest there, in
equilibrium.
"""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Heading, Paragraph, Text, line
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import AT_A_TOP

STEP = "STEP"


def with_limit_said(blocks: Iterable[Block], found: MotionTrace) -> list[Block]:
    """The blocks of a motion, with that criterion before what leads to its last state."""
    blocks = list(blocks)
    if AT_A_TOP not in found.checks or not found.states:
        return blocks
    last, bodies = found.states[-1], found.problem.bodies
    first = next((i for i, b in enumerate(blocks) if f" to {last}, " in _words(b)), None)
    at = first if first is not None else next((i + 1 for i, b in enumerate(blocks) if _is_step(b)), 0)
    what = with_article(bodies[0].name) if len(bodies) == 1 else "all"
    # What is sought may be a length, of which more would be too much.
    way = "with a little more speed it passes on, with less it never gets there."
    limit = f"The limit: {what} comes to rest at {last} in equilibrium; {way}"
    return [*blocks[:at], Paragraph(line(limit)), *blocks[at:]]


def _words(block: Block) -> str:
    """The words of a sentence."""
    return "".join(p.text for p in block.line if isinstance(p, Text)) if isinstance(block, Paragraph) else ""


def _is_step(block: Block) -> bool:
    return isinstance(block, Heading) and block.label.startswith(STEP)
