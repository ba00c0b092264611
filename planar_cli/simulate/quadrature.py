"""Integrals over time in numbers, piece by piece: Gauss's rule, refined where it differs most from its halves.

What is refined is decided over all pieces together, so that a piece which is nothing beside the others, or nothing but
rounding, is left as it is. Source: R. Piessens et al., QUADPACK (1983), the globally adaptive strategy.
"""

from __future__ import annotations

import heapq
from collections.abc import Callable, Iterable, Sequence
from math import fsum

from planar_cli.motion.trajectory.balance import NODES
from planar_cli.records import record

CLOSE = 1e-13
"""The rule may differ from its halves by this part of the whole integral without signs."""
MOST, EACH = 200, 30
"""At most so many intervals are halved, and so many more for each piece: a corner takes about 25."""

Function = Callable[[float], Sequence[float]]


@record
class Piece:
    """What is to be integrated over an interval in which it is smooth, but for a few corners."""

    of: Function
    """Numbers at a time."""
    a: float
    b: float


@record
class _Interval:
    """A part of a piece, with the rule over its halves."""

    piece: Piece
    left: tuple[float, ...]
    right: tuple[float, ...]
    off: float
    """By how much the rule over the whole differs."""

    @property
    def values(self) -> list[float]:
        """The integral."""
        return [x + y for x, y in zip(self.left, self.right, strict=True)]

    def halves(self) -> tuple[_Interval, _Interval]:
        """Its halves."""
        of, a, b = self.piece.of, self.piece.a, self.piece.b
        middle = 0.5 * (a + b)
        return _interval(Piece(of, a, middle), self.left), _interval(Piece(of, middle, b), self.right)


def integral(pieces: Iterable[Piece]) -> tuple[float, ...]:
    """∫ dt over all pieces; () if there are none."""
    found = [_interval(piece, _gauss(piece)) for piece in pieces]
    size = max((fsum(map(abs, column)) for column in zip(*(i.values for i in found), strict=True)), default=0.0)
    heap = [(-interval.off, number, interval) for number, interval in enumerate(found)]
    heapq.heapify(heap)
    off, number = fsum(i.off for i in found), len(found)
    most = number + MOST + EACH * number
    while off > CLOSE * size and number < most:
        _, _, worst = heapq.heappop(heap)
        off -= worst.off
        for half in worst.halves():
            number += 1
            off += half.off
            heapq.heappush(heap, (-half.off, number, half))
    return tuple(map(fsum, zip(*(interval.values for _, _, interval in heap), strict=True)))


def _interval(piece: Piece, whole: tuple[float, ...]) -> _Interval:
    middle = 0.5 * (piece.a + piece.b)
    left, right = _gauss(Piece(piece.of, piece.a, middle)), _gauss(Piece(piece.of, middle, piece.b))
    return _Interval(piece, left, right, max(abs(x - y - z) for x, y, z in zip(whole, left, right, strict=True)))


def _gauss(piece: Piece) -> tuple[float, ...]:
    half, middle = 0.5 * (piece.b - piece.a), 0.5 * (piece.a + piece.b)
    values = [[half * weight * v for v in piece.of(middle + half * x)] for x, weight in NODES]
    return tuple(map(fsum, zip(*values, strict=True)))
