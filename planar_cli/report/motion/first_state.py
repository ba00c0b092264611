"""What is asked at the first state, and needs nothing of the way from there, stands before that way."""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.document.mentioned import pieces_of
from planar_cli.report.words.state_words import at, place
from planar_cli.solve.between.trace.trace import MotionTrace


def first_state_first(way: Sequence[Block], asked: Sequence[Block], found: MotionTrace) -> list[Block]:
    """The blocks of the way and of what is asked, in the order of the states."""
    start = next(iter(found.states), "")
    if not way or not asked or not start or asked[0] != Paragraph(line(f"Hence, {place(start)}:")):
        return [*way, *asked]
    end = next((i for i, b in enumerate(asked) if i and not isinstance(b, Equation)), len(asked))
    own = asked[1:end]
    letters = {s for b in own for p in pieces_of_equation(b) if isinstance(p, Math) for s in p.expr.free_symbols}
    sought = {u for leg in found.route.steps for u in leg.unknowns}
    if letters & sought or end == len(asked):
        return [*way, *asked]
    return [Paragraph(line(at(start))), *own, *way, *asked[end:]]


def pieces_of_equation(block: Block) -> list[object]:
    return [p for side in block.sides for p in pieces_of(side)] if isinstance(block, Equation) else []
