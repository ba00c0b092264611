"""The text for one student: every answer with what it scores and what is said of it, with nothing of the key."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping

from planar_cli.homework.paper import MISSING, RIGHT, Graded, Result
from planar_cli.homework.printed_names import printed
from planar_cli.problem.show import visible


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
