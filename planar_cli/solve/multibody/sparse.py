"""Sparse linear equations in sixty-digit numbers, for the independent check: what they determine and contradict.

An equation is {column: coefficient}, with the constant at column -1: Σ coefficient · x + constant = 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from decimal import Decimal

from planar_cli.equation.values.exact import CERTAIN, ZERO
from planar_cli.records import changing

CONSTANT = -1
Line = dict[int, Decimal]


@changing
class Echelon:
    """Equations in the order in which they were added, each free of the leading unknowns of those before it."""

    pivots: list[tuple[int, Line]] = field(default_factory=list)

    def reduced(self, line: Line) -> Line:
        """What an expression becomes when every leading unknown is replaced; what has cancelled is left out."""
        work = dict(line)
        for lead, pivot in self.pivots:
            factor = work.pop(lead, None)
            if not factor:
                continue
            for j, c in pivot.items():
                if j == lead:
                    continue
                before = work.get(j, ZERO)
                after = before - factor * c
                if abs(after) <= CERTAIN * abs(before):
                    work.pop(j, None)
                else:
                    work[j] = after
        return work

    def add(self, line: Line, prefer: Callable[[int], bool] = lambda _: True) -> Decimal:
        """Take in one equation; the remainder that contradicts those before it, relative to its size (zero: none).

        The largest coefficient leads, among the preferred columns if one of these remains.
        """
        size = max((abs(c) for j, c in line.items() if j != CONSTANT), default=ZERO) or abs(line.get(CONSTANT, ZERO))
        if not size:
            return ZERO
        line = {j: c / size for j, c in line.items() if c}
        work = self.reduced(line)
        rest = [j for j, c in work.items() if j != CONSTANT and abs(c) > CERTAIN]
        if not rest:
            return abs(work.get(CONSTANT, ZERO)) / max(abs(line.get(CONSTANT, ZERO)), Decimal(1))
        lead = max([j for j in rest if prefer(j)] or rest, key=lambda j: abs(work[j]))
        top = work[lead]
        kept = {j: c / top for j, c in work.items() if j == CONSTANT or abs(c) > CERTAIN}
        self.pivots.append((lead, kept))
        return ZERO

    def value(self, line: Line) -> Decimal | None:
        """The value of Σ coefficient · x + constant; None where the equations leave it open."""
        work = self.reduced(line)
        size = max((abs(c) for j, c in line.items() if j != CONSTANT), default=ZERO)
        if any(abs(c) > CERTAIN * size for j, c in work.items() if j != CONSTANT):
            return None
        return work.get(CONSTANT, ZERO)
