"""The reason of a relation between accelerations, where it is that of the velocities: it is their derivative."""

from __future__ import annotations

from collections.abc import Callable

from planar_cli.report.blocks import Block, Line, Paragraph, line
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written


class Reasons:
    """The reasons that were told of velocities, with the numbers of their equations."""

    def __init__(self) -> None:
        self._told: dict[tuple[str, Line], int] = {}

    def once(self, w: Written, stage: Stage, number: Callable[[Stage, int], int], blocks: list[Block]) -> list[Block]:
        """The blocks of a relation: `(1), differentiated:` in place of the sentence of equation 1. `number`: tells the
        printed number of an equation.
        """
        first = blocks[0] if blocks else None
        if not isinstance(first, Paragraph) or w.law != "relation" or w.source == "given":
            return blocks
        if stage.level == "velocity":
            self._told[w.lead, first.line] = number(stage, w.number)
            return blocks
        before = self._told.get((w.lead, first.line))
        return blocks if before is None else [Paragraph(line(f"({before}), differentiated:")), *blocks[1:]]
