"""Linear equations in numbers, row below row: with so many figures that who solves them as they stand finds the roots
that are printed below them.

Where the rows are nearly alike, four figures of each coefficient give two of a root, so the coefficients get more. A
table has a column for each unknown, with as many decimals in all rows; where it would be too wide, there are two, or
rows are equations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Table, line
from planar_cli.report.notation.numbers import as_printed, significant
from planar_cli.report.notation.ordering import NUMBER

MOST, MORE, ALIKE = 10, 6, 2
"""More figures, or so many more than the roots have, help nobody; by so many figures more than the others a number of a
column may have.
"""
HALF = Decimal("0.5000001")
"""Of the last figure of a root: by so much it may differ."""
GAP, WIDEST = 3, 96
"""Between two columns, and the width of all of them on a page of usual width."""
BETWEEN, FRAME = 11, 3
"""About what a name and a sign take beside each coefficient of an equation; the lines of a table that are no rows."""
SENSITIVE = "Rows that are nearly alike need so many figures: with fewer, they would give other roots."
DEPENDENT = "These rows are nearly dependent: the roots are those of the numbers before they were rounded."
SMALLEST = Decimal("1e-9")
"""What is shown as zero is found to be less than half of this."""
SMALL = Decimal("1e-30")
"""In parts of the largest coefficient of a row: one below it is the rounding of sixty digits."""


@record
class Row:
    """A sum of unknowns, each with its coefficient, and the number that it is."""

    coefficients: Mapping[sp.Symbol, Decimal]
    number: Decimal

    def cleaned(self) -> Row:
        """Without coefficients that are the rounding of the largest."""
        largest = max(map(abs, self.coefficients.values()), default=Decimal(0))
        return Row({s: c for s, c in self.coefficients.items() if abs(c) > SMALL * largest}, self.number)


Numbered = tuple[int, Row, Line]
"""A row with its printed number and the note that tells its unit."""


def system(
    rows: Sequence[Numbered],
    unknowns: Sequence[sp.Symbol],
    roots: Mapping[sp.Symbol, Decimal],
    figures: int,
) -> list[Block]:
    """The rows of a system. `roots`: what they give, shown to so many `figures`."""
    kept = [row.cleaned() for _, row, _ in rows]
    for printed in range(figures, max(MOST, figures + MORE) + 1):
        places = {s: _decimals(kept, s, printed) for s in unknowns}
        told = _tables(rows, kept, unknowns, places, printed)
        if not told:
            places = dict.fromkeys(unknowns)
        if enough := _gives([_printed(row, places, printed) for row in kept], unknowns, roots, figures):
            break
    blocks: list[Block] = [*told] or _equations(rows, kept, unknowns, printed)
    if not enough:
        return [Paragraph(line(DEPENDENT)), *blocks]
    return [Paragraph(line(SENSITIVE)), *blocks] if printed > figures + 1 else blocks


def _tables(
    rows: Sequence[Numbered],
    kept: Sequence[Row],
    unknowns: Sequence[sp.Symbol],
    places: Mapping[sp.Symbol, int | None],
    figures: int,
) -> list[Table]:
    """The rows below one another, in two tables where that takes fewer lines than equations; empty: they are too wide
    for that, or in different units.
    """
    notes = {note for _, _, note in rows}
    columns = [[_text(row, s, places, figures) for row in kept] for s in unknowns]
    columns.append([significant(row.number, figures) for row in kept])
    sizes = [max(map(len, column)) + GAP for column in columns]
    half = (len(columns) + 1) // 2
    parts = [slice(None)] if sum(sizes) <= WIDEST else [slice(half), slice(half, None)]
    if len(notes) > 1 or any(sum(sizes[part]) > WIDEST for part in parts):
        return []
    lengths = (len(texts) * BETWEEN + sum(map(len, texts)) for texts in zip(*columns, strict=True))
    if len(parts) > 1 and sum(-(-length // WIDEST) for length in lengths) <= 2 * (len(rows) + FRAME):
        return []
    head = [*(line(Math(s)) for s in unknowns), line("right side ", *notes.pop())]
    cells = [[line(f"({number})"), *map(line, own)] for (number, _, _), *own in zip(rows, *columns, strict=True)]
    return [Table((line("row"), *head[part]), tuple((own[0], *own[1:][part]) for own in cells)) for part in parts]


def _equations(
    rows: Sequence[Numbered], kept: Sequence[Row], unknowns: Sequence[sp.Symbol], figures: int
) -> list[Block]:
    """The rows as equations."""
    return [
        Equation((_sum(own, unknowns, figures), _number(own.number, figures)), None, line(f"({number}):"), note)
        for own, (number, _, note) in zip(kept, rows, strict=True)
    ]


def _printed(row: Row, places: Mapping[sp.Symbol, int | None], figures: int) -> Row:
    """A row as who reads it has it."""
    coefficients = {
        s: as_printed(c, figures) if (decimals := places[s]) is None else round(c, decimals)
        for s, c in row.coefficients.items()
    }
    return Row(coefficients, as_printed(row.number, figures))


def _gives(
    rows: Sequence[Row], unknowns: Sequence[sp.Symbol], roots: Mapping[sp.Symbol, Decimal], figures: int
) -> bool:
    """Do the rows give the roots as they are shown?"""
    table = [[row.coefficients.get(s, Decimal(0)) for s in unknowns] for row in rows]
    found = solved(table, [row.number for row in rows])
    shown = [as_printed(roots[s], figures) for s in unknowns]
    last = [Decimal(10) ** (x.adjusted() + 1 - figures) if x else SMALLEST for x in shown]
    return found is not None and all(abs(x - y) <= HALF * one for x, y, one in zip(found, shown, last, strict=True))


def solved(table: Sequence[Sequence[Decimal]], right: Sequence[Decimal]) -> list[Decimal] | None:
    """The roots of as many linear equations as unknowns, by elimination; None where there is no one solution."""
    rows = [[*row, number] for row, number in zip(table, right, strict=True)]
    count = len(rows)
    for k in range(count):
        pivot = max(range(k, count), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if not rows[k][k]:
            return None
        for i in range(count):
            if i != k and rows[i][k]:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k], strict=True)]
    return [row[-1] / row[k] for k, row in enumerate(rows)]


def _decimals(rows: Sequence[Row], unknown: sp.Symbol, figures: int) -> int | None:
    """How many decimals all coefficients of an unknown have; None: they differ too much in size for that."""
    own = [abs(row.coefficients[unknown]) for row in rows if unknown in row.coefficients]
    sizes = [as_printed(x, figures).adjusted() for x in own]
    if len(own) < 2 or max(sizes) - min(sizes) > ALIKE or min(sizes) < 1 - figures or max(sizes) >= figures:
        return None
    return max(0, *(-int(as_printed(x, figures).normalize().as_tuple().exponent) for x in own))


def _text(row: Row, unknown: sp.Symbol, places: Mapping[sp.Symbol, int | None], figures: int) -> str:
    """A coefficient as it is printed."""
    coefficient, decimals = row.coefficients.get(unknown, Decimal(0)), places[unknown]
    return significant(coefficient, figures) if decimals is None or not coefficient else f"{coefficient:.{decimals}f}"


def _sum(row: Row, unknowns: Sequence[sp.Symbol], figures: int) -> Math:
    texts: dict[sp.Symbol, str] = {}
    terms = []
    for unknown in (s for s in unknowns if s in row.coefficients):
        coefficient = row.coefficients[unknown]
        number = sp.Symbol(f"{NUMBER}{len(texts):03}", positive=True)
        texts[number] = significant(abs(coefficient), figures)
        bare = [unknown] if texts[number] == "1" else [number, unknown]
        terms.append(sp.Mul(*([sp.Integer(-1)] if coefficient < 0 else []), *bare, evaluate=False))
    return Math(sp.Add(*terms, evaluate=False) if len(terms) > 1 else terms[0], texts)


def _number(number: Decimal, figures: int) -> Math:
    symbol = sp.Symbol(f"{NUMBER}0", positive=True)
    if not number:
        return Math(sp.S.Zero)
    return Math(-symbol if number < 0 else symbol, {symbol: significant(abs(number), figures)})
