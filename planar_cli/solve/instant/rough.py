"""A first look at a linear system in machine floats: sure, or left to sixty digits.

A search asks of thousands of sets of equations whether they determine something. Nearly all of them answer clearly in
floats; where a pivot is neither clearly zero nor clearly not, the answer is None and the caller asks in Decimals. What
a search finds is checked in Decimals in any case.
"""

from __future__ import annotations

from collections.abc import Iterable

NOTHING, SURE = 1e-11, 1e-6
FloatRow = list[float]


def fixes(rows: Iterable[FloatRow], width: int, targets: list[int]) -> bool | None:
    """Do the rows (without constants, of size one) fix the target columns?"""
    pivots = _echelon(rows, width)
    if pivots is None:
        return None
    if len(pivots) == width:
        return True
    leading = {column for column, _ in pivots}
    if any(t not in leading for t in targets):
        # A column that leads no row may have any value.
        return False
    return _follow(pivots, leading, targets)


def _echelon(rows: Iterable[FloatRow], width: int) -> list[tuple[int, FloatRow]] | None:
    """Rows with their leading columns, each free of the columns that lead before it."""
    pivots: list[tuple[int, FloatRow]] = []
    for row in rows:
        work = row
        for column, pivot in pivots:
            factor = work[column]
            if factor:
                work = [a - factor * b for a, b in zip(work, pivot, strict=True)]
                work[column] = 0.0
        size, best = max((abs(c), j) for j, c in enumerate(work))
        if size < NOTHING:
            continue
        if size < SURE:
            return None
        lead = work[best]
        pivots.append((best, [a / lead if abs(a) > NOTHING else 0.0 for a in work]))
        if len(pivots) == width:
            break
    return pivots


def _follow(pivots: list[tuple[int, FloatRow]], leading: set[int], targets: list[int]) -> bool | None:
    """Are the targets free of all columns that lead nothing?"""
    free = [j for j in range(len(pivots[0][1])) if j not in leading]
    loose: dict[int, FloatRow] = {}
    for column, row in reversed(pivots):
        slopes = [row[j] for j in free]
        for other, known in loose.items():
            factor = row[other]
            if factor:
                slopes = [s - factor * k for s, k in zip(slopes, known, strict=True)]
        loose[column] = slopes
    largest = max((abs(s) for t in targets for s in loose[t]), default=0.0)
    if NOTHING * 100 < largest < SURE:
        return None
    return largest < SURE
