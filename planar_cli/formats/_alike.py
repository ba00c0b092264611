"""What formats that print formulas have alike: the words of a heading, the table of forces, the line of an answer, of a
check.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

from planar_cli.report.blocks import Answer, Check, Forces, Heading, Inline, Line, Name, Table, Text
from planar_cli.report.lettered import lettered

NAMING = ("CASE", "STATE", "MOTION")
"""Labels behind which stands a name, no title."""
DIAGRAMS = "free-body diagram = kinetic diagram"
ANNOUNCING = ("Given", "Find", "Principle", "Assume", "Motion")
"""Notes that say what follows: they stay on one sheet with it."""
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
    rows = [((Text(f.body, "strong"),), f.left, *((f.right,) if both else ())) for f in run]
    return Table(tuple((Text(h),) for h in heads), tuple(rows))


def answer_line(answer: Answer) -> Line:
    """An answer with its name."""
    relation = ": " if answer.relation == ":" else f" {answer.relation} "
    return (Name(answer.name), Text(relation), *answer.line)


def check_line(check: Check) -> Line:
    """A check; where words have a formula in them, its letters are names."""
    return tuple(piece for part in check.line for piece in _checked(part))


def _checked(part: Inline) -> Line:
    return lettered(part.text) if isinstance(part, Text) and re.search("[=√]|/2", part.text) else (part,)
