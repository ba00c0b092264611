"""The order of pivots in which a sparse linear system is eliminated with the fewest operations.

Equation i belongs to unknown i (the balance of a coordinate to its acceleration, a constraint to its multiplier), so
that a pivot on the diagonal keeps a symmetric system symmetric. The order is chosen once from the numbers of one
configuration: among the pivots that are large enough, always the one that costs least (Markowitz, with operations
counted: constants cost nothing). What is left without an acceptable pivot is what the system does not determine.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping, Sequence

from planar_cli.records import record

SMALLEST = 1e-3
"""A pivot is at least this part of the largest entry of its column (rows and columns scaled to 1)."""
LASTING = 1e-2
"""A pivot of which this part is constant does not vanish elsewhere."""
CANCELLED = 1e-9
"""An entry below this part of the terms that it is the difference of is zero."""


@record
class Pivot:
    """One step of the elimination."""

    row: int
    """The equation."""
    column: int
    """The unknown for which it is solved."""
    value: float
    """The pivot, in its own unit."""
    size: float
    """How large the parts are that it is the sum of."""


@record
class Order:
    """In which order the system is eliminated."""

    pivots: tuple[Pivot, ...]
    rows: tuple[int, ...]
    """Equations that say nothing new: with what the others say, they are 0 = rest."""
    columns: tuple[int, ...]
    """Unknowns that stay open."""

    @property
    def least(self) -> float:
        """The smallest pivot, in parts of what it is the sum of."""
        return min((abs(p.value) / p.size for p in self.pivots), default=1.0)

    def least_beside(self, other: Order) -> float:
        """The smallest pivot, in parts of that of its equation in another configuration."""
        sizes = {p.row: p.size for p in other.pivots}
        return min((abs(p.value) / sizes[p.row] for p in self.pivots if sizes.get(p.row)), default=1.0)

    @property
    def places(self) -> tuple[tuple[int, int], ...]:
        """Equations and unknowns in their order."""
        return tuple((p.row, p.column) for p in self.pivots)


class Entry:
    """One coefficient in numbers."""

    __slots__ = ("fixed", "size", "value", "varies")

    def __init__(self, value: float, size: float, varies: bool) -> None:
        self.value = value
        """Scaled."""
        self.size = size
        """The largest part of it."""
        self.varies = varies
        """Is it not a constant?"""
        self.fixed = 0.0 if varies else value
        """The part of it that is constant."""


def order(rows: Sequence[Mapping[int, tuple[float, bool]]], cancelled: float = CANCELLED) -> Order:
    """The order for a square system: for every equation its coefficients by unknown, and whether they vary.

    `cancelled`: pivots below this part of the terms that they are the difference of are not taken.
    """
    return _Chooser(rows, cancelled).order()


def scales(rows: Sequence[Mapping[int, float]], count: int) -> tuple[list[float], list[float]]:
    """Powers of two for equations and unknowns that make the largest scaled coefficient in each of them about 1."""
    left, right = [0.0] * len(rows), [0.0] * count
    logs = [[(j, math.log2(abs(v))) for j, v in row.items() if v] for row in rows]
    for _ in range(4):
        tops = [-math.inf] * count
        for i, row in enumerate(logs):
            largest = max((v + right[j] for j, v in row), default=-left[i]) + left[i]
            left[i] -= largest / 2
            for j, v in row:
                tops[j] = max(tops[j], v + left[i] + right[j])
        for j, top in enumerate(tops):
            if top > -math.inf:
                right[j] -= top / 2
    return [2.0 ** round(s) for s in left], [2.0 ** round(s) for s in right]


class _Chooser:
    """The system in numbers, as it is eliminated."""

    def __init__(self, rows: Sequence[Mapping[int, tuple[float, bool]]], cancelled: float) -> None:
        count, self.cancelled = len(rows), cancelled
        self.left, self.right = scales([{j: v for j, (v, _) in row.items()} for row in rows], count)
        self.rows: list[dict[int, Entry]] = []
        self.columns: list[set[int]] = [set() for _ in range(count)]
        for i, row in enumerate(rows):
            entries = {}
            for j, (value, varies) in row.items():
                scaled = value * self.left[i] * self.right[j]
                entries[j] = Entry(scaled, abs(scaled), varies)
                self.columns[j].add(i)
            self.rows.append(entries)
        self.partner = list(range(count))
        """Of every equation, the unknown that it belongs to."""
        self.owner = list(range(count))
        """Of every unknown, the equation that belongs to it."""
        self.firm = {i for i, row in enumerate(rows) if i in row}
        """Equations that meet their own unknown from the beginning: those of what has mass."""
        self.open = set(range(count))
        self.offers = 0
        self.heap: list[tuple[float, int, int, int]] = []
        """Cost, when it was offered (of equals the first goes first), equation, unknown."""
        for i in range(count):
            self._offer(i)

    def order(self) -> Order:
        """Eliminate one pivot after the other."""
        pivots = []
        while self.open:
            found = self._cheapest() or self._elsewhere()
            if found is None:
                break
            i, j = found
            entry = self.rows[i][j]
            unit = 1.0 / (self.left[i] * self.right[j])
            pivots.append(Pivot(i, j, entry.value * unit, entry.size * unit))
            self._eliminate(i, j)
        rows = tuple(sorted(self.open))
        return Order(tuple(pivots), rows, tuple(sorted(self.partner[i] for i in rows)))

    def _cheapest(self) -> tuple[int, int] | None:
        """The cheapest pivot where an equation meets its own unknown."""
        while self.heap:
            cost, offer, i, j = heapq.heappop(self.heap)
            if i in self.open and self.partner[i] == j and self._acceptable(i, j):
                now = self._cost(i, j)
                if now <= cost or not self.heap or now <= self.heap[0][0]:
                    return i, j
                heapq.heappush(self.heap, (now, offer, i, j))
        return None

    def _elsewhere(self) -> tuple[int, int] | None:
        """The cheapest pivot anywhere."""
        best: tuple[float, int, int] | None = None
        for i in self.open:
            for j in self.rows[i]:
                if self._acceptable(i, j):
                    key = (self._cost(i, j), i, j)
                    best = key if best is None or key < best else best
        return None if best is None else best[1:]

    def _offer(self, i: int) -> None:
        j = self.partner[i]
        if j in self.rows[i]:
            self.offers += 1
            heapq.heappush(self.heap, (self._cost(i, j), self.offers, i, j))

    def _acceptable(self, i: int, j: int) -> bool:
        entry = self.rows[i].get(j)
        if entry is None or abs(entry.value) <= self.cancelled * entry.size:
            return False
        passing = i == j and i not in self.firm and abs(entry.fixed) < LASTING * abs(entry.value)
        if passing and any(k in self.firm for k in self.rows[i]):
            # What it is made of so far may vanish elsewhere, one part after the other.
            return False
        return abs(entry.value) >= SMALLEST * max(abs(self.rows[k][j].value) for k in self.columns[j])

    def _cost(self, i: int, j: int) -> float:
        """Operations that the pivot makes: quotients, products and sums; a symmetric half is shared."""
        row, column = self.rows[i], self.columns[j]
        pivot = row[j].varies
        varying = sum(1 for k in column if k != i and self.rows[k][j].varies)
        quotients = len(column) - 1 if pivot else varying
        products = sums = 0
        for k in column:
            if k == i:
                continue
            factor = pivot or self.rows[k][j].varies
            target = self.rows[k]
            for other, entry in row.items():
                if other != j and (factor or entry.varies):
                    products += 1
                    sums += other in target
        shared = 0.5 if self.partner[i] == j else 1.0
        # The right side and the unknowns found last: a product and a sum each.
        return shared * (products + sums) + quotients + 2 * (len(column) + len(row) - 2)

    def _eliminate(self, i: int, j: int) -> None:
        row = self.rows[i]
        self._pair(i, j)
        self.open.discard(i)
        others = [k for k in self.columns[j] if k != i]
        pivot = row.pop(j)
        for other in row:
            self.columns[other].discard(i)
        for k in others:
            target = self.rows[k]
            lead = target.pop(j)
            factor, varies = lead.value / pivot.value, lead.varies or pivot.varies
            for other, entry in row.items():
                change = factor * entry.value
                old = target.get(other)
                if old is None:
                    target[other] = Entry(-change, abs(change), varies or entry.varies)
                    self.columns[other].add(k)
                else:
                    old.value -= change
                    old.size = max(old.size, abs(factor) * entry.size)
                    old.varies |= varies or entry.varies
                    if not (varies or entry.varies):
                        old.fixed -= change
        self.columns[j] = set()
        self._refresh(others, row)

    def _pair(self, i: int, j: int) -> None:
        """Equation i is used up for unknown j: what belonged to them belongs together now."""
        other, own = self.owner[j], self.partner[i]
        if other != i:
            self.partner[other], self.owner[own] = own, other
            self.partner[i], self.owner[j] = j, i

    def _refresh(self, rows: Sequence[int], columns: Mapping[int, Entry]) -> None:
        """Offer anew the pivots whose cost or size has changed."""
        for i in {*rows, *(self.owner[j] for j in columns)}:
            if i in self.open:
                self._offer(i)
