"""What needs no line of its own: the heading over velocities and accelerations beside that of their first equation, and
the values of one state beside each other.

Velocities, angle of bar:
At 2:   t_2 = 0.1265 s,  θ̇_2 = -2.155 rad/s
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from planar_cli.report.document.blocks import Block, Equation, Paragraph, Text, Value, line

VELOCITIES, ACCELERATIONS = Paragraph(line("Velocities:")), Paragraph(line("Accelerations:"))
UNDER = re.compile(r"Angle of [^,]*:$|\(\d+\), differentiated:$")
"""A heading of equations that is joined."""
AT, MOST = re.compile(r"At \w+:"), 3
"""The heading of a state; of more values a row would be long."""


def in_fewer_lines(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page so told."""
    return list(_values_in_rows(list(joined_headings(blocks))))


def _values_in_rows(blocks: Sequence[Block]) -> Iterator[Block]:
    """The values under the heading of a state in its line, where nothing else stands under it."""
    start = 0
    while start < len(blocks):
        stop = start + 1
        while stop < len(blocks) and _goes_on(blocks[stop]):
            stop += 1
        row = _row(blocks[start], blocks[start + 1 : stop])
        yield from blocks[start:stop] if row is None else [row]
        start = stop


def _goes_on(block: Block) -> bool:
    """Does it stand under the heading above?"""
    return isinstance(block, Equation) and block.number is None and not block.lead


def _row(over: Block, values: Sequence[Block]) -> Equation | None:
    """`At 2:   t_2 = 0.1265 s,  θ̇_2 = -2.155 rad/s`; None: it is something else, or long."""
    at = "".join(p.text for p in over.line if isinstance(p, Text)) if isinstance(over, Paragraph) else ""
    told = [b for b in values if isinstance(b, Equation) and len(b.sides) == 2 and not b.note and b.relation == "="]
    if not AT.fullmatch(at) or not 1 < len(told) <= MOST or len(told) != len(values):
        return None
    if not all(isinstance(b.sides[1], Value) for b in told):
        return None
    (first, value), *others = (b.sides for b in told)
    rest = (p for letter, own in others for p in (",  ", letter, " = ", own))
    return Equation((first, line(value, *rest)), None, line(at))


def joined_headings(blocks: Sequence[Block]) -> Iterator[Block]:
    """The blocks with one heading for two: `Velocities, angle of bar:`, `Accelerations, (1) differentiated:`."""
    over = ""
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        if block in (VELOCITIES, ACCELERATIONS) and _under(after):
            over = "Velocities" if block == VELOCITIES else "Accelerations"
        elif over and isinstance(block, Paragraph):
            said = _under(block).replace("), differentiated", ") differentiated")
            yield Paragraph(line(f"{over}, {said[:1].lower()}{said[1:]}"))
            over = ""
        else:
            yield block


def _under(block: Block | None) -> str:
    """The words of a heading that is joined; "" of anything else."""
    pieces = block.line if isinstance(block, Paragraph) else ()
    said = "".join(p.text for p in pieces if isinstance(p, Text))
    return said if all(isinstance(p, Text) for p in pieces) and UNDER.match(said) else ""
