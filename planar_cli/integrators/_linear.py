"""Small dense systems of linear equations, real or complex, on lists of rows."""

from __future__ import annotations

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
        rows, n = self._rows, len(self._rows)
        x = [right[i] for i in self._order]
        for i in range(1, n):
            row, total = rows[i], x[i]
            for j in range(i):
                if row[j]:
                    total = total - row[j] * x[j]
            x[i] = total
        for i in reversed(range(n)):
            row, total = rows[i], x[i]
            for j in range(i + 1, n):
                if row[j]:
                    total = total - row[j] * x[j]
            x[i] = total / row[i]
        return x
