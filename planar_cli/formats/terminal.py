"""A document as text of fixed width for a terminal or a pipe; colours only where they are wanted."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from io import StringIO
from typing import ClassVar, TextIO, final

from planar_cli.formats._layout import FIRM, Row, Span, fill, indent, row_cells, settled, side_spans, spans, words
from planar_cli.formats._terminals import PIPE_WIDTH, width_of
from planar_cli.formats.base import Format, runs
from planar_cli.plain_letters import in_plain, is_poor, letters
from planar_cli.records import record
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
    Line,
    Note,
    Paragraph,
    Result,
    Table,
    Text,
    Title,
    Typed,
)
from planar_cli.report.notation.names import plain_name, printable

_BODY = 2
_NUMBER = 4
_NOTE_COLUMN = 56
_GAP, _UNIT = 3, 16
"""What stands before an aside at least; an aside of no more columns is a unit, which stays beside its equation."""
_LABEL, _ROOM = 9, 12
_KINETIC, _BETWEEN = "   =   ", ",  "
# Left sides are aligned at their relation signs unless that tears a short one too far from its lead.
_LARGEST_SPREAD = 12
_LONGER_LEAD, _FIRST_LEAD, _WIDE_LEAD = 24, 16, 12
_COLOURS = {
    "title": "bold",
    "heading": "bold cyan",
    "label": "bold",
    "answer": "bold green",
    "strong": "bold",
    "muted": "dim",
}


@final
@record
class Terminal(Format[Row]):
    """Plain text with aligned equations, wrapped to the width of the terminal."""

    kind: ClassVar[str] = "terminal"
    suffix: ClassVar[str] = ".txt"

    width: int = PIPE_WIDTH
    colour: bool = False
    plain: bool = False
    """In ASCII alone?"""
    drawn: bool = False
    """With figures, in letters?"""

    @classmethod
    def on(cls, stream: TextIO) -> Terminal:
        """Fitted to a stream: its letters, and its width and colours if it is a terminal; else `width_of` a pipe."""
        plain = is_poor(stream)
        if not stream.isatty():
            return cls(width_of(stream), bool(os.environ.get("FORCE_COLOR")), plain)
        colour = not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
        return cls(width_of(stream), colour, plain)

    def render(self, document: Document) -> str:
        with in_plain(self.plain):
            return self._rendered(document)

    def _rendered(self, document: Document) -> str:
        rows: list[Row] = []
        before: Block | None = None
        for run in runs(document):
            if before is not None and _is_set_off(before, run[0]):
                rows.append(())
            rows += self.pieces(run)
            before = run[-1]
        return _coloured(rows) if self.colour else _joined(rows)

    def titles(self, run: Sequence[Title]) -> list[Row]:
        return [r for t in run for r in fill((), [Span(words(t.text), "title")], _BODY, self.width)]

    def headings(self, run: Sequence[Heading]) -> list[Row]:
        rows: list[Row] = []
        for heading in run:
            rows += [()] if rows else []
            text = "  ".join(words(t) for t in (heading.label, heading.text) if t)
            head = fill((), [Span(text, "heading")], _BODY, self.width)
            aside = (Text(heading.aside),) if isinstance(heading.aside, str) else heading.aside
            rows += self._with_aside(head, [s for s in spans(aside) if s.text], _BODY)
        return rows

    def paragraphs(self, run: Sequence[Paragraph]) -> list[Row]:
        return [r for p in run for r in fill(indent(_BODY), spans(p.line), _BODY, self.width)]

    def bullets(self, run: Sequence[Bullet]) -> list[Row]:
        return [r for b in run for r in self._marked(letters("•"), b.line, _BODY)]

    def results(self, run: Sequence[Result]) -> list[Row]:
        return [r for b in run for r in self._marked(letters("⇒"), b.line, _NUMBER)]

    def _marked(self, mark: str, line: Line, column: int) -> list[Row]:
        head = [*indent(column), Span(mark + " ")]
        return fill(head, spans(line), row_cells(head), self.width)

    def equations(self, run: Sequence[Equation]) -> list[Row]:
        found: list[Row] = []
        for part in _alike(run):
            found += self._aligned(part)
        return found

    def _aligned(self, part: Sequence[Equation]) -> list[Row]:
        """Equations under each other, their signs too unless that makes them longer; those before the first with a
        number or a lead stand apart from it where its lead is a formula, or where the room for that would do so, and
        where it would so do those behind the last number.
        """
        columns = _Columns.of(part, self.width)
        rows = [row for equation in part for row in self._equation(equation, columns)]
        if columns.left and len(rows) > len(part):
            loose = [row for equation in part for row in self._equation(equation, replace(columns, left=0))]
            rows = loose if len(loose) < len(rows) else rows
        own = [i for i, e in enumerate(part) if e.lead or e.number is not None] or [0]
        led, last = own[0], own[-1] + 1
        if last < len(part) < len(rows) and part[last - 1].number is not None:
            apart = [*self._aligned(part[:last]), *self._aligned(part[last:])]
            return rows if len(apart) >= len(rows) else apart
        wide = part[led].number is not None and row_cells(spans(part[led].lead)) >= _WIDE_LEAD
        if not led or (len(rows) == len(part) and not wide):
            return rows
        apart = [*self._aligned(part[:led]), *self._aligned(part[led:])]
        return rows if len(apart) > len(rows) else apart

    def _equation(self, equation: Equation, columns: _Columns) -> list[Row]:
        head = columns.head(equation)
        left, *others = [side_spans(s) for s in equation.sides]
        head += indent(columns.left - row_cells(left)) if others else []
        sign = row_cells(head) + row_cells(left) + 1
        room = self.width - sign
        short = room >= _ROOM and all(row_cells(s) + 2 <= room for s in others)
        below = others and (sign <= self.width // 2 or short)
        hang = sign if below else min(columns.start + _BODY, self.width // 2)
        whole = row_cells(head) + row_cells(left) + sum(row_cells(side) + 3 for side in others)
        if row_cells(head) > self.width // 2 and whole > self.width:
            rows, hang = [settled(head)], columns.start + 2 * _BODY
            head = indent(hang)
        else:
            rows = []
        content = list(left)
        for place, side in enumerate(others):
            content += [Span(" "), Span((words(equation.relation) if place == 0 else "=") + FIRM, "math"), *side]
        aside = spans(equation.note)
        filled = fill(head, content, hang, self.width)
        room = self.width - row_cells(aside) - _GAP
        if 0 < row_cells(aside) <= _UNIT and row_cells(filled[-1]) > room:
            narrow = room < hang + _ROOM
            filled = fill(head, content, min(columns.start + _BODY, self.width // 2) if narrow else hang, room)
        return self._with_aside([*rows, *filled], aside, columns.start + _BODY)

    def _with_aside(self, rows: list[Row], aside: list[Span], hang: int) -> list[Row]:
        """An aside at the right of the last row, or below where there is no room."""
        if not aside:
            return rows
        size, used = row_cells(aside), row_cells(rows[-1])
        column = max(min(_NOTE_COLUMN, self.width - size), used + _GAP)
        shown = [Span(s.text, "muted" if s.style == "plain" else s.style) for s in aside]
        if column + size <= self.width:
            return [*rows[:-1], (*rows[-1], *indent(column - used), *settled(shown))]
        return [*rows, *fill(indent(hang), shown, hang, self.width)]

    def forces(self, run: Sequence[Forces]) -> list[Row]:
        names = [words(f.body) + ":" for f in run]
        column = _BODY + max(row_cells([Span(n)]) for n in names) + 2
        column = column if column <= self.width // 2 else _NUMBER
        rows: list[Row] = []
        for name, block in zip(names, run, strict=True):
            head = [*indent(_BODY), Span(name, "strong")]
            rest = column - row_cells(head)
            rows += self._diagram([*head, *indent(max(rest, 1))], block, column)
        return rows

    def _diagram(self, head: list[Span], block: Forces, column: int) -> list[Row]:
        """With less room between its forces where that spares a row."""
        wide, narrow = (self._drawn(head, block, column, gap) for gap in (_BETWEEN, _BETWEEN[:-1]))
        return narrow if len(narrow) < len(wide) else wide

    def _drawn(self, head: list[Span], block: Forces, column: int, gap: str) -> list[Row]:
        sides = (spans(block.left), spans(block.right))
        left, right = ([replace(s, text=gap) if s.text == _BETWEEN else s for s in side] for side in sides)
        rows = fill(head, left, column, self.width)
        if not block.right:
            return rows
        if row_cells(rows[-1]) + row_cells(right) + len(_KINETIC) <= self.width:
            return [*rows[:-1], *fill([*rows[-1], Span(_KINETIC)], right, column, self.width)]
        head = [*indent(column - 2 if column > _NUMBER else column), Span("= ")]
        return [*rows, *fill(head, right, column, self.width)]

    def tables(self, run: Sequence[Table]) -> list[Row]:
        rows: list[Row] = []
        for table in run:
            rows += [()] if rows else []
            rows += self._table(table)
        return rows

    def _table(self, table: Table) -> list[Row]:
        grid = [[settled(spans(c)) for c in row] for row in (table.header, *table.rows)]
        sizes = [max(row_cells(c) for c in column) for column in zip(*grid, strict=True)]
        if _BODY + sum(sizes) + _GAP * (len(sizes) - 1) > self.width:
            return self._stacked(table)
        rule = [*indent(_BODY), Span("   ".join(letters("─") * s for s in sizes), "muted")]
        rows = [tuple(indent(_BODY)) + _padded(cells_of, sizes) for cells_of in grid]
        return [rows[0], tuple(rule), *rows[1:]]

    def _stacked(self, table: Table) -> list[Row]:
        """A table that is too wide, one cell below the other."""
        rows: list[Row] = []
        for cells_of in table.rows:
            rows += [()] if rows else []
            for title, cell in zip(table.header, cells_of, strict=True):
                content = [*spans(title), Span(": "), *spans(cell)]
                rows += fill(indent(_BODY), content, _NUMBER, self.width)
        return rows

    def answers(self, run: Sequence[Answer]) -> list[Row]:
        return self._labelled("Answer", [_answer(a) for a in run])

    def checks(self, run: Sequence[Check]) -> list[Row]:
        joined: list[Span] = []
        for check in run:
            joined += [Span("; " if self.plain else " · "), *spans(check.line)] if joined else spans(check.line)
        return self._labelled("Check", [joined])

    def notes(self, run: Sequence[Note]) -> list[Row]:
        return self._labelled(words(run[0].kind), [spans(n.line) for n in run])

    def drawings(self, run: Sequence[Drawing]) -> list[Row]:
        """Only where they are wanted: the lists of forces say the same."""
        if not self.drawn:
            return []
        from planar_cli.formats._drawn_small import small_drawing

        lines = [row for d in run for row in ("", *small_drawing(d.figure, self.width))]
        return [*((Span(row),) for row in lines), ()]

    def typed(self, run: Sequence[Typed]) -> list[Row]:
        return [(*indent(_BODY), Span(words(row))) for t in run for row in t.rows]

    def _labelled(self, label: str, lines: list[list[Span]]) -> list[Row]:
        # One gap less is wide enough behind a longer label: what is told begins in one column on the whole page.
        head = [Span(label.ljust(_LABEL + _GAP - 1) + " ", "label")]
        hang = row_cells(head)
        if hang > self.width // 2:
            hang = _BODY
            rows = [settled([Span(label, "label")])]
        else:
            rows = []
        for line in lines:
            rows += fill(indent(hang) if rows else head, line, hang, self.width)
        return rows


def _alike(run: Sequence[Equation]) -> list[list[Equation]]:
    """Equations that are aligned together: none beside one with a much longer lead, which would tear them apart, and no
    words beside numbers of equations; what has no lead goes on with the one before it.
    """
    parts: list[list[Equation]] = []
    sizes = [row_cells(spans(e.lead)) for e in run]
    for i, equation in enumerate(run):
        apart = abs(sizes[i] - sizes[i - 1]) > (_LONGER_LEAD if sizes[i - 1] else _FIRST_LEAD) and sizes[i] > 0
        apart |= i > 0 and _is_headed(equation) and not all(map(_is_headed, parts[-1]))
        if i and not apart:
            parts[-1].append(equation)
        else:
            parts.append([equation])
    return parts


def _is_headed(equation: Equation) -> bool:
    """Does it begin with words, At 2:?"""
    first = equation.lead[0] if equation.lead and equation.number is None else None
    return isinstance(first, Text) and first.text[:1].isupper()


@record
class _Columns:
    """Where a run of equations is aligned: column of the numbers and leads, widths of number, lead and left side."""

    start: int
    number: int
    lead: int
    left: int

    @classmethod
    def of(cls, run: Sequence[Equation], width: int) -> _Columns:
        number = max((len(_number(e)) for e in run), default=0)
        leads = [row_cells(spans(e.lead)) for e in run]
        lefts = [row_cells(side_spans(e.sides[0])) for e in run if len(e.sides) > 1]
        start = _NUMBER if number or not max(leads, default=0) else _BODY
        lead = max(leads) if start + number + max(leads) < width // 2 else 0
        spread = max(lefts, default=0) - min(lefts, default=0)
        aligned = spread <= _LARGEST_SPREAD and start + number + lead + _GAP + max(lefts, default=0) < width // 2
        return cls(start, number, lead, max(lefts, default=0) if aligned else 0)

    def head(self, equation: Equation) -> list[Span]:
        """Number and lead of an equation, padded."""
        head = indent(self.start)
        if self.number:
            head += [Span(_number(equation).rjust(self.number) + "  ")]
        lead = spans(equation.lead)
        if self.lead or lead:
            head += [*lead, *indent(max(self.lead - row_cells(lead), 0) + _GAP)]
        return head


def _answer(answer: Answer) -> list[Span]:
    relation = ":" + FIRM if answer.relation == ":" else f"{FIRM}{words(answer.relation)}{FIRM}"
    content = [Span(letters(plain_name(words(answer.name))) + relation, "math"), *spans(answer.line)]
    return [Span(s.text, "answer" if s.style == "math" else s.style) for s in content]


def _number(equation: Equation) -> str:
    return f"({equation.number})" if equation.number is not None else ""


def _padded(cells_of: list[Row], sizes: list[int]) -> Row:
    padded: list[Span] = []
    for cell, size in zip(cells_of, sizes, strict=True):
        padded += [*cell, *indent(size - row_cells(cell) + _GAP)]
    return tuple(padded)


def _group(block: Block) -> str:
    """Blocks that stand together without a blank row between them."""
    match block:
        case Title() | Answer() | Table():
            return type(block).__name__
        case Check() | Note():
            return "foot"
    return "body"


def _is_set_off(before: Block, block: Block) -> bool:
    if isinstance(before, Answer) and isinstance(block, Check):
        # What was checked belongs to the answers above it.
        return False
    return isinstance(block, Heading) or _group(before) != _group(block)


def _joined(rows: list[Row]) -> str:
    return "".join(printable("".join(s.text for s in row).rstrip()) + "\n" for row in rows)


def _coloured(rows: list[Row]) -> str:
    """The rows with colours, by rich; texts are handed over as texts, never as markup."""
    from rich.console import Console
    from rich.text import Text as Styled

    stream = StringIO()
    console = Console(
        file=stream, force_terminal=True, color_system="standard", markup=False, highlight=False, emoji=False
    )
    for row in rows:
        styled = Styled()
        for span in row:
            styled.append(printable(span.text), _COLOURS.get(span.style))
        styled.rstrip()
        console.print(styled, soft_wrap=True)
    return stream.getvalue()
