"""A sparse linear system in terms, solved in a fixed order of pivots: the unknowns as terms, and what to check.

Where the system is symmetric, both halves are the same terms, so that the code computes them once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from planar_cli.motion.pivots import Order, order
from planar_cli.motion.source import Check
from planar_cli.motion.terms import Graph, Term, evaluate

SMALL_PIVOT = 1e-7
"""A pivot that shrinks below this part of its parts no longer serves."""

Rows = Sequence[Mapping[int, Term]]
"""The coefficients of each equation, by unknown."""


@dataclass(frozen=True, slots=True)
class Eliminated:
    """The solution of a system."""

    unknowns: tuple[Term, ...]
    """In their order; 0 where the system leaves one open."""
    checks: tuple[Check, ...]
    """Pivots that vary."""
    order: Order
    """How it was found."""


def chosen(rows: Rows, values: Mapping[Term, float] | None = None) -> Order:
    """The order of pivots from the numbers of the reference configuration, or from other values of the variables."""
    entries = [(i, j, t) for i, row in enumerate(rows) for j, t in row.items()]
    numbers = [t.value for _, _, t in entries] if values is None else evaluate((t for _, _, t in entries), values)
    found: list[dict[int, tuple[float, bool]]] = [{} for _ in rows]
    for (i, j, t), number in zip(entries, numbers, strict=True):
        found[i][j] = (number, not t.constant)
    return order(found)


def eliminate(graph: Graph, rows: Rows, right: Sequence[Term], by: Order | None = None) -> Eliminated:
    """Solve rows · unknowns = right, in the order given, else in that of the reference configuration."""
    (solved,) = eliminate_all(graph, rows, [right], by)
    return solved


def eliminate_all(
    graph: Graph, rows: Rows, rights: Sequence[Sequence[Term]], by: Order | None = None
) -> tuple[Eliminated, ...]:
    """The same for several right sides."""
    by = by or chosen(rows)
    open_rows, open_columns = set(by.rows), set(by.columns)
    left = [
        {j: t for j, t in row.items() if j not in open_columns} if i not in open_rows else {}
        for i, row in enumerate(rows)
    ]
    system = _System(left, [list(right) for right in rights])
    for pivot in by.pivots:
        system.eliminate(pivot.row, pivot.column)
    checks = tuple(
        Check(p, pivot.size * SMALL_PIVOT)
        for pivot, (_, _, p, _) in zip(by.pivots, system.solved, strict=True)
        if not p.constant
    )
    return tuple(Eliminated(_unknowns(graph, system, right), checks, by) for right in system.rights)


def _unknowns(graph: Graph, system: _System, right: list[Term]) -> tuple[Term, ...]:
    """From the last equation back to the first."""
    unknowns = [graph.number(0.0)] * len(right)
    for i, j, p, row in reversed(system.solved):
        total = right[i]
        for other, factor in row.items():
            total = total - factor * unknowns[other]
        unknowns[j] = total / p
    return tuple(unknowns)


class _System:
    """The equations as they are eliminated."""

    def __init__(self, rows: list[dict[int, Term]], rights: list[list[Term]]) -> None:
        self.rows, self.rights = rows, rights
        self.columns: list[set[int]] = [set() for _ in rows]
        for i, row in enumerate(rows):
            for j in row:
                self.columns[j].add(i)
        self.solved: list[tuple[int, int, Term, dict[int, Term]]] = []
        """Equation, unknown, pivot, and the rest of the equation at its time."""

    def eliminate(self, i: int, j: int) -> None:
        """Solve equation i for unknown j and put it into all others."""
        row = self.rows[i]
        pivot = row.pop(j)
        self.solved.append((i, j, pivot, row))
        for other in row:
            self.columns[other].discard(i)
        below = sorted(k for k in self.columns[j] if k != i)
        leads = {k: self.rows[k].pop(j) for k in below}
        # The same product stands in both halves of a symmetric system.
        known: dict[tuple[int, int], Term] = {}
        quotients = {k: lead / pivot for k, lead in leads.items()}
        for k, lead in leads.items():
            target = self.rows[k]
            for other, entry in row.items():
                pair = (lead.index, entry.index) if lead.index <= entry.index else (entry.index, lead.index)
                product = known.get(pair)
                if product is None:
                    product = known[pair] = quotients[k] * entry
                old = target.get(other)
                if old is None:
                    target[other] = -product
                    self.columns[other].add(k)
                else:
                    target[other] = old - product
            for right in self.rights:
                right[k] = right[k] - quotients[k] * right[i]
        self.columns[j] = set()
