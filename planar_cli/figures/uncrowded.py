"""What a drawing with very many words leaves out: the lengths, which the page lists, then the angles that are not
asked. The mechanism is to be seen.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from planar_cli.report.document.blocks import Name
from planar_cli.report.document.marks import Angle, Dimension, Mark, Tag

MANY = 30
"""More words than these cannot be read beside what they name."""


def uncrowded(marks: Sequence[Mark], asked: Collection[str]) -> Sequence[Mark]:
    """`asked`: the names of what the file asks."""
    if not _is_crowded(marks):
        return marks
    found = [m for m in marks if not isinstance(m, Dimension)]
    if not _is_crowded(found):
        return found
    return [
        m for m in found if not isinstance(m, Angle) or any(isinstance(p, Name) and p.name in asked for p in m.words)
    ]


def _is_crowded(marks: Sequence[Mark]) -> bool:
    return sum(isinstance(m, Tag | Dimension | Angle) for m in marks) > MANY
