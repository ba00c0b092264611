"""What keeps a motion as the file gives it acts on the bodies too: the page says what its letter in the diagrams is."""

from __future__ import annotations

import re
from collections.abc import Sequence

from planar_cli.report.blocks import Block, Forces, Line, Math, Name, Paragraph, Text, line

DRIVE = re.compile(r"drive_\d+")
FORCES, COUPLES = "↑↓→←↗↖↘↙", "↺↻"


def with_drives_told(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part with such a line below the first diagrams in which a drive stands."""
    if not any(isinstance(b, Forces) for b in blocks):
        return list(blocks)
    found: list[Block] = []
    told: set[str] = set()
    waiting: dict[str, str] = {}
    for block in blocks:
        if isinstance(block, Forces):
            waiting |= {name: what for name, what in _drives(block.left).items() if name not in told}
        else:
            words = ((n, f": the {what} that keeps the motion as given") for n, what in waiting.items())
            found += [Paragraph(line(Name(n), told_of)) for n, told_of in words]
            told |= waiting.keys()
            waiting = {}
        found.append(block)
    return found


def _drives(side: Line) -> dict[str, str]:
    """The drives in one row, each with what it is by its arrow."""
    found = {}
    for piece, after in zip(side, (*side[1:], Text("")), strict=True):
        name = piece.expr.name if isinstance(piece, Math) and piece.expr.is_Symbol else ""
        arrow = after.text.strip()[:1] if isinstance(after, Text) else ""
        if DRIVE.fullmatch(name) and arrow and arrow in FORCES + COUPLES:
            found[name] = "couple" if arrow in COUPLES else "force"
    return found
