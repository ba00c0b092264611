"""The contract of a format: a document of neutral blocks in, text out.

A format is a class with a `kind` (its name on the command line), a `suffix` (of its files) and one method for every
kind of block. A test holds that the dispatch here knows every block of `report/document/blocks.py`; a method that is
added to `Pieces` makes every format fail type checking until each can print the block.

Words of a block may come from a file; a format must neutralise whatever its output would take for a command.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from itertools import groupby
from typing import ClassVar, Protocol, Self, TextIO, TypeAlias, TypeVar

from planar_cli.report.document.blocks import (
    Answer,
    Block,
    Bullet,
    Check,
    Document,
    Drawing,
    Equation,
    Forces,
    Heading,
    Note,
    Paragraph,
    Result,
    Table,
    Title,
    Typed,
)

Piece = TypeVar("Piece")
B = TypeVar("B", bound=Block)
Way: TypeAlias = Callable[[Sequence[Block]], list[Piece]]


class Pieces(Protocol[Piece]):
    """The pieces of a run, for every kind of block; a run of notes is of one kind of note."""

    def titles(self, run: Sequence[Title]) -> list[Piece]: ...
    def headings(self, run: Sequence[Heading]) -> list[Piece]: ...
    def paragraphs(self, run: Sequence[Paragraph]) -> list[Piece]: ...
    def bullets(self, run: Sequence[Bullet]) -> list[Piece]: ...
    def equations(self, run: Sequence[Equation]) -> list[Piece]: ...
    def results(self, run: Sequence[Result]) -> list[Piece]: ...
    def forces(self, run: Sequence[Forces]) -> list[Piece]: ...
    def tables(self, run: Sequence[Table]) -> list[Piece]: ...
    def answers(self, run: Sequence[Answer]) -> list[Piece]: ...
    def checks(self, run: Sequence[Check]) -> list[Piece]: ...
    def notes(self, run: Sequence[Note]) -> list[Piece]: ...
    def drawings(self, run: Sequence[Drawing]) -> list[Piece]: ...
    def typed(self, run: Sequence[Typed]) -> list[Piece]: ...


class Format(Pieces[Piece], ABC):
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

    def pieces(self, run: Sequence[Block]) -> list[Piece]:
        """The pieces of a run, by the method of its blocks."""
        made = dict(
            (
                _way(Title, self.titles),
                _way(Heading, self.headings),
                _way(Paragraph, self.paragraphs),
                _way(Bullet, self.bullets),
                _way(Equation, self.equations),
                _way(Result, self.results),
                _way(Forces, self.forces),
                _way(Table, self.tables),
                _way(Answer, self.answers),
                _way(Check, self.checks),
                _way(Note, self.notes),
                _way(Drawing, self.drawings),
                _way(Typed, self.typed),
            )
        )
        return made[type(run[0])](run)


class Pages(Format[str]):
    """A format whose pages can be put together of parts, each made by itself, perhaps by another process.

    `below`: so many levels its titles and headings stand below those of a page of their own; a field of each member.
    """

    below: int

    @abstractmethod
    def part(self, blocks: Sequence[Block]) -> str:
        """Blocks in print; "" of none."""

    @abstractmethod
    def whole(self, title: str, parts: Sequence[str]) -> str:
        """Parts as one page, which ends with one line feed. `title`: of the file; that over the page is in a part."""

    def render(self, document: Document) -> str:
        return self.whole(document.title, [self.part((Title(document.title), *document.blocks))])


def runs(document: Document) -> list[tuple[Block, ...]]:
    """The title and the blocks of a document, neighbours of one kind together."""
    return runs_of((Title(document.title), *document.blocks))


def runs_of(blocks: Sequence[Block]) -> list[tuple[Block, ...]]:
    """Blocks, neighbours of one kind together."""
    return [tuple(run) for _, run in groupby(blocks, key=_kind_of)]


def in_one(documents: Sequence[Document]) -> Document:
    """Several documents as one, each under its own title."""
    first, *others = documents
    return Document(first.title, (*first.blocks, *(b for d in others for b in (Title(d.title), *d.blocks))))


def _kind_of(block: Block) -> tuple[type[Block], str]:
    return type(block), block.kind if isinstance(block, Note) else ""


def _way(kind: type[B], method: Callable[[Sequence[B]], list[Piece]]) -> tuple[type, Way[Piece]]:
    """What makes the pieces of a run of such blocks."""
    return kind, lambda run: method([b for b in run if isinstance(b, kind)])
