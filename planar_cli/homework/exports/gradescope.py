"""Gradescope: what an autograder hands back for each submission."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any, ClassVar, final

from planar_cli.homework.exports._text import Names, clean, one_line
from planar_cli.homework.exports.base import Exported, ResultExport
from planar_cli.homework.sets.paper import RIGHT, Graded, Result

DECIMALS = 5
"""To so many places scores are rounded, as other autograders do."""


@final
class Gradescope(ResultExport):
    """Results of an autograder for Gradescope, one `results.json` for each submission.

    The file
        A folder for each student with `results.json`. Each find is one test: its name, its score out of its points,
        passed or failed, and as output what the student is told. The total is the sum of the tests. `extra_data` has
        the student's name as the submission states it. Nothing of the key is in it.

    To import it
        The `run_autograder` of an assignment copies the file of its student to
        `/autograder/results/results.json`.

    What is lost
        Verdicts on value, unit, sign and precision apart, unless the message tells them; which mistake it was, where
        several give the same number.
    """

    kind: ClassVar[str] = "gradescope"

    def export(self, results: Sequence[Result], title: str, excel: bool = False) -> Exported:
        names = Names()
        files = {f"{names.of(result.student)}/results.json": _written(_results(result, title)) for result in results}
        return Exported(files)


def _results(result: Result, title: str) -> dict[str, Any]:
    said = "\n".join([f"{one_line(title)}, variant {result.variant}", *map(clean, result.wrong)])
    numbered: dict[str, int] = {}
    tests = []
    for graded in result.graded:
        problem = list(dict.fromkeys(g.problem for g in result.graded)).index(graded.problem) + 1
        numbered[graded.problem] = numbered.get(graded.problem, 0) + 1
        tests.append(_test(graded, f"{problem}.{numbered[graded.problem]}"))
    # A score must stand somewhere: without any test, here.
    alone = {} if tests else {"score": 0.0}
    formats = {"output_format": "text", "test_output_format": "text"}
    known = {"student": clean(result.student), "variant": result.variant}
    return {**alone, "output": said, **formats, "tests": tests, "extra_data": known}


def _test(graded: Graded, number: str) -> dict[str, Any]:
    said = [f"Read: {graded.submitted}" if graded.submitted else "", graded.message, graded.feedback]
    return {
        "score": round(graded.score, DECIMALS),
        "max_score": round(graded.max_score, DECIMALS),
        "status": "passed" if graded.verdict == RIGHT or graded.score >= graded.max_score > 0 else "failed",
        "name": f"{one_line(graded.problem)}: {one_line(graded.find)}",
        "number": number,
        "output": clean("\n".join([graded.told, *filter(None, said)])),
        "visibility": "visible",
    }


def _written(content: dict[str, Any]) -> bytes:
    return (json.dumps(content, ensure_ascii=False, indent=2) + "\n").encode()
