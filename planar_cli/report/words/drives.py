"""What keeps a motion as the file gives it acts on the bodies too: the page says what its letter in the diagrams is."""

from __future__ import annotations

import re
from collections.abc import Sequence

from planar_cli.report.document.blocks import Block, Forces, Line, Math, Name, Paragraph, Text, line

DRIVE = re.compile(r"drive_\d+")
FORCES, COUPLES = "↑↓→←↗↖↘↙", "↺↻"
FORCE, COUPLE = "force", "couple"
OPPOSITE = dict(zip(FORCES + COUPLES, "↓↑←→↙↘↖↗" + "↻↺", strict=True))


def with_drives_told(blocks: Sequence[Block]) -> list[Block]:
    """The blocks of a part with such a line below the first diagrams in which a drive stands."""
    if not any(isinstance(b, Forces) for b in blocks):
        return list(blocks)
    found: list[Block] = []
    told: set[str] = set()
    waiting: dict[str, str] = {}
    on: dict[str, list[tuple[str, str]]] = {}
    for block in blocks:
        if isinstance(block, Forces):
            for name, what in _drives(block.left).items():
                if name not in told:
                    waiting[name] = COUPLE if what in COUPLES else FORCE
                    on.setdefault(name, []).append((block.body, what))
        else:
            for name, what in waiting.items():
                pair = _pair(on[name])
                found.append(Paragraph(line(Name(name), f": the {what}{pair} that keeps the motion as given")))
            told |= waiting.keys()
            waiting = {}
        found.append(block)
    return found


def _pair(acts: Sequence[tuple[str, str]]) -> str:
    """` of boat and man on each other`, as where a man walks on a deck: on two bodies in opposite directions."""
    match acts:
        case [(one, arrow), (other, back)] if OPPOSITE[arrow] == back:
            return f" of {one} and {other} on each other"
    return ""


def _drives(side: Line) -> dict[str, str]:
    """The drives in one row, each with its arrow."""
    found = {}
    for piece, after in zip(side, (*side[1:], Text("")), strict=True):
        name = piece.expr.name if isinstance(piece, Math) and piece.expr.is_Symbol else ""
        arrow = after.text.strip()[:1] if isinstance(after, Text) else ""
        if DRIVE.fullmatch(name) and arrow and arrow in FORCES + COUPLES:
            found[name] = arrow
    return found
