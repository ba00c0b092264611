"""Size and direction of many vectors in a row: how they follow from the components is told of the first.

  F_A = [A_x, A_y] = [-9.490, 21.78] N
|F_A| = √(9.490² + 21.78²) = 23.76 N         direction of F_A = arctan(21.78/9.490) = 66.5° above -x
  F_B = [B_x, B_y] = [-12.66, 7.657] N       likewise 14.80 N at 31.2° above -x
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from planar_cli.report.answers.size_and_angle import DIRECTION
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Text, Value, line

LEAST = 3
"""So many vectors at least stand in a row."""


def with_sizes_listed(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a page."""
    found: list[Block] = []
    start = 0
    while start < len(blocks):
        stop = start
        while stop + 1 < len(blocks) and _beside(blocks[stop], blocks[stop + 1]):
            stop += 2
        if stop - start < 2 * LEAST:
            found.append(blocks[start])
            start += 1
            continue
        found += blocks[start : start + 2]
        for vector, size in zip(blocks[start + 2 : stop : 2], blocks[start + 3 : stop : 2], strict=True):
            assert isinstance(vector, Equation)
            found.append(replace(vector, note=_beside(vector, size)))
        start = stop
    return found


def _beside(vector: Block, size: Block) -> Line:
    """`likewise 14.80 N at 31.2° above -x`; (): it is no vector with its size and direction below it."""
    if not isinstance(vector, Equation) or not isinstance(size, Equation) or vector.note or vector.number is not None:
        return ()
    own = vector.sides[0] if isinstance(vector.sides[0], tuple) else (vector.sides[0],)
    if size.sides[0] != line("|", *own, "|") or len(size.sides) != 3 or not isinstance(own[0], Name):
        return ()
    *_, angle, where = (*(None, None), *size.note)
    if size.note[:1] != (Text(DIRECTION),) or not isinstance(angle, Value) or not isinstance(size.sides[-1], Value):
        return ()
    assert isinstance(where, Text)
    return line("likewise ", size.sides[-1], " at ", angle, where.text)
