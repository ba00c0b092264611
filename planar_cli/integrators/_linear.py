"""Small dense systems of linear equations, real or complex, on lists of rows."""

from __future__ import annotations

from operator import mul
from typing import Generic, TypeVar

N = TypeVar("N", float, complex)


class Factors(Generic[N]):
    """A square matrix as a product of triangular ones, with its rows in the order of the pivots.

    Raises ZeroDivisionError if it is singular.
    """

    __slots__ = ("_order", "_rows")

    def __init__(self, rows: list[list[N]]) -> None:
        n = len(rows)
        order = list(range(n))
        for k in range(n):
            best = max(range(k, n), key=lambda i: abs(rows[i][k]))
            rows[k], rows[best] = rows[best], rows[k]
            order[k], order[best] = order[best], order[k]
            top = rows[k]
            pivot, tail = top[k], top[k + 1 :]
            for row in rows[k + 1 :]:
                if row[k]:
                    factor = row[k] / pivot
                    row[k] = factor
                    row[k + 1 :] = [a - factor * b for a, b in zip(row[k + 1 :], tail, strict=True)]
            if not pivot:
                raise ZeroDivisionError("singular matrix")
        self._rows: list[list[N]] = rows
        self._order = order

    def solve(self, right: list[N]) -> list[N]:
        """The solution for one right-hand side."""
        rows, x = self._rows, [right[i] for i in self._order]
        for i, row in enumerate(rows):
            x[i] = x[i] - sum(map(mul, row[:i], x))
        for i in reversed(range(len(rows))):
            row = rows[i]
            x[i] = (x[i] - sum(map(mul, row[i + 1 :], x[i + 1 :]))) / row[i]
        return x
