"""The text for one student: every answer with what it scores and what is said of it, with nothing of the key."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from planar_cli.homework.exports._text import Names, slug
from planar_cli.homework.sets.paper import MISSING, RIGHT, Graded, Result
from planar_cli.homework.sets.printed_names import printed
from planar_cli.problem.nodes.show import visible

STUDENT_LINE, LONGEST_LINE = 3, 10_000
"""The name stands on the third line of a text; so much of a line is read."""


def file_of(student: str, folder: str, names: Names) -> str:
    """The name of the file for this student: one that no other has, in this run or an earlier one in this folder."""
    while True:
        name = f"{names.of(slug(student))}.txt"
        if _is_free(Path(folder) / name, student):
            return name


def _is_free(path: Path, student: str) -> bool:
    """Nothing stands there, or a text that was written for the same student."""
    try:
        with path.open(encoding="utf-8", errors="replace") as stream:
            head = [stream.readline(LONGEST_LINE) for _ in range(STUDENT_LINE)]
    except FileNotFoundError:
        return True
    except OSError:
        return False
    name = visible(student)
    return head[-1].startswith((f"{name}: ", f"{name}, variant "))


def feedback(result: Result, title: str, titles: Mapping[str, str]) -> str:
    """The text. `title`: of the homework; `titles`: of its problems, by their names."""
    variant = f", variant {result.variant}" if result.variant else ""
    lines = [title, "", f"{result.student}{variant}: {_points(result.score, result.max_score)}"]
    for problem in dict.fromkeys(g.problem for g in result.graded):
        graded = [g for g in result.graded if g.problem == problem]
        whole = _points(sum(g.score for g in graded), sum(g.max_score for g in graded))
        lines += ["", f"{titles.get(problem) or problem}: {whole}", *map(_line, graded)]
    told = list(_of_the_whole(result))
    lines += ["", *told] if told else []
    return "\n".join(map(visible, lines)) + "\n"


def _points(score: float, most: float) -> str:
    return f"{score:g} of {most:g} {'point' if most == 1 else 'points'}"


def _line(one: Graded) -> str:
    head = f"  {printed(one.find)}"
    if one.verdict == MISSING:
        return f"{head}: no answer, {_points(0.0, one.max_score)}"
    told = one.told if not one.carried else "carried on"
    said = "; ".join(filter(None, (one.message, one.feedback)))
    if one.carried:
        said += "; it counts in full" if one.score == one.max_score else "; it counts in part"
    line = f"{head}: `{one.submitted}` {told}, {_points(one.score, one.max_score)}"
    return line if one.verdict == RIGHT and not said else f"{line}: {said}"


def _of_the_whole(result: Result) -> Iterator[str]:
    """What is said of the whole file; its name is told, not the lecturer's folders."""
    folder = os.path.dirname(result.source)
    for sentence in result.wrong:
        yield sentence.replace(f"{folder}{os.sep}", "") if folder else sentence
