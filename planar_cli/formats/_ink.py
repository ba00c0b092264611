"""Which pixels of a paper the strokes cover."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import accumulate

from planar_cli.formats._paper import Box, Spot

CLEAR = 1.0
"""So far words keep from a stroke, px."""


class Ink:
    """The pixels of some places, counted within any box at once: by sums over all that is above and to the left."""

    def __init__(self, spots: Iterable[Spot]) -> None:
        self.cells = {(int(x // 1), int(y // 1)) for x, y in spots}
        xs, ys = [x for x, _ in self.cells] or [0], [y for _, y in self.cells] or [0]
        self.left, self.top = min(xs), min(ys)
        self.wide, self.high = max(xs) - self.left + 1, max(ys) - self.top + 1
        rows = [bytearray(self.wide) for _ in range(self.high)]
        for x, y in self.cells:
            rows[y - self.top][x - self.left] = 1
        above = [0] * (self.wide + 1)
        self.sums = [above]
        for row in rows:
            above = [a + b for a, b in zip(above, accumulate(row, initial=0), strict=True)]
            self.sums.append(above)

    def has(self, spot: Spot) -> bool:
        """Is there a stroke?"""
        return (int(spot[0] // 1), int(spot[1] // 1)) in self.cells

    def within(self, box: Box) -> int:
        """How many pixels are in a box, or nearer to it than `CLEAR`."""
        near = box.grown(CLEAR)
        left, right = self._column(near.left), self._column(near.right + 1)
        top, bottom = self._row(near.top), self._row(near.bottom + 1)
        upper, lower = self.sums[top], self.sums[bottom]
        return lower[right] - lower[left] - upper[right] + upper[left]

    def _column(self, x: float) -> int:
        return max(0, min(self.wide, int(x // 1) - self.left))

    def _row(self, y: float) -> int:
        return max(0, min(self.high, int(y // 1) - self.top))
