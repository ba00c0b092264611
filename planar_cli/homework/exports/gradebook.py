"""A table of everything that was graded, for any spreadsheet."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar, final

from planar_cli.homework.exports._text import slug, table
from planar_cli.homework.exports.base import Exported, ResultExport
from planar_cli.homework.sets.paper import Result

HEADER = (
    "student",
    "variant",
    "problem",
    "find",
    "submitted",
    "unit",
    "expected",
    "tolerance",
    "score",
    "max_score",
    "status",
    "message",
)

TOTALS = ("student", "variant", "score", "max_score")


@final
class Gradebook(ResultExport):
    """A CSV table with one row for each find of each student, and one with the total of each.

    The files
        `student,variant,problem,find,submitted,unit,expected,tolerance,score,max_score,status,message` in UTF-8. `unit`
        is that of the key, `tolerance` relative, `status` right, wrong, carried (it follows rightly from another
        wrong value), ungradable or missing. A submission that cannot be graded at all has one row without problem
        and find. Texts that a spreadsheet would run as a formula begin with an apostrophe. It holds the key, so it is
        for the lecturer. `totals` has `student,variant,score,max_score`, of several submissions of a student the last.

    To import it
        In any spreadsheet; for Excel with the byte order mark, so that it knows UTF-8.

    What is lost
        Verdicts on value, unit, sign and precision apart, and the names of mistakes, unless the message tells them.
    """

    kind: ClassVar[str] = "gradebook"

    def export(self, results: Sequence[Result], title: str, excel: bool = False) -> Exported:
        rows = [row for result in results for row in _rows(result)]
        last = {result.student: result for result in results if result.graded}
        totals = [(r.student, r.variant, r.score, r.max_score) for r in last.values()]
        files = {
            f"{slug(title, '-gradebook')}.csv": table([HEADER, *rows], excel),
            f"{slug(title, '-totals')}.csv": table([TOTALS, *totals], excel),
        }
        return Exported(files)


def _rows(result: Result) -> list[tuple[str | float, ...]]:
    rows: list[tuple[str | float, ...]] = [
        (
            result.student,
            result.variant,
            g.problem,
            g.find,
            g.submitted,
            g.due_unit,
            g.expected,
            g.tolerance or "",
            g.score,
            g.max_score,
            g.told,
            "; ".join(filter(None, (g.message, g.feedback))),
        )
        for g in result.graded
    ]
    blank = [""] * 8
    return rows + [(result.student, result.variant, *blank, "ungradable", why) for why in result.wrong]
