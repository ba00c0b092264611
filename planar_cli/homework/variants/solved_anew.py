"""Variants whose equations were carried out, solved anew: which ones, and whether they come to the same.

The net behind equations that look right and are not: one in which a number was computed from the values of the file, or
which holds in another mode only; and behind what no equation tells, as a cable that runs out on the way. Solving costs
what carrying out is there to save, and so not all variants are solved:

- each one where they are COVERED at most;
- else each value of each varied name once (but for those of the file itself), where COVERED variants are enough;
- else the least and the greatest value of each name, and of each answer of a motion, with EXTREMES variants at most: a
  set with hundreds of values in small steps, where solving thousands is to cost no more than a few solutions;
- of values with which no combination is fit, as another case would hold or an answer have another sign, one for each
  such reason, REFUSED at most: they may be fit, where the equations are wrong.

Where one of them has no solution, each variant that is handed out is solved.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.variants.course import course_of
from planar_cli.homework.variants.fit_variants import variant_solved
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.worked_problem import WorkedProblem, base_expected, base_numbers

COVERED, EXTREMES, REFUSED = 8, 3, 4
SAME = 1e-7
"""Relative: a variant solved anew gives the same."""
Pair = tuple[str, str]


class Anew:
    """Solves combinations anew, each once: `refuses` one of them, `differs` in one from what was carried out."""

    def __init__(self, problem: WorkedProblem) -> None:
        self.problem, self.course = problem, course_of(problem.solution)
        self.refuses = self.differs = False
        self._refused: dict[Draw, bool] = {}

    def refuses_one(self, draw: Draw, expected: Sequence[Expected]) -> bool:
        """Has a combination no solution? `expected`: as it was carried out."""
        if draw not in self._refused:
            anew = variant_solved(self.problem, draw)
            self._refused[draw] = anew is None
            if anew is None:
                self.refuses = True
            elif course_of(anew.solution) != self.course or not is_same(expected, base_expected(anew)):
                self.differs = True
        return self._refused[draw]


def to_check(problem: WorkedProblem, drawn: Sequence[Draw], answers: Sequence[Sequence[Expected]] = ()) -> list[int]:
    """The places of the combinations that are to be solved anew. `answers`: of each."""
    pairs = dict.fromkeys(pair for d in drawn for pair in d.values)
    of_file = {s.name: s.written for s in problem.problem.given}
    wanted = [pair for pair in pairs if pair[1] != of_file.get(pair[0])]
    if answers and len(drawn) <= COVERED:
        return [k for k, d in enumerate(drawn) if any(pair[1] != of_file.get(pair[0]) for pair in d.values)]
    labels: list[set[Pair]] = [set(d.values) for d in drawn]
    chosen = _covering(labels, wanted, COVERED)
    if chosen is not None and not answers:
        return chosen
    numbers = {pair: base_numbers(problem.problem, dict([pair])).get(pair[0], 0.0) for pair in pairs}
    names = dict.fromkeys(name for name, _ in pairs)
    ends = {
        end(wanted_of, key=numbers.__getitem__) for n in names for end in (min, max) for wanted_of in [_of(pairs, n)]
    }
    if any(p.solution.motion is not None for p in problem.parts):
        ends |= _ends_of_answers(answers, labels)
    extremes = _covering(labels, sorted(ends), EXTREMES, cut=True) or []
    return extremes if chosen is None else list(dict.fromkeys((*extremes, *chosen)))


def _ends_of_answers(answers: Sequence[Sequence[Expected]], labels: Sequence[set[Pair]]) -> set[Pair]:
    """The least and the greatest of each answer, as labels of the combinations that have them: what ends a motion early
    comes where something moves farthest.
    """
    ends: set[Pair] = set()
    for column in zip(*answers, strict=True):
        sizes = [math.hypot(*e.values) for e in column]
        for end in (min, max):
            label = (f"{end.__name__} {column[0].find}", "")
            if column[0].values:
                labels[sizes.index(end(sizes))].add(label)
                ends.add(label)
    return ends


def _of(pairs: Iterable[Pair], name: str) -> list[Pair]:
    return [pair for pair in pairs if pair[0] == name]


def _covering(labels: Sequence[set[Pair]], wanted: Iterable[Pair], most: int, cut: bool = False) -> list[int] | None:
    """Few combinations of which one has every wanted label. None: more than the `most`, and not `cut` there."""
    left = set(wanted)
    chosen: list[int] = []
    while left:
        if len(chosen) == most:
            return chosen if cut else None
        best = max(range(len(labels)), key=lambda k: (len(left & labels[k]), -k))
        chosen.append(best)
        left -= labels[best]
    return chosen


def is_same(expected: Sequence[Expected], anew: Sequence[Expected]) -> bool:
    """Do finds that were carried out agree with those that were solved anew?"""
    others = {e.find: e for e in anew}
    return all(_agrees(e, others[e.find]) for e in expected)


def _agrees(one: Expected, other: Expected) -> bool:
    if one.kind not in ("number", "vector"):
        return one.text == other.text
    size = max(*map(abs, one.values), 1e-6 * one.scale)
    pairs = zip(one.values, other.values, strict=False)
    return len(other.values) == len(one.values) and all(abs(a - b) <= SAME * size for a, b in pairs)
