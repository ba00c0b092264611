"""The reason of a relation between accelerations, where it is that of the velocities: it is their derivative. Of the
condition of an extreme: what the derivative is taken of.
"""

from __future__ import annotations

from collections.abc import Callable

from planar_cli.report.blocks import Block, Line, Paragraph, Text, line
from planar_cli.report.extreme_rates import with_rate
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution


class Reasons:
    """The reasons that were told of velocities, with the numbers of their equations."""

    def __init__(self, instant: InstantSolution, phrases: Phrases) -> None:
        self._instant, self._phrases = instant, phrases
        self._told: dict[tuple[str, Line], int] = {}

    def once(self, w: Written, stage: Stage, number: Callable[[Stage, int], int], blocks: list[Block]) -> list[Block]:
        """The blocks of a relation: `(1), differentiated:` in place of the sentence of equation 1. `number`: tells the
        printed number of an equation.
        """
        if w.source == "extreme":
            return with_rate(w, stage, self._instant, self._phrases, number, blocks)
        first = blocks[0] if blocks else None
        if not isinstance(first, Paragraph) or w.law != "relation" or w.source == "given":
            return blocks
        if stage.level == "velocity":
            self._told[w.lead, _once(first.line)] = number(stage, w.number)
            return blocks
        before = self._told.get((w.lead, _once(first.line)))
        return blocks if before is None else [Paragraph(line(f"({before}), differentiated:")), *blocks[1:]]


def _once(told: Line) -> Line:
    """A reason that ends with `; differentiated twice:` as it is before the velocities."""
    return told[:-1] if told and isinstance(told[-1], Text) and told[-1].text.startswith("; differentiated") else told
