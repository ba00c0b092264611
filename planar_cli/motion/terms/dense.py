"""Linear least squares that finds its rank: QR with column pivoting, then from the right (complete orthogonal).

For what the fixed pivot order does not carry: redundant equations, singular positions, starts. Of all solutions the
shortest is taken, in the scale of the unknowns; what contradicts itself is met in the mean.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from planar_cli.motion.terms.pivots import scales
from planar_cli.records import record

DEPENDENT = 1e-11
"""What is left of a column below this part of its size depends on the others."""
LARGE = 20
"""Systems with more unknowns go to NumPy's singular values: its import takes as long as some of them here."""

Matrix = Sequence[Sequence[float]]


@record
class Fit:
    """The solution of a system in the sense of least squares."""

    unknowns: tuple[float, ...]
    rank: int
    misfit: float
    """The largest remainder of an equation, in parts of its largest term (or of the largest right side)."""


def least_squares(matrix: Matrix, right: Sequence[float], dependent: float = DEPENDENT) -> Fit:
    """matrix · x = right."""
    count = len(matrix[0]) if matrix else 0
    rows, columns = scales([dict(enumerate(row)) for row in matrix], count)
    scaled = [[v * r * c for v, c in zip(row, columns, strict=True)] for row, r in zip(matrix, rows, strict=True)]
    wanted = [b * r for b, r in zip(right, rows, strict=True)]
    solve = _by_singular_values if count > LARGE else _by_reflections
    found, rank = solve(scaled, wanted, dependent)
    largest = max((abs(x) for x in found), default=0.0)
    misfit = 0.0
    for row, b in zip(scaled, wanted, strict=True):
        size = max(abs(b), *(abs(v * x) for v, x in zip(row, found, strict=True)), largest)
        rest = abs(math.fsum([*(v * x for v, x in zip(row, found, strict=True)), -b]))
        if size:
            misfit = max(misfit, rest / size)
    return Fit(tuple(x * c for x, c in zip(found, columns, strict=True)), rank, misfit)


def in_the_mean(matrix: Matrix, right: Sequence[float], dependent: float = DEPENDENT) -> list[float]:
    """matrix · x = right, each equation with the weight of its own scale: what hardly depends on x tells nothing."""
    count = len(matrix[0]) if matrix else 0
    solve = _by_singular_values if count > LARGE else _by_reflections
    return solve(matrix, right, dependent)[0]


def constrained(matrix: Matrix, right: Sequence[float], count: int, dependent: float = DEPENDENT) -> list[float]:
    """[M Jᵀ; J 0] (a, ν) = right with a diagonal M of `count` rows, by the null space of J.

    What J alone decides is decided by J, so that an almost singular J loses its digits once and not twice.
    """
    mass = [matrix[i][i] for i in range(count)]
    rows = [row[:count] for row in matrix[count:]]
    found = list(least_squares(rows, right[count:], dependent).unknowns) if rows else [0.0] * count
    free = null_space(rows, count, dependent)
    if free:
        rest = [q - m * a for q, m, a in zip(right, mass, found, strict=False)]
        inner = [[sum(m * x * y for m, x, y in zip(mass, u, v, strict=True)) for v in free] for u in free]
        outer = [sum(x * q for x, q in zip(u, rest, strict=True)) for u in free]
        for share, u in zip(least_squares(inner, outer).unknowns, free, strict=True):
            found = [a + share * x for a, x in zip(found, u, strict=True)]
    if not rows:
        return found
    rest = [q - m * a for q, m, a in zip(right, mass, found, strict=False)]
    return [*found, *least_squares(list(zip(*rows, strict=True)), rest, dependent).unknowns]


def null_space(matrix: Matrix, count: int, dependent: float = DEPENDENT) -> list[list[float]]:
    """Independent vectors x with matrix · x = 0; the unknowns in their own scale."""
    if not matrix:
        return [[float(i == j) for j in range(count)] for i in range(count)]
    rows, columns = scales([dict(enumerate(row)) for row in matrix], count)
    scaled = [[v * r * c for v, c in zip(row, columns, strict=True)] for row, r in zip(matrix, rows, strict=True)]
    triangle, order, rank, _ = _reflected(scaled, [0.0] * len(scaled), dependent)
    found = []
    for free in range(rank, count):
        vector = [0.0] * count
        vector[order[free]] = columns[order[free]]
        solution = _back([row[:rank] for row in triangle[:rank]], [-row[free] for row in triangle[:rank]])
        for k, value in enumerate(solution):
            vector[order[k]] = value * columns[order[k]]
        found.append(vector)
    return found


