"""The forces, or the m a, of one side of a diagram, one by one: m g ↓ at G,  N ↑ at C."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from planar_cli.report.document.blocks import Inline, Line, Text, line

BETWEEN = Text(",  ")
"""Stands between two of them."""
ASSUMED = " (assumed)"
"""Stands behind the direction of a force that may be the other one."""


def entries(side: Line) -> Iterator[Line]:
    """What stands on one side, one by one."""
    entry: list[Inline] = []
    for piece in side:
        if piece == BETWEEN:
            yield tuple(entry)
            entry = []
        else:
            entry.append(piece)
    if entry:
        yield tuple(entry)


def listed(found: Iterable[Iterable[Inline]]) -> Line:
    """A side of a diagram that has these."""
    return line(*(piece for i, entry in enumerate(found) for piece in (BETWEEN, *entry)[i == 0 :]))
