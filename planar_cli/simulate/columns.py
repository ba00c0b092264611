"""Tables and lines in the width of a terminal: a table that is too wide goes on below, with its first columns again."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterable, Iterator, Sequence

from planar_cli.plain_letters import letters

USUAL = 10_000
"""Columns where nobody looks at a terminal: lines are as long as they are."""
INDENT, GAP = 2, 2
NARROW = 60
"""In fewer columns nothing stands before a table, and one space between its columns."""
HANG = 2
"""What a line goes on with further to the right."""


def in_width(
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    first: int,
    width: int,
    left: Collection[int] = (),
    indent: int = INDENT,
) -> list[str]:
    """The lines of a table. `first`: so many columns stand before each part of it; `left`: those that are flush
    left, as they hold texts.
    """
    heads, rows = [letters(h) for h in heads], [[letters(c) for c in row] for row in rows]
    sizes = [max(map(len, column)) for column in zip(heads, *rows, strict=True)]
    indent, gap = (indent, GAP) if width >= NARROW else (0, 1)
    lines: list[str] = []
    for chosen in _parts(sizes, first, width - indent, gap):
        lines += [""] if lines else []
        for row in (heads, *rows):
            cells = [row[k].ljust(sizes[k]) if k in left else row[k].rjust(sizes[k]) for k in chosen]
            lines.append((" " * indent + (" " * gap).join(cells)).rstrip())
    return lines


def _parts(sizes: Sequence[int], first: int, room: int, gap: int) -> Iterator[list[int]]:
    """Which columns stand beside each other: as many as there is room for, one at least."""
    again = list(range(first))
    used = sum(sizes[k] + gap for k in again)
    part, width = list(again), used - gap
    for k in range(first, len(sizes)):
        if len(part) > first and width + gap + sizes[k] > room:
            yield part
            part, width = list(again), used - gap
        part.append(k)
        width += gap + sizes[k]
    yield part


def wrapped(lines: Iterable[str], width: int) -> Iterator[str]:
    """Lines that are not longer; what is cut goes on a little to the right of where the line begins."""
    for line in map(letters, lines):
        if len(line) <= width:
            yield line
            continue
        lead = " " * min(len(line) - len(line.lstrip()), width // 2)
        hang = lead + " " * HANG
        made = textwrap.TextWrapper(width, initial_indent=lead, subsequent_indent=hang, break_on_hyphens=False)
        yield from made.wrap(line.strip())
