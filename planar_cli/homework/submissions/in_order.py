"""Graded submissions in the order of their files: workers finish as they may, a lecturer reads a sorted list."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator

from planar_cli.homework.submissions.grader import Piece
from planar_cli.homework.tasks.results import Line


class InOrder:
    """Hands lines on in the order of the files that are expected, and of the rows in them. A line goes on as soon as
    all before it have come, so that only as much is held as the workers are apart.
    """

    def __init__(self, take: Callable[[Line], None]) -> None:
        self.take = take
        self._due: deque[Piece] = deque()
        self._held: dict[str, dict[int, deque[Line]]] = {}
        self._passed = 0
        """Of the first file, so many parts went on."""

    def expecting(self, pieces: Iterable[Piece]) -> Iterator[Piece]:
        """The same pieces, each expected from now on."""
        for piece in pieces:
            self._due.append(piece)
            yield piece

    def hear(self, line: Line) -> None:
        """A line that has come."""
        self._held.setdefault(line.file, {}).setdefault(line.part, deque()).append(line)
        while self._due and (first := self._of(self._due[0])) is not None:
            self._let_go(first)

    def close(self) -> None:
        """All that is held, where a run ends before the rest has come."""
        while self._due:
            piece = self._due.popleft()
            for part in sorted(self._held.get(piece.path, {})):
                for line in self._held[piece.path][part]:
                    self.take(line)
            self._held.pop(piece.path, None)
        self._passed = 0

    def _of(self, piece: Piece) -> Line | None:
        """The next line of a file, if it has come."""
        held = self._held.get(piece.path, {})
        any_line = next((lines[0] for lines in held.values() if lines), None)
        if any_line is None:
            return None
        known = piece.parts and piece.total == any_line.parts and piece.content == any_line.content
        part = piece.parts[self._passed] if known else self._passed
        lines = held.get(part)
        return lines[0] if lines else None

    def _let_go(self, line: Line) -> None:
        held, piece = self._held[line.file], self._due[0]
        held[line.part].popleft()
        if not held[line.part]:
            del held[line.part]
        if not held:
            del self._held[line.file]
        self._passed += 1
        known = piece.parts and piece.total == line.parts and piece.content == line.content
        if self._passed == (len(piece.parts) if known else line.parts):
            self._due.popleft()
            self._passed = 0
        self.take(line)
