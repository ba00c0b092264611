"""The numbers of many components of accelerations, which a sum of forces or moments needs: of the first ones how they
are found, of all others their values.

Likewise a_G,CD,x = -4.135 m/s², a_G,DE,x = -1.682 m/s², a_G,OA,x = 2.808 m/s².
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from itertools import groupby

from planar_cli.report.document.blocks import Block, Equation, Heading, Paragraph, Value, line
from planar_cli.report.document.said import letter_of
from planar_cli.report.equations.results import LIKEWISE

TOLD, LEAST = 2, 2
"""Of so many of a step it is told how they are found, if there are at least so many others."""


def with_components_listed(blocks: Sequence[Block], answers: Collection[str]) -> list[Block]:
    """The blocks of a page. `answers`: the letters that are asked, each of which has a line of its own."""
    return list(_listed(blocks, answers))


def _listed(blocks: Sequence[Block], answers: Collection[str]) -> Iterator[Block]:
    told = 0
    for component, run in groupby(blocks, lambda b: _is_component(b, answers)):
        own = list(run)
        if not component:
            told = 0 if any(isinstance(b, Heading) for b in own) else told
            yield from own
            continue
        first = max(TOLD - told, 0)
        if len(own) - first < LEAST:
            told += len(own)
            yield from own
            continue
        told += first
        yield from own[:first]
        rest = [b for b in own[first:] if isinstance(b, Equation)]
        entries = [piece for b in rest for piece in (", ", b.sides[0], " = ", b.sides[-1])]
        yield Paragraph(line(LIKEWISE, *entries[1:], "."))


def _is_component(block: Block, answers: Collection[str]) -> bool:
    """Is it the line of a component along x or y that ends with its value?"""
    if not isinstance(block, Equation) or block.number is not None or not isinstance(block.sides[-1], Value):
        return False
    letter = letter_of(block.sides[0])
    return letter.startswith("a_") and letter.endswith((",x", ",y")) and letter not in answers
