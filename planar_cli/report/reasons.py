"""The reason of a relation between accelerations, where it is that of the velocities: it is their derivative."""

from __future__ import annotations

from planar_cli.report.blocks import Block, Line, Paragraph, line
from planar_cli.solve.instant.written import Written


class Reasons:
    """The reasons that were told of velocities, with the numbers of their equations."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, Line], int] = {}

    def once(self, w: Written, level: str, number: int, blocks: list[Block]) -> list[Block]:
        """The blocks of a relation: `(1), differentiated:` in place of the sentence of equation 1."""
        first = blocks[0] if blocks else None
        if not isinstance(first, Paragraph) or w.law != "relation" or w.source == "given":
            return blocks
        if level == "velocity":
            self._told[w.lead, first.line] = number
            return blocks
        before = self._told.get((w.lead, first.line))
        return blocks if before is None else [Paragraph(line(f"({before}), differentiated:")), *blocks[1:]]
