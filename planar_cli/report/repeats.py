"""What a case says as an earlier one did is told once: of a run of lines that stood there word for word, with the same
numbers of equations, only that it is as before; of a diagram from which forces are gone, which they are.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from planar_cli.report.blocks import (
    Block,
    Equation,
    Forces,
    Heading,
    Inline,
    Line,
    Paragraph,
    Result,
    Table,
    Text,
    line,
)

LEAST = 3
"""Fewer lines are printed again, unless they are all of a step."""
TOLD = (Paragraph, Equation, Forces, Result, Table)
INERTIA, BETWEEN = "moment of inertia of", ",  "
"""Begins the line of a moment of inertia; stands between the forces of a diagram."""


def told_once(blocks: Sequence[Block], before: Sequence[Block]) -> list[Block]:
    """The blocks of a case. `before`: those of earlier cases."""
    earlier = {kind: [b for b in before if isinstance(b, kind)] for kind in TOLD}
    rest = [b for b in blocks if not _names_again(b, earlier[Equation])]
    drawn = [(_without(b, earlier[Forces]) or b) if isinstance(b, Forces) else b for b in rest]
    known = [isinstance(b, TOLD) and b in earlier[type(b)] for b in drawn]
    found: list[Block] = []
    start = 0
    while start < len(drawn):
        stop = start
        while stop < len(drawn) and known[stop]:
            stop += 1
        heading = found[-1] if found and start > 0 and drawn[start - 1] is found[-1] and _ends(drawn, stop) else None
        # A sentence that leads to what is new stays.
        while stop > start and stop < len(drawn) and _leads(drawn[stop - 1]) and not isinstance(drawn[stop], Heading):
            stop -= 1
        if stop > start and isinstance(heading, Heading) and heading in before:
            found[-1] = _as_before(drawn[start:stop], heading.text)
            start = stop
        elif stop - start >= LEAST:
            found.append(_as_before(drawn[start:stop]))
            start = stop
        else:
            found += drawn[start : max(stop, start + 1)]
            start = max(stop, start + 1)
    return found


def _ends(blocks: Sequence[Block], stop: int) -> bool:
    """Does a step of the solution end there?"""
    return stop < len(blocks) and isinstance(blocks[stop], Heading)


def _names_again(block: Block, earlier: Sequence[Block]) -> bool:
    """Does it only name something, as an earlier line did, there perhaps with its number: I_G = m k_G²?"""
    if not isinstance(block, Equation) or block.number is not None or len(block.lead) != 1 or block.note:
        return False
    words = block.lead[0]
    if not isinstance(words, Text) or not words.text.startswith(INERTIA):
        return False
    # A letter that is sought in one case and given in another is the same in print.
    own = repr(block.sides)
    return any(
        isinstance(b, Equation) and b.lead == block.lead and repr(b.sides[: len(block.sides)]) == own for b in earlier
    )


def _without(block: Forces, earlier: Sequence[Block]) -> Block | None:
    """The diagram of a body by the forces that are gone from it; None: it is another."""
    own = list(_entries(block.left))
    for other in earlier:
        if not isinstance(other, Forces) or other.body != block.body or other.right != block.right:
            continue
        entries = list(_entries(other.left))
        gone = [e for e in entries if e not in own]
        if gone and [e for e in entries if e not in gone] == own:
            names = [p for i, e in enumerate(gone) for p in (*([", "] if i else []), e[0])]
            return Paragraph(line(f"{block.body}: the diagram as before, without ", *names))
    return None


def _entries(acting: Line) -> Iterator[Line]:
    """The forces of a diagram, one by one."""
    entry: list[Inline] = []
    for piece in acting:
        if isinstance(piece, Text) and piece.text == BETWEEN:
            yield tuple(entry)
            entry = []
        else:
            entry.append(piece)
    yield tuple(entry)


def _leads(block: Block) -> bool:
    """Does a sentence announce what follows?"""
    return isinstance(block, Paragraph)


def _as_before(run: Sequence[Block], step: str = "") -> Paragraph:
    """In place of a run of lines. `step`: of which they are all."""
    numbers = [b.number for b in run if isinstance(b, Equation) and b.number is not None]
    drawn = ["the diagram"] if any(isinstance(b, Forces) for b in run) else []
    if numbers:
        drawn.append(_range(min(numbers), max(numbers)))
    return Paragraph(line(f"{f'{step} as' if step else 'As'} before{': ' if drawn else ''}{' and '.join(drawn)}."))


def _range(first: int, last: int) -> str:
    if first == last:
        return f"({first})"
    return f"({first}) {'and' if last == first + 1 else 'to'} ({last})"
