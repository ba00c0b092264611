"""A drawing in letters: strokes as the dots of Braille cells, two beside and four above each other, and words on them.

Where a terminal has ASCII alone, `letters` makes of every cell the sign that looks most like it.
"""

from __future__ import annotations

from planar_cli.plain_letters import BRAILLE, LEFT, RIGHT, letters

ACROSS, DOWN = 2, 4
"""Dots of a cell."""
Place = tuple[float, float]


class Canvas:
    """So many columns and rows of letters."""

    def __init__(self, columns: int, rows: int) -> None:
        self.columns, self.rows = columns, rows
        self.dots: dict[tuple[int, int], int] = {}
        self.words: dict[tuple[int, int], str] = {}

    def stroke(self, start: Place, end: Place) -> None:
        """A line; places in dots, from the left and from above."""
        (x0, y0), (x1, y1) = start, end
        steps = max(1, round(max(abs(x1 - x0), abs(y1 - y0))))
        for k in range(steps + 1):
            self.dot((x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps))

    def dot(self, at: Place) -> None:
        """A dot; none outside."""
        x, y = round(at[0]), round(at[1])
        cell = (x // ACROSS, y // DOWN)
        if 0 <= cell[0] < self.columns and 0 <= cell[1] < self.rows:
            side = RIGHT if x % ACROSS else LEFT
            self.dots[cell] = self.dots.get(cell, 0) | 1 << side[y % DOWN]

    def put(self, column: int, row: int, text: str) -> None:
        """Words over whatever is there."""
        for k, letter in enumerate(letters(text)):
            if 0 <= column + k < self.columns and 0 <= row < self.rows:
                self.words[column + k, row] = letter

    def is_free(self, column: int, row: int, length: int) -> bool:
        """Is there nothing yet, and all of it inside?"""
        inside = 0 <= row < self.rows and column >= 0 and column + length <= self.columns
        cells = [(column + k, row) for k in range(length)]
        return inside and not any(c in self.dots or c in self.words for c in cells)

    def lines(self) -> list[str]:
        """The rows, without spaces at their ends."""
        return [
            "".join(self._cell((column, row)) for column in range(self.columns)).rstrip() for row in range(self.rows)
        ]

    def _cell(self, cell: tuple[int, int]) -> str:
        if cell in self.words:
            return self.words[cell]
        return letters(chr(BRAILLE + self.dots[cell])) if cell in self.dots else " "
