"""What formats that print formulas have alike: the words of a heading, the table of forces, the line of an answer, of a
check.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.report.document.blocks import Answer, Check, Forces, Heading, Inline, Line, Name, Table, Text
from planar_cli.report.document.lettered import lettered

NAMING = ("CASE", "STATE", "MOTION")
"""Labels behind which stands a name, no title."""
DIAGRAMS = "free-body diagram = kinetic diagram"
ANNOUNCING = ("Given", "Find", "Principle", "Assume", "Motion")
"""Notes that say what follows: they stay on one sheet with it."""
INDEXED = re.compile(r"(?<!\w)[^\W\d_]+\d*(?:_\w+)+")
"""The name of a point with an index, among words."""
NOTHING = (Text("0"),)
"""The right-hand side of a body in equilibrium."""


def heading_words(heading: Heading) -> str:
    """The words of a heading with its label."""
    label = heading.label.capitalize() if heading.label.isupper() else heading.label
    between = ": " if heading.label in NAMING else ". "
    return between.join(t for t in (label, heading.text) if t)


def aside_of(heading: Heading) -> str | Line:
    """What stands beside a heading; "" where the table below has it at its head."""
    return "" if heading.aside == DIAGRAMS else heading.aside


def table_of(run: Sequence[Forces]) -> Table:
    """Free-body diagram and kinetic diagram side by side where both are told."""
    both = any(f.right and f.right != NOTHING for f in run)
    heads = ("body", *(run[0].heads if both else run[0].heads[:1]))
    sides = ([f.left, f.right] if both else [f.left] for f in run)
    rows = [
        ((Text(f.body.replace("_", " "), "strong"),), *(tuple(_with_names(side)) for side in own))
        for f, own in zip(run, sides, strict=True)
    ]
    return Table(tuple((Text(h),) for h in heads), tuple(rows))


def _with_names(entries: Line) -> Iterator[Inline]:
    """Entries of a diagram whose points are names too: at G_AB."""
    for piece in entries:
        if not isinstance(piece, Text) or piece.style != "plain":
            yield piece
            continue
        end = 0
        for match in INDEXED.finditer(piece.text):
            yield replace(piece, text=piece.text[end : match.start()])
            yield Name(match[0])
            end = match.end()
        if end < len(piece.text):
            yield replace(piece, text=piece.text[end:])


def answer_line(answer: Answer) -> Line:
    """An answer with its name."""
    relation = ": " if answer.relation == ":" else f" {answer.relation} "
    return (Name(answer.name), Text(relation), *answer.line)


def check_line(check: Check) -> Line:
    """A check; where words have a formula in them, its letters are names."""
    return tuple(piece for part in check.line for piece in _checked(part))


def _checked(part: Inline) -> Line:
    return lettered(part.text) if isinstance(part, Text) and re.search("[=√]|/2", part.text) else (part,)
