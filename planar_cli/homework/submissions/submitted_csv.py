"""Submissions from a CSV file, line by line: a bad line costs whom it belongs to, and nobody else.

    problem,find,answer[,unit]                              one student's, named by the file
    student,problem,find,answer[,unit][,variant]            a class's, a line for each answer
    student[,variant],incline.a,incline.N,…                 a class's, a line for each student

Cells are separated by commas, semicolons or tabs, whichever the first line has most of.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator, Mapping

from planar_cli.errors import Mark
from planar_cli.homework.sets.paper import Submission
from planar_cli.homework.submissions.submitted import MOST_TOLD, Handed, student_of_file, with_unit
from planar_cli.problem.nodes.show import lines_of, visible
from planar_cli.records import record

MOST_COLUMNS = 1000
MOST_LINES = 200_000
LONGEST_CELL = 10_000
LONGEST_LINE = 100_000
LONG = {"problem", "find", "answer"}
KNOWN = {*LONG, "unit", "student", "variant"}
FORMULA_GUARDS = ("'=", "'+", "'-", "'@")
"""What spreadsheets are handed so that they take no text for a formula."""
DELIMITERS = {",": "a comma", ";": "a semicolon", "\t": "a tab"}
HEADS = "the first line is `problem,find,answer`, `student,problem,find,answer` or `student,problem.find,…`"
QUOTES = 'a quote is not closed, or text follows it; within quotes a quote is written ""'


@record
class _Row:
    """The cells of one line by the names of their columns, and why they are not to be used."""

    line: int
    cells: Mapping[str, str]
    wrong: str = ""


class _Table:
    """The lines of a file under its first one."""

    def __init__(self, text: str, path: str) -> None:
        self.path = path
        self.lines = lines_of(text)
        self.first = next((i for i, line in enumerate(self.lines) if line.strip()), 0)
        self.delimiter = ""
        if self.lines[self.first].lower().startswith("sep=") and len(self.lines) > self.first + 1:
            self.delimiter = next((d for d in DELIMITERS if self.lines[self.first][4:5] == d), "")
            self.first += 1
        head = self.lines[self.first]
        self.delimiter = self.delimiter or max(DELIMITERS, key=head.count)
        cells = _cells(head, self.delimiter) if len(head) <= LONGEST_LINE else None
        self.head = [name.strip() for name in cells or []]
        low = [name.lower() for name in self.head]
        self.head = [small if small in KNOWN else name for name, small in zip(self.head, low, strict=True)]

    def place(self, line: int, column: int = 1) -> Mark:
        return Mark(self.path, line, column)

    def at_head(self) -> Mark:
        return self.place(self.first + 1)

    def fault(self) -> str:
        """Why nothing of it can be read."""
        named = [name for name in self.head if name]
        twice = next((name for name in named if named.count(name) > 1), None) if len(named) <= MOST_COLUMNS else None
        if not any(line.strip() for line in self.lines):
            return f"the file is empty; {HEADS}"
        if len(self.head) > MOST_COLUMNS or len(self.lines[self.first]) > LONGEST_LINE:
            return f"a table has at most {MOST_COLUMNS} columns"
        if twice is not None:
            return f"there are two columns `{twice[:60]}`"
        wide = "student" in named and any("." in name for name in named)
        return "" if set(named) >= LONG or wide else f"the columns are not known; {HEADS}"

    def rows(self) -> Iterator[_Row]:
        for number, line in enumerate(self.lines[self.first + 1 :], self.first + 2):
            if line.strip():
                yield self._row(number, line)

    def _row(self, number: int, line: str) -> _Row:
        if len(line) > LONGEST_LINE:
            return _Row(number, self._loosely(line[:LONGEST_LINE]), f"a line has at most {LONGEST_LINE} characters")
        cells = _cells(line, self.delimiter)
        if cells is None:
            return _Row(number, self._loosely(line), QUOTES)
        if len(cells) > len(self.head):
            cells = _with_brackets_closed(cells, self.delimiter)
        named = {name: _plain(cell) for name, cell in zip(self.head, cells, strict=False) if name}
        if any(cell.strip() for cell in cells[len(self.head) :]):
            sign = DELIMITERS[self.delimiter]
            told = f"the line has {len(cells)} cells, the first one {len(self.head)}: put what has {sign} in quotes"
            return _Row(number, named, told)
        return _Row(number, named)

    def _loosely(self, line: str) -> dict[str, str]:
        """Whose a line is that cannot be read."""
        cells = line.split(self.delimiter, len(self.head))
        return {name: _plain(cell).strip('"') for name, cell in zip(self.head, cells, strict=False) if name}

    def column(self, row: _Row, name: str) -> int:
        """Where the cell of a column begins in its line."""
        index, quoted = self.head.index(name), False
        for place, character in enumerate(self.lines[row.line - 1], 1):
            if index == 0:
                return place
            quoted = quoted != (character == '"')
            index -= character == self.delimiter and not quoted
        return 1


def from_csv(text: str, path: str) -> tuple[Submission, ...]:
    """The submissions of a file in the order in which their students appear; at least one."""
    table = _Table(text, path)
    fault = table.fault()
    alone = Handed(student_of_file(path), path)
    if fault:
        alone.complain(table.at_head(), fault)
        return (alone.submission(),)
    known = KNOWN if set(table.head) >= LONG else {"student", "variant"}
    unread = [n for n in table.head if n and n not in known and (known is KNOWN or "." not in n)]
    told = [f"the column `{name[:60]}` is not read" for name in unread[:MOST_TOLD]]
    if "student" in table.head:
        return tuple(handed.submission() for handed in _of_class(table, known is KNOWN, told))
    for message in told:
        alone.complain(table.at_head(), message)
    for row in table.rows():
        if row.line > MOST_LINES:
            alone.complain(table.place(row.line), f"a table has at most {MOST_LINES} lines")
            break
        _enter_long(alone, row, table, "variant" in table.head)
    return (alone.submission(),)


def _of_class(table: _Table, long: bool, told: list[str]) -> Iterator[Handed]:
    """In a long table all lines of one student and variant are one submission, in a wide one each line."""
    gathered: dict[tuple[str, str], Handed] = {}
    for row in table.rows():
        if row.line > MOST_LINES:
            lost = Handed("", table.path)
            lost.complain(table.place(row.line), f"a table has at most {MOST_LINES} lines")
            gathered["", str(row.line)] = lost
            break
        name = row.cells.get("student", "").strip()
        key = (name, row.cells.get("variant", "").strip() if long else str(row.line))
        if key not in gathered:
            gathered[key] = Handed("", table.path)
            gathered[key].name(name, table.place(row.line))
            _begin(gathered[key], row, table, told if long else [])
        handed = gathered[key]
        if long:
            _enter_long(handed, row, table, False)
        else:
            _enter_wide(handed, row, table)
    if not gathered:
        empty = Handed(student_of_file(table.path), table.path)
        empty.complain(table.at_head(), "there is no line below the first")
        gathered["", ""] = empty
    yield from gathered.values()


def _begin(handed: Handed, row: _Row, table: _Table, told: list[str]) -> None:
    """What the first line of a student says of all."""
    variant = row.cells.get("variant", "").strip()
    if not handed.student:
        handed.complain(table.place(row.line), "the line names no student")
    if variant:
        handed.vary(variant, table.place(row.line, table.column(row, "variant")))
    for message in told:
        handed.complain(table.at_head(), message)


def _enter_long(handed: Handed, row: _Row, table: _Table, varies: bool) -> None:
    """A line with one answer. `varies`: a student's own file says the variant in its lines."""
    if row.wrong:
        handed.complain(table.place(row.line), row.wrong)
        return
    cells = row.cells
    variant = cells.get("variant", "").strip() if varies else ""
    if variant and variant != str(handed.variant):
        if handed.answers:
            handed.usable = False
            handed.complain(table.place(row.line, table.column(row, "variant")), "the variant differs from that above")
        handed.vary(variant, table.place(row.line, table.column(row, "variant")))
    answer, unit = cells.get("answer", "").strip(), cells.get("unit", "").strip()
    place = (cells.get("problem", "").strip(), cells.get("find", "").strip())
    if answer and not all(place):
        handed.complain(table.place(row.line), "the line does not say what it answers")
    elif answer:
        _enter(handed, place, with_unit(answer, unit), table, (row, "answer"))


