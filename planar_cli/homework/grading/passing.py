"""Mistakes that a homework does not see: they give a number within the tolerance, which is graded right."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from planar_cli.homework.sets.paper import Expected, Mistaken, Task
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import within


def passing(tasks: Sequence[Task], rules: Rules) -> Iterator[str]:
    """What is to be said of one problem, a sentence for each mistake. `tasks`: of its variants; one: of the file."""
    counts: dict[tuple[str, str], Counter[str]] = {}
    for task in tasks:
        for expected in task.expected:
            for mistake in dict.fromkeys((m.name, m.feedback) for m in passing_of(expected, rules)):
                counts.setdefault(mistake, Counter())[expected.find] += 1
    for (name, feedback), finds in counts.items():
        where = [
            f"{find} in {count} of {len(tasks)} variants" if len(tasks) > 1 else find for find, count in finds.items()
        ]
        yield f"{tasks[0].problem}: {name} ({feedback}) is not seen: it gives a right {', '.join(where)}"


def passing_of(expected: Expected, rules: Rules) -> Iterator[Mistaken]:
    """The mistakes that give a right answer to a find."""
    if expected.kind not in ("number", "vector"):
        return
    wider = rules.tolerance is not None or rules.mode == "sigfig"
    for mistake in (*expected.nearly, *(expected.mistakes if wider else ())):
        if within(expected, mistake.values, rules):
            yield mistake
