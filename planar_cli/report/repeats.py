"""What a case says as an earlier one did is told once: of a run of lines that stood there word for word, with the same
numbers of equations, only that it is as before.
"""

from __future__ import annotations

from collections.abc import Sequence

from planar_cli.report.blocks import Block, Equation, Forces, Heading, Paragraph, Result, Table, line

LEAST = 3
"""Fewer lines are printed again."""
TOLD = (Paragraph, Equation, Forces, Result, Table)


def told_once(blocks: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """The blocks of a case. `before`: those of earlier cases."""
    earlier = {kind: [b for b in before if isinstance(b, kind)] for kind in TOLD}
    known = [isinstance(b, TOLD) and b in earlier[type(b)] for b in blocks]
    found: list[Block] = []
    start = 0
    while start < len(blocks):
        stop = start
        while stop < len(blocks) and known[stop]:
            stop += 1
        # A sentence that leads to what is new stays.
        while (
            stop > start and stop < len(blocks) and _leads(blocks[stop - 1]) and not isinstance(blocks[stop], Heading)
        ):
            stop -= 1
        if stop - start >= LEAST:
            found.append(_as_before(blocks[start:stop]))
            start = stop
        else:
            found += blocks[start : max(stop, start + 1)]
            start = max(stop, start + 1)
    return found


def _leads(block: Block) -> bool:
    """Does a sentence announce what follows?"""
    return isinstance(block, Paragraph)


def _as_before(run: Sequence[Block]) -> Paragraph:
    """In place of a run of lines."""
    numbers = [b.number for b in run if isinstance(b, Equation) and b.number is not None]
    drawn = ["the diagram"] if any(isinstance(b, Forces) for b in run) else []
    if numbers:
        drawn.append(_range(min(numbers), max(numbers)))
    return Paragraph(line(f"As before{': ' if drawn else ''}{' and '.join(drawn)}."))


def _range(first: int, last: int) -> str:
    if first == last:
        return f"({first})"
    return f"({first}) {'and' if last == first + 1 else 'to'} ({last})"
