"""The contract of a format: a document of neutral blocks in, text out.

A format is a class with a `kind` (its name on the command line), a `suffix` (of its files) and one method for every
kind of block. The dispatch here is exhaustive: a block that is added to `report/blocks.py` makes it fail type checking,
and the new abstract method makes every format fail until each can print the block.

Words of a block may come from a file; a format must neutralise whatever its output would take for a command.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import ClassVar, Generic, Self, TextIO, TypeVar, assert_never

from planar_cli.report.blocks import (
    Answer,
    Block,
    Bullet,
    Check,
    Document,
    Equation,
    Forces,
    Heading,
    Note,
    Paragraph,
    Result,
    Table,
    Title,
)

Piece = TypeVar("Piece")
B = TypeVar("B")


class Format(ABC, Generic[Piece]):
    """One output format.

    Neighbouring blocks of one kind come together, as a run, so that they can be aligned or share a label. A method
    gives the pieces (rows, paragraphs) of its run; `render` joins them.
    """

    kind: ClassVar[str]
    suffix: ClassVar[str]

    @classmethod
    def on(cls, stream: TextIO) -> Self:
        """Fitted to the stream that the text goes to; most formats are the same everywhere."""
        return cls()

    @abstractmethod
    def render(self, document: Document) -> str:
        """The whole document as text that ends with one line feed."""

    @abstractmethod
    def titles(self, run: Sequence[Title]) -> list[Piece]: ...

    @abstractmethod
    def headings(self, run: Sequence[Heading]) -> list[Piece]: ...

    @abstractmethod
    def paragraphs(self, run: Sequence[Paragraph]) -> list[Piece]: ...

    @abstractmethod
    def bullets(self, run: Sequence[Bullet]) -> list[Piece]: ...

    @abstractmethod
    def equations(self, run: Sequence[Equation]) -> list[Piece]: ...

    @abstractmethod
    def results(self, run: Sequence[Result]) -> list[Piece]: ...

    @abstractmethod
    def forces(self, run: Sequence[Forces]) -> list[Piece]: ...

    @abstractmethod
    def tables(self, run: Sequence[Table]) -> list[Piece]: ...

    @abstractmethod
    def answers(self, run: Sequence[Answer]) -> list[Piece]: ...

    @abstractmethod
    def checks(self, run: Sequence[Check]) -> list[Piece]: ...

    @abstractmethod
    def notes(self, run: Sequence[Note]) -> list[Piece]:
        """Notes of one kind."""

    def pieces(self, run: Sequence[Block]) -> list[Piece]:
        """The pieces of a run, by the method of its blocks."""
        first = run[0]
        if isinstance(first, Forces | Table | Answer | Check | Note):
            return self._findings(first, run)
        match first:
            case Title():
                return self.titles(_all(Title, run))
            case Heading():
                return self.headings(_all(Heading, run))
            case Paragraph():
                return self.paragraphs(_all(Paragraph, run))
            case Bullet():
                return self.bullets(_all(Bullet, run))
            case Equation():
                return self.equations(_all(Equation, run))
            case Result():
                return self.results(_all(Result, run))
            case unknown:
                assert_never(unknown)

    def _findings(self, first: Forces | Table | Answer | Check | Note, run: Sequence[Block]) -> list[Piece]:
        match first:
            case Forces():
                return self.forces(_all(Forces, run))
            case Table():
                return self.tables(_all(Table, run))
            case Answer():
                return self.answers(_all(Answer, run))
            case Check():
                return self.checks(_all(Check, run))
            case Note():
                return self.notes(_all(Note, run))
            case unknown:
                assert_never(unknown)


def runs(document: Document) -> list[tuple[Block, ...]]:
    """The title and the blocks of a document, neighbours of one kind together."""
    blocks = (Title(document.title), *document.blocks)
    return [tuple(run) for _, run in groupby(blocks, key=_kind_of)]


def _kind_of(block: Block) -> tuple[type[Block], str]:
    return type(block), block.kind if isinstance(block, Note) else ""


def _all(wanted: type[B], run: Iterable[object]) -> list[B]:
    return [b for b in run if isinstance(b, wanted)]
