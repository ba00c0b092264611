"""A page as short as the key of an exam: the principle, the key equations, the results.

Key equations are those with a number of their own: the relations of kinematics that are used, sums of forces and
moments, balances, integrals. What leads to them and how they are solved stands on the page for students. Where a part
has none, what is asked stands in its place with formula and numbers.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.report.blocks import Answer, Block, Equation, Heading, Line, Name, Note, Text

KEPT = ("CASE", "STATE")
"""Headings that say of what the equations are."""
GIVEN = "given:"


def key_blocks(blocks: Sequence[Block]) -> list[Block]:
    """The key of one part of a page."""
    numbered = [b for b in blocks if isinstance(b, Equation) and b.number is not None and not _is_datum(b)]
    named = {b.name for b in blocks if isinstance(b, Answer)}
    asked = [] if numbered else [b for b in blocks if isinstance(b, Equation) and _letter(b) in named]
    kept = {id(b) for b in (*numbered, *asked)}
    return list(_without_empty([b for b in blocks if id(b) in kept or _stays(b)]))


def _stays(block: Block) -> bool:
    if isinstance(block, Heading):
        return block.label in KEPT
    return isinstance(block, Answer) or (isinstance(block, Note) and block.kind in ("Fails", "Disagrees"))


def _without_empty(blocks: Sequence[Block]) -> Iterator[Block]:
    """Without headings under which nothing stands; equations without the notes that explain their arms."""
    for i, block in enumerate(blocks):
        follows = blocks[i + 1] if i + 1 < len(blocks) else None
        if isinstance(block, Heading) and block.label == "STATE" and not isinstance(follows, Equation):
            continue
        yield replace(block, note=_unit(block.note)) if isinstance(block, Equation) else block


def _unit(note: Line) -> Line:
    """The unit of numbers beside unknowns; no other words."""
    return note if note and isinstance(note[0], Text) and note[0].text.startswith("in ") else ()


def _is_datum(block: Equation) -> bool:
    return any(isinstance(p, Text) and p.text == GIVEN for p in block.lead)


def _letter(block: Equation) -> str:
    """The name with which an equation begins."""
    first = block.sides[0]
    piece = first[0] if isinstance(first, tuple) and first else first
    return piece.name if isinstance(piece, Name) else ""