def _by_reflections(matrix: Matrix, right: Sequence[float], dependent: float) -> tuple[list[float], int]:
    count = len(matrix[0]) if matrix else 0
    triangle, order, rank, wanted = _reflected(matrix, right, dependent)
    top = [row[:] for row in triangle[:rank]]
    # From the right: every row loses what stands beyond the rank, so that the unknowns there may be zero.
    reflections: list[tuple[int, list[float], float]] = []
    for k in reversed(range(rank)):
        tail = top[k][rank:]
        norm = math.hypot(top[k][k], *tail)
        if not any(tail):
            continue
        head = top[k][k] + math.copysign(norm, top[k][k])
        vector, half = [head, *tail], (head * head + sum(x * x for x in tail)) / 2
        for row in top[: k + 1]:
            share = (row[k] * head + sum(a * b for a, b in zip(row[rank:], tail, strict=True))) / half
            row[k] -= share * head
            row[rank:] = [a - share * b for a, b in zip(row[rank:], tail, strict=True)]
        reflections.append((k, vector, half))
    found = [*_back([row[:rank] for row in top], wanted[:rank]), *([0.0] * (count - rank))]
    for k, (head, *tail), half in reversed(reflections):
        share = (found[k] * head + sum(a * b for a, b in zip(found[rank:], tail, strict=True))) / half
        found[k] -= share * head
        found[rank:] = [a - share * b for a, b in zip(found[rank:], tail, strict=True)]
    result = [0.0] * count
    for k, j in enumerate(order):
        result[j] = found[k]
    return result, rank


def _reflected(
    matrix: Matrix, right: Sequence[float], dependent: float
) -> tuple[list[list[float]], list[int], int, list[float]]:
    """Upper triangle, the order of the columns, the rank, and the right side, turned by the same reflections."""
    columns = [list(c) for c in zip(*matrix, strict=True)]
    wanted, height = list(right), len(matrix)
    order = list(range(len(columns)))
    sizes = [math.hypot(*c) for c in columns]
    limit = dependent * max(sizes, default=0.0)
    rank = 0
    while rank < min(height, len(columns)):
        rests = [math.hypot(*columns[j][rank:]) for j in range(rank, len(columns))]
        best = max(range(len(rests)), key=rests.__getitem__)
        if rests[best] <= limit or rests[best] == 0.0:
            break
        best += rank
        columns[rank], columns[best] = columns[best], columns[rank]
        order[rank], order[best] = order[best], order[rank]
        lead = columns[rank]
        head = lead[rank] + math.copysign(rests[best - rank], lead[rank])
        vector = [head, *lead[rank + 1 :]]
        half = sum(x * x for x in vector) / 2
        for target in (*columns[rank:], wanted):
            share = sum(a * b for a, b in zip(vector, target[rank:], strict=True)) / half
            if share:
                target[rank:] = [b - share * a for a, b in zip(vector, target[rank:], strict=True)]
        rank += 1
    triangle = [[c[i] if i <= k or k >= rank else 0.0 for k, c in enumerate(columns)] for i in range(rank)]
    return triangle, order, rank, wanted


def _back(triangle: Matrix, right: Sequence[float]) -> list[float]:
    """The solution of an upper triangle."""
    found = [0.0] * len(right)
    for k in reversed(range(len(right))):
        rest = right[k] - sum(triangle[k][j] * found[j] for j in range(k + 1, len(right)))
        found[k] = rest / triangle[k][k]
    return found


def _by_singular_values(matrix: Matrix, right: Sequence[float], dependent: float) -> tuple[list[float], int]:
    import numpy as np

    found, _, rank, _ = np.linalg.lstsq(np.array(matrix), np.array(right), rcond=dependent)
    return [float(x) for x in found], int(rank)