def _enter_wide(handed: Handed, row: _Row, table: _Table) -> None:
    if row.wrong:
        handed.complain(table.place(row.line), row.wrong)
        return
    for name, answer in row.cells.items():
        problem, dot, find = name.partition(".")
        if dot and answer.strip():
            _enter(handed, (problem, find), answer, table, (row, name))


def _enter(handed: Handed, place: tuple[str, str], text: str, table: _Table, cell: tuple[_Row, str]) -> None:
    row, name = cell
    if text.isprintable() and len(text) <= LONGEST_CELL and all(part.isprintable() for part in place):
        # Its column is sought only where it is told.
        handed.answer(*place, text, table.place(row.line))
        return
    why = f"is longer than {LONGEST_CELL} characters" if len(text) > LONGEST_CELL else "has a hidden character"
    mark = table.place(row.line, table.column(row, name))
    handed.complain(mark, f"the answer to `{visible('.'.join(place)[:60])}` {why}", "type it anew")


def _plain(cell: str) -> str:
    """A cell without what guards it in spreadsheets."""
    return cell[1:] if cell.startswith(FORMULA_GUARDS) else cell


def _with_brackets_closed(cells: list[str], delimiter: str) -> list[str]:
    """Cells of which a vector that stood without quotes was parted: `[3` and `-4] m/s` are one."""
    found: list[str] = []
    for cell in cells:
        if found and found[-1].count("[") > found[-1].count("]"):
            found[-1] += f"{delimiter.strip() or ','} {cell.lstrip()}"
        else:
            found.append(cell)
    return found


def _cells(line: str, delimiter: str) -> list[str] | None:
    """The cells of one line; None if its quotes are not right."""
    try:
        return next(csv.reader([line], delimiter=delimiter, strict=True, skipinitialspace=True), [])
    except csv.Error:
        return None
