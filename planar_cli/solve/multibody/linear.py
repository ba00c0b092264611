"""Linear systems in sixty-digit numbers: rank, solution, what stays free, and which rows contradict each other.

Rows are lists of Decimal, the constant last: Σ row[j] x_j + row[-1] = 0. Every row is scaled to size one before the
elimination, so that "zero" means: cancelled to forty digits.
"""

from __future__ import annotations

from decimal import Decimal

from planar_cli.equation.values.exact import CERTAIN, ONE, ZERO
from planar_cli.records import record

Row = list[Decimal]


@record
class Solved:
    """What a system says.

    `values`: a solution, with zero for what is free. `null`: one vector per free unknown, by its column. `conflict`:
    multipliers of the given rows whose combination reads 0 = non-zero (None: no contradiction), with that remainder.
    """

    values: list[Decimal]
    null: dict[int, list[Decimal]]
    conflict: tuple[list[Decimal], Decimal] | None
    rank: int

    def unique(self, column: int) -> bool:
        """Is this unknown determined?"""
        return all(not vector[column] for vector in self.null.values())


def scaled(row: Row) -> Row:
    """The row divided by its largest coefficient (its constant when it has none).

    A coefficient of which only the last digits are left is zero: the arm of a normal through its own centre, say.
    """
    size = max((abs(c) for c in row[:-1]), default=ZERO) or abs(row[-1])
    if not size:
        return list(row)
    least = size * CERTAIN
    return [*(c / size if abs(c) > least else ZERO for c in row[:-1]), row[-1] / size]


def eliminate(rows: list[Row], width: int) -> tuple[list[tuple[int, Row]], list[Row]]:
    """Gauss-Jordan elimination with the largest pivot of each row. Returns (column, row) pairs and the rows left over.

    `width`: the number of leading columns that may be pivots; entries beyond are carried along.
    """
    pivots: list[tuple[int, Row]] = []
    left: list[Row] = []
    for row in rows:
        work = list(row)
        for column, pivot in pivots:
            factor = work[column]
            if factor:
                work = [clean(a - factor * b, a) if b else a for a, b in zip(work, pivot, strict=True)]
                work[column] = ZERO
        best = max(range(width), key=lambda j: abs(work[j]), default=-1)
        if best < 0 or not work[best]:
            # A constant that met nothing but zeros on the way still has the rounding of its own terms.
            left.append([*work[:-1], clean(work[-1], ZERO)])
            continue
        lead = work[best]
        work = [a / lead for a in work]
        work[best] = ONE
        pivots = [(c, _without(p, best, work)) for c, p in pivots]
        pivots.append((best, work))
    return pivots, left


def _without(row: Row, column: int, pivot: Row) -> Row:
    factor = row[column]
    if not factor:
        return row
    found = [clean(a - factor * b, a) if b else a for a, b in zip(row, pivot, strict=True)]
    found[column] = ZERO
    return found


def clean(value: Decimal, before: Decimal) -> Decimal:
    """Zero where everything but the last digits has cancelled."""
    return ZERO if (value and abs(value) <= CERTAIN * max(abs(before), CERTAIN)) or abs(value) <= CERTAIN else value


def solve(rows: list[Row], width: int) -> Solved:
    """Solve for `width` unknowns."""
    pivots, left = eliminate([scaled(r) for r in rows], width)
    conflict = _conflict(rows, width) if any(r[-1] for r in left) else None
    values = [ZERO] * width
    for column, row in pivots:
        values[column] = -row[-1]
    pivot_columns = {c for c, _ in pivots}
    null: dict[int, list[Decimal]] = {}
    for free in range(width):
        if free in pivot_columns:
            continue
        vector = [ZERO] * width
        vector[free] = ONE
        for column, row in pivots:
            vector[column] = -row[free]
        null[free] = vector
    return Solved(values, null, conflict, len(pivots))


def _conflict(rows: list[Row], width: int) -> tuple[list[Decimal], Decimal] | None:
    """The first contradiction, as a combination of the rows as given (scaled)."""
    count = len(rows)
    marked = [
        [*scaled(r)[:-1], *(ONE if i == j else ZERO for j in range(count)), scaled(r)[-1]] for i, r in enumerate(rows)
    ]
    _, left = eliminate(marked, width)
    for row in left:
        if row[-1]:
            return row[width:-1], row[-1]
    return None


def determines(rows: list[Row], width: int, targets: list[int]) -> bool:
    """Do the rows fix all the target columns?"""
    fixed = determined(rows, width)
    return all(t in fixed for t in targets)


def determined(rows: list[Row], width: int) -> set[int]:
    """The columns that the rows fix."""
    pivots, _ = eliminate(rows, width)
    leading = {column for column, _ in pivots}
    free = [j for j in range(width) if j not in leading]
    return {column for column, row in pivots if not any(row[j] for j in free)}


def rank(rows: list[Row], width: int) -> int:
    return len(eliminate(rows, width)[0])


class Span:
    """Rows that grow one at a time, with the question whether the next one says anything new."""

    def __init__(self, width: int) -> None:
        self.width = width
        self.pivots: list[tuple[int, Row]] = []

    def grows(self, row: Row) -> bool:
        """Take in a row; False when it follows from those before it."""
        work = list(row)
        for column, pivot in self.pivots:
            factor = work[column]
            if factor:
                work = [clean(a - factor * b, a) if b else a for a, b in zip(work, pivot, strict=True)]
                work[column] = ZERO
        best = max(range(self.width), key=lambda j: abs(work[j]), default=-1)
        if best < 0 or not work[best]:
            return False
        lead = work[best]
        self.pivots.append((best, [a / lead if a else a for a in work]))
        return True


def determinant(rows: list[list[Decimal]]) -> Decimal:
    """Of a square matrix, by elimination: of many rows there are too many products to write them out."""
    left, found = rows, Decimal(1)
    while left:
        pivot = max(left, key=lambda row: abs(row[0]))
        if not pivot[0]:
            return Decimal(0)
        found *= pivot[0] * (-1) ** left.index(pivot)
        others = [row for row in left if row is not pivot]
        left = [[c - row[0] / pivot[0] * p for c, p in zip(row[1:], pivot[1:], strict=True)] for row in others]
    return found
