"""The document of neutral blocks: what a solution says, without saying how it looks.

Everything that reports makes a `Document`; every format turns one into text. The vocabulary is closed on purpose: a new
block makes every format fail type checking until it can print it. Of what a line is made stands in `lines.py`, of what
a figure in `marks.py`.
"""

from __future__ import annotations

from dataclasses import field
from typing import TYPE_CHECKING

from planar_cli.records import record
from planar_cli.report.document.lines import Inline, Line, Math, Name, Relation, Term, Text, TextStyle, Value, Way, line
from planar_cli.report.document.marks import Figure

if TYPE_CHECKING:
    from planar_cli.equation.scene.scene import Scene

__all__ = ["Inline", "Line", "Math", "Name", "Relation", "Term", "Text", "TextStyle", "Value", "Way", "line"]


@record
class Title:
    """The title of the document, or of a part of it; `level`: so many levels below that of the whole."""

    text: str
    level: int = 0


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
    `scene`: where the body is found by who draws it; `posed`: in which position it is drawn, where that is not plain.
    """

    body: str
    left: Line
    right: Line = ()
    heads: tuple[str, str] = ("free-body diagram", "kinetic diagram")
    scene: Scene | None = field(default=None, repr=False, compare=False)
    posed: str = ""


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


@record
class Typed:
    """Lines as somebody types them into a file."""

    rows: tuple[str, ...]


@record
class Drawing:
    """A figure; a format that cannot show one leaves it out."""

    figure: Figure


Block = (
    Drawing | Title | Heading | Paragraph | Bullet | Equation | Result | Forces | Table | Answer | Check | Note | Typed
)


@record
class Document:
    """A whole report; formats print `title` first."""

    title: str
    blocks: tuple[Block, ...]
