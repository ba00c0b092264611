"""How often a random wrong number is taken for a typical mistake: measured on the very papers of a set."""

from __future__ import annotations

import random
from collections.abc import Iterable

from planar_cli.homework.grading.grading import grade
from planar_cli.homework.sets.key_text import shown
from planar_cli.homework.sets.paper import Expected, Paper, Submission, Task
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import within
from planar_cli.records import record

DECADES = 1.5
"""Wrong numbers lie so many decades below and above the right one, evenly by their logarithms."""
MORE = (0, 1)
"""Students write the figures that are asked for, or so many more, by turns."""


@record
class FalseMatches:
    """So many wrong numbers were graded; so many were given a mistake's name, and so many several."""

    graded: int
    named: int
    ambiguous: int

    @property
    def rate(self) -> float:
        return self.named / self.graded if self.graded else 0.0


def false_matches(papers: Iterable[Paper], rules: Rules, each: int, seed: int) -> FalseMatches:
    """So many random wrong numbers for each find of the papers."""
    rng = random.Random(seed)
    graded = named = ambiguous = 0
    for paper in papers:
        for task in paper.tasks:
            for expected in task.expected:
                if expected.kind != "number" or not expected.values[0]:
                    continue
                for k in range(each):
                    number = _wrong(expected, rules, rng)
                    figures = rules.figures + MORE[k % 2]
                    text = f"{shown(number, figures)} {expected.unit if expected.unit != '1' else ''}".strip()
                    alone = Paper(paper.variant, (Task(task.problem, task.title, "", (), (expected,)),))
                    submission = Submission("", paper.variant, ((task.problem, expected.find, text),))
                    (one,) = grade(submission, {paper.variant: alone}, rules).graded
                    graded += 1
                    named += len(one.mistakes) == 1
                    ambiguous += len(one.mistakes) > 1
    return FalseMatches(graded, named, ambiguous)


def _wrong(expected: Expected, rules: Rules, rng: random.Random) -> float:
    """A number that is not right."""
    while True:
        number: float = expected.values[0] * 10.0 ** rng.uniform(-DECADES, DECADES)
        if not within(expected, (number,), rules) and not within(expected, (-number,), rules):
            return number
