"""Linear complementarity: w = q + M z with w >= 0, z >= 0 and w z = 0, by Lemke's method; all solutions of small ones.

Contacts that may press or part, stick or slip are of this form (C. Glocker, Set-Valued Force Laws, 2001). The numbers
are plain floats; the caller scales them so that 1 is a usual size.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product

ZERO = 1e-11
"""A pivot below this part of the largest entry is zero."""
MOST_ENUMERATED = 8
"""Up to so many pairs all choices are tried, 2 to the power of it."""

Matrix = list[list[float]]


def lemke(matrix: Sequence[Sequence[float]], q: Sequence[float]) -> list[float] | None:
    """One solution z; None where the method ends on a ray: there is none, for the matrices that contacts have."""
    n = len(q)
    size = max((abs(x) for row in matrix for x in row), default=1.0) or 1.0
    height = max((abs(x) for x in q), default=0.0)
    if all(x >= -ZERO * height for x in q):
        return [0.0] * n
    # Columns: w_0 … w_n-1, z_0 … z_n-1, the artificial one, the right side.
    rows = [
        [*(1.0 if i == j else 0.0 for j in range(n)), *(-matrix[i][j] / size for j in range(n)), -1.0, q[i] / height]
        for i in range(n)
    ]
    basis = list(range(n))
    row = min(range(n), key=lambda i: rows[i][-1])
    entering = 2 * n
    for _ in range(50 * (n + 1)):
        leaving = basis[row]
        _pivot(rows, row, entering)
        basis[row] = entering
        if leaving == 2 * n:
            found = [0.0] * n
            for i, name in enumerate(basis):
                if n <= name < 2 * n:
                    found[name - n] = max(rows[i][-1], 0.0) * height / size
            return found
        entering = leaving + n if leaving < n else leaving - n
        ratios = [(rows[i][-1] / rows[i][entering], i) for i in range(n) if rows[i][entering] > ZERO]
        if not ratios:
            return None
        least = min(ratios)[0]
        ties = [i for ratio, i in ratios if ratio <= least + ZERO]
        # The artificial variable leaves first where it may; else the largest pivot rounds least.
        row = next((i for i in ties if basis[i] == 2 * n), max(ties, key=lambda i: rows[i][entering]))
    return None


def all_solutions(matrix: Sequence[Sequence[float]], q: Sequence[float], slack: float) -> list[list[float]]:
    """Every solution with isolated z of a small problem; `slack`: by how much a number may be negative."""
    n = len(q)
    found: list[list[float]] = []
    for active in product((False, True), repeat=n):
        inside = [i for i in range(n) if active[i]]
        part = solved([[matrix[i][j] for j in inside] for i in inside], [-q[i] for i in inside])
        if part is None or any(x < -slack for x in part):
            continue
        z = [0.0] * n
        for i, x in zip(inside, part, strict=True):
            z[i] = max(x, 0.0)
        w = [q[i] + sum(matrix[i][j] * z[j] for j in inside) for i in range(n)]
        if all(x >= -slack for x in w):
            found.append(z)
    return found


def solved(matrix: Sequence[Sequence[float]], right: Sequence[float]) -> list[float] | None:
    """The solution of a square system; None where it is singular."""
    n = len(right)
    rows = [[*row, r] for row, r in zip(matrix, right, strict=True)]
    sizes = [max((abs(x) for x in row[:-1]), default=0.0) for row in rows]
    for k in range(n):
        best = max(range(k, n), key=lambda i: abs(rows[i][k]) / (sizes[i] or 1.0))
        rows[k], rows[best], sizes[k], sizes[best] = rows[best], rows[k], sizes[best], sizes[k]
        if abs(rows[k][k]) <= ZERO * sizes[k] or rows[k][k] == 0:
            return None
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            if factor:
                rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k], strict=True)]
    found = [0.0] * n
    for k in reversed(range(n)):
        found[k] = (rows[k][-1] - sum(rows[k][j] * found[j] for j in range(k + 1, n))) / rows[k][k]
    return found


def _pivot(rows: Matrix, row: int, column: int) -> None:
    pivot = rows[row][column]
    rows[row] = [x / pivot for x in rows[row]]
    for i, other in enumerate(rows):
        factor = other[column]
        if i != row and factor:
            rows[i] = [a - factor * b for a, b in zip(other, rows[row], strict=True)]
