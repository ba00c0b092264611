"""Curves that are cut off where a quantity grows without bound, as a force near the change point of a linkage: drawn to
their peaks they would leave nothing to be read of the rest.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import pairwise
from statistics import median

from planar_cli.figures.over_time import Plotted
from planar_cli.report.document.graphs import Spot

MOST, OUTSIDE = 0.75, 3.0
"""Of all values this part lies within a distance from the middle one, and the graph goes so many times as far."""
PEAKED = 2.0
"""What goes no more than so many times beyond that is drawn as it is."""


def cut_off(quantity: Plotted) -> Plotted:
    """The quantity without its peaks; as it is where it has none."""
    values = [y for pieces in quantity.pieces for piece in pieces for _, y in piece]
    if not values:
        return quantity
    middle = median(values)
    away = sorted(abs(y - middle) for y in values)
    far = OUTSIDE * away[int(MOST * (len(away) - 1))]
    if not far or away[-1] <= PEAKED * far:
        return quantity
    low, high = middle - far, middle + far
    pieces = tuple(tuple(p for piece in own for p in _within(piece, low, high)) for own in quantity.pieces)
    return replace(quantity, pieces=pieces, cut=True)


def _within(piece: Iterable[Spot], low: float, high: float) -> Iterator[tuple[Spot, ...]]:
    """The parts of a piece between two values, each to where it leaves them."""
    found: list[Spot] = []
    spots = list(piece)
    if spots and low <= spots[0][1] <= high:
        found.append(spots[0])
    for one, other in pairwise(spots):
        found += sorted(_crossings(one, other, low, high))
        if low <= other[1] <= high:
            found.append(other)
        elif found:
            yield tuple(found)
            found = []
    if found:
        yield tuple(found)


def _crossings(one: Spot, other: Spot, low: float, high: float) -> Iterator[Spot]:
    """Where a straight part enters or leaves."""
    for edge in (low, high):
        if (one[1] - edge) * (other[1] - edge) < 0:
            share = (edge - one[1]) / (other[1] - one[1])
            yield one[0] + share * (other[0] - one[0]), edge
