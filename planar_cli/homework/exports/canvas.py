"""Canvas: the column of one assignment for the gradebook."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import ClassVar, final

from planar_cli.homework.exports._text import one_line, slug, table
from planar_cli.homework.exports.base import Exported, ResultExport
from planar_cli.homework.grading.class_report import counting
from planar_cli.homework.sets.paper import Result

HEADER = ("Student", "ID", "SIS User ID", "SIS Login ID", "Section")
POINTS = "    Points Possible"


@final
class Canvas(ResultExport):
    """A CSV table of total scores for the gradebook of Canvas.

    The file
        `Student,ID,SIS User ID,SIS Login ID,Section` and a column with the title of the homework; below the header the
        points that are possible, then one row for each student; of several submissions of one the last counts that can
        be graded. The name that the submission states stands under
        `Student`, and under `SIS Login ID` too where it is one word.

    To import it
        Grades, Import. Canvas overwrites scores that exist, and asks what to do with a column that it does not know:
        to fill one that exists, rename the header to that of an exported gradebook, `HW1 (12345)`.

    What is lost
        Everything but the total. Who could not be graded at all has no score.
    """

    kind: ClassVar[str] = "canvas"

    def export(self, results: Sequence[Result], title: str, excel: bool = False) -> Exported:
        possible = max((r.max_score for r in results), default=0.0)
        rows: list[tuple[str | float, ...]] = [(*HEADER, one_line(title)), (POINTS, "", "", "", "", possible)]
        left_out = []
        for result in counting(results).values():
            login = result.student if len(result.student.split()) == 1 else ""
            rows.append((result.student, "", "", login, "", result.score if result.graded else ""))
            if not result.graded:
                left_out.append(f"{one_line(result.student)}: no score, as nothing could be graded")
            elif result.max_score != possible:
                left_out.append(
                    f"{one_line(result.student)}: the score is out of {result.max_score:g}, not {possible:g}"
                )
        several = Counter(result.student for result in results)
        left_out += [
            f"{one_line(student)}: {number} submissions; the last that could be graded counts"
            for student, number in several.items()
            if number > 1
        ]
        return Exported({f"{slug(title, '-canvas')}.csv": table(rows, excel)}, tuple(left_out))
