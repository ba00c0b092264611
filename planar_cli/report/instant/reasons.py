"""The reason of a relation between accelerations, where it is that of the velocities: it is their derivative. So it is
of two wheels in mesh, R ω_1 = -r ω_2. Of the condition of an extreme: what the derivative is taken of.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Paragraph, Text, line
from planar_cli.report.instant.extreme_rates import with_rate
from planar_cli.report.notation.names import index_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution


class Reasons:
    """The reasons that were told of velocities, with the numbers of their equations."""

    def __init__(self, instant: InstantSolution, phrases: Phrases) -> None:
        self._instant, self._phrases = instant, phrases
        self._told: dict[tuple[str, Line], int] = {}
        self._turning: list[tuple[str, sp.Expr, int]] = []
        """Between angular velocities: of which joint, what vanishes, the number."""

    def once(self, w: Written, stage: Stage, number: Callable[[Stage, int], int], blocks: list[Block]) -> list[Block]:
        """The blocks of a relation: `(1), differentiated:` in place of the sentence of equation 1. `number`: tells the
        printed number of an equation.
        """
        if w.source == "extreme":
            return with_rate(w, stage, self._instant, self._phrases, number, blocks)
        if (before := self._in_mesh(w, stage, number)) is not None and self._is_of_contact(blocks):
            return [Paragraph(line(f"({before}), differentiated:")), blocks[-1]]
        first = blocks[0] if blocks else None
        if not isinstance(first, Paragraph) or w.law != "relation" or w.source == "given":
            return blocks
        if stage.level == "velocity":
            self._told[w.lead, _once(first.line)] = number(stage, w.number)
            return blocks
        before = self._told.get((w.lead, _once(first.line)))
        return blocks if before is None else [Paragraph(line(f"({before}), differentiated:")), *blocks[1:]]

    def _in_mesh(self, w: Written, stage: Stage, number: Callable[[Stage, int], int]) -> int | None:
        """The number of the relation of angular velocities of which one of angular accelerations is the derivative."""
        edges = [e for e in self._instant.trial.system.tree.edges if e.spin is not None and e.spin_rate is not None]
        if w.law != "relation" or w.source == "given":
            return None
        if stage.level == "velocity":
            spins = {e.spin for e in edges}
            if w.residual.free_symbols & set(stage.algebra.unknowns) <= spins:
                self._turning.append((w.lead, w.residual, number(stage, w.number)))
            return None
        rates = {e.spin: e.spin_rate for e in edges}
        for lead, residual, before in self._turning:
            derived = residual.xreplace(rates)
            if lead == w.lead and derived != residual and _is_multiple(derived, w.residual):
                return before
        return None

    def _is_of_contact(self, blocks: list[Block]) -> bool:
        """Are the accelerations before a relation those of the point of contact, a_C of each body, and of no other?"""
        *vectors, sentence, equation = blocks if len(blocks) > 1 else (None, None)
        if not vectors or not isinstance(sentence, Paragraph) or not isinstance(equation, Equation):
            return False
        lefts = [b.sides[0] for b in vectors if isinstance(b, Equation) and b.number is None]
        names = [side[0].name for side in lefts if isinstance(side, tuple) and isinstance(side[0], Name)]
        bodies = tuple(f",{index_of(body)}" for body in self._instant.instant.scene.bodies)
        return len(names) == len(vectors) and all(n.endswith(bodies) for n in names)


def _is_multiple(one: sp.Expr, other: sp.Expr) -> bool:
    return any(expanded(one - sign * other) == 0 for sign in (1, -1))


def _once(told: Line) -> Line:
    """A reason that ends with `; differentiated twice:` as it is before the velocities."""
    return told[:-1] if told and isinstance(told[-1], Text) and told[-1].text.startswith("; differentiated") else told
