"""The document of neutral blocks: what a solution says, without saying how it looks.

Everything that reports makes a `Document`; every format turns one into text. The vocabulary is closed on purpose: a new
block makes every format fail type checking until it can print it. Formulas are carried as SymPy expressions, but this
module does not need SymPy.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from typing import TYPE_CHECKING, Literal

from planar_cli.records import record

if TYPE_CHECKING:
    from sympy import Expr, Symbol

TextStyle = Literal["plain", "strong", "muted"]


@record
class Text:
    """Words; they may come from a file, so a format escapes them."""

    text: str
    style: TextStyle = "plain"


@record
class Name:
    """A name of the file or of a principle in mathematical notation: `omega_AB`, `ΣM_C`. `of_thing`: is it that of a
    quantity of a body or a point, which gives way where the file calls a letter so?
    """

    name: str
    of_thing: bool = field(default=False, compare=False)


@record
class Math:
    """A formula. `values`: texts to print in place of symbols, for the side that shows the substituted numbers."""

    expr: Expr
    values: Mapping[Symbol, str] | None = field(default=None, hash=False)


@record
class Value:
    """A number with its unit as the author writes units (`rad/s^2`; empty: none), printed to so many figures."""

    number: Decimal
    unit: str = ""
    figures: int = 4


Term = Text | Name | Math | Value


@record
class Relation:
    """A short relation inside a line; `relation` is one of = ≠ < ≤ > ≥ ≈ →."""

    left: Term
    relation: str
    right: Term


Inline = Term | Relation
Line = tuple[Inline, ...]


def line(*parts: str | Inline | Line) -> Line:
    """A line from pieces: a string is plain text, a line is spliced in."""
    pieces: list[Inline] = []
    for part in parts:
        if isinstance(part, tuple):
            pieces.extend(part)
        else:
            pieces.append(Text(part) if isinstance(part, str) else part)
    return tuple(pieces)


@record
class Title:
    """The title of the document."""

    text: str


@record
class Heading:
    """A section: `label` ("STEP 1", may be empty), its text, and an aside at the right."""

    label: str
    text: str
    aside: str | Line = ""


@record
class Paragraph:
    """A sentence or several."""

    line: Line


@record
class Bullet:
    """One entry of a list."""

    line: Line


@record
class Equation:
    """A display equation `side relation side = side …`.

    `number` is what later lines call it by; `lead` stands before it ("↺ ΣM_C:", "(1) in (2):"); `note` after it.
    `relation` joins the first two sides, further ones follow with `=`. One side alone is a formula on display.
    """

    sides: tuple[Inline | Line, ...]
    number: int | None = None
    lead: Line = ()
    note: Line = ()
    relation: str = "="


@record
class Result:
    """An intermediate result, after the equations that gave it."""

    line: Line


@record
class Forces:
    """One row of a free-body diagram = kinetic diagram: the body, what acts on it, what that amounts to.

    Without a right-hand line it is a free-body diagram alone. `heads`: what stands over both sides in a table.
    """

    body: str
    left: Line
    right: Line = ()
    heads: tuple[str, str] = ("free-body diagram", "kinetic diagram")


@record
class Table:
    """Rows of lines under a header; a row has as many cells as the header."""

    header: tuple[Line, ...]
    rows: tuple[tuple[Line, ...], ...]


@record
class Answer:
    """The answer to one find: its name in the file, `relation` ("=" or ":"), and what it is."""

    name: str
    line: Line
    relation: str = "="


@record
class Check:
    """One check that was made; neighbours are printed together."""

    line: Line


@record
class Note:
    """A line under a label of its own: "Effects", "Discussion"; neighbours of one kind are printed together."""

    kind: str
    line: Line


Block = Title | Heading | Paragraph | Bullet | Equation | Result | Forces | Table | Answer | Check | Note


@record
class Document:
    """A whole report; formats print `title` first."""

    title: str
    blocks: tuple[Block, ...]
