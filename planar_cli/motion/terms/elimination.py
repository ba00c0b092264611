"""A sparse linear system in terms, eliminated in a fixed order of pivots: its unknowns as terms, and what to check.

Where the system is symmetric, both halves are the same terms, so that the code computes them once.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.motion.terms.pivots import CANCELLED, Order, order
from planar_cli.motion.terms.source import Check
from planar_cli.motion.terms.terms import Graph, Term, evaluate
from planar_cli.records import record

SMALL_PIVOT = 1e-5
"""A pivot that shrinks below this part of its parts no longer serves, if it was larger where the order was chosen: as
much as it is small, accelerations magnify by what states inside a step miss the joints."""
SHRUNK = 1e-2
"""A pivot that is small everywhere no longer serves below this part of what it was where the order was chosen."""
LEAST_PIVOT = 1e-12
"""Below this part of its parts a pivot is rounding."""

Rows = Sequence[Mapping[int, Term]]
"""The coefficients of each equation, by unknown."""


@record
class Step:
    """One pivot with what it makes of the equations below it."""

    row: int
    column: int
    pivot: Term
    rest: Mapping[int, Term]
    """The other coefficients of its equation, at its time."""
    quotients: Mapping[int, Term]
    """By which multiple of it each other equation is lessened."""


@record
class Factored:
    """A system after its elimination, for any right side."""

    graph: Graph
    count: int
    steps: tuple[Step, ...]
    order: Order

    def solve(self, right: Sequence[Term]) -> tuple[Term, ...]:
        """The unknowns; 0 where the system leaves one open."""
        total = list(right)
        for step in self.steps:
            for k, quotient in step.quotients.items():
                total[k] = total[k] - quotient * total[step.row]
        unknowns = [self.graph.number(0.0)] * self.count
        for step in reversed(self.steps):
            value = total[step.row]
            for other, factor in step.rest.items():
                value = value - factor * unknowns[other]
            unknowns[step.column] = value / step.pivot
        return tuple(unknowns)

    def checks(self, small: float = SMALL_PIVOT) -> tuple[Check, ...]:
        """Pivots that vary, and how large they must be."""
        found = []
        for pivot, step in zip(self.order.pivots, self.steps, strict=True):
            if not step.pivot.constant:
                least = max(min(small * pivot.size, SHRUNK * abs(pivot.value)), LEAST_PIVOT * pivot.size)
                found.append(Check(step.pivot, least))
        return tuple(found)


def chosen(rows: Rows, values: Mapping[Term, float] | None = None, cancelled: float = CANCELLED) -> Order:
    """The order of pivots from the numbers of the reference configuration, or from other values of the variables.

    `cancelled`: smaller parts of what they are the difference of are no pivots.
    """
    entries = [(i, j, t) for i, row in enumerate(rows) for j, t in row.items()]
    numbers = [t.value for _, _, t in entries] if values is None else evaluate((t for _, _, t in entries), values)
    found: list[dict[int, tuple[float, bool]]] = [{} for _ in rows]
    for (i, j, t), number in zip(entries, numbers, strict=True):
        found[i][j] = (number, not t.constant)
    return order(found, cancelled)


def factor(graph: Graph, rows: Rows, by: Order | None = None) -> Factored:
    """Eliminate in the order given, else in that of the reference configuration."""
    by = by or chosen(rows)
    open_rows, open_columns = set(by.rows), set(by.columns)
    left = [
        {j: t for j, t in row.items() if j not in open_columns} if i not in open_rows else {}
        for i, row in enumerate(rows)
    ]
    columns: list[set[int]] = [set() for _ in rows]
    for i, row in enumerate(left):
        for j in row:
            columns[j].add(i)
    steps = tuple(_eliminated(left, columns, pivot.row, pivot.column) for pivot in by.pivots)
    return Factored(graph, len(rows), steps, by)


def _eliminated(rows: list[dict[int, Term]], columns: list[set[int]], i: int, j: int) -> Step:
    """Solve equation i for unknown j and put it into all others."""
    row = rows[i]
    pivot = row.pop(j)
    for other in row:
        columns[other].discard(i)
    leads = {k: rows[k].pop(j) for k in sorted(columns[j]) if k != i}
    quotients = {k: lead / pivot for k, lead in leads.items()}
    # The same product stands in both halves of a symmetric system.
    known: dict[tuple[int, int], Term] = {}
    for k, lead in leads.items():
        target, quotient, a = rows[k], quotients[k], lead.index
        for other, entry in row.items():
            b = entry.index
            pair = (a, b) if a <= b else (b, a)
            product = known.get(pair)
            if product is None:
                product = known[pair] = quotient * entry
            old = target.get(other)
            if old is None:
                target[other] = -product
                columns[other].add(k)
            else:
                target[other] = old - product
    columns[j] = set()
    return Step(i, j, pivot, row, quotients)
