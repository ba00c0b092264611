"""Variants whose equations were carried out, solved anew: which ones, and whether they come to the same.

The net behind equations that look right and are not: one in which a number was computed from the values of the file, or
which holds in another mode only. Solving costs what carrying out is there to save, and so not all variants are solved:

- each value of each varied name once (but for those of the file itself), where COVERED variants are enough for that;
- else the least and the greatest value of each, with EXTREMES variants at most: a set with hundreds of values in small
  steps, where solving thousands of variants is to cost no more than a few solutions;
- of values with which no combination is fit, as another case would hold or an answer have another sign, one for each
  such reason, REFUSED at most: they may be fit, where the equations are wrong.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.worked_problem import WorkedProblem, base_numbers

COVERED, EXTREMES, REFUSED = 8, 3, 4
SAME = 1e-7
"""Relative: a variant solved anew gives the same."""
Pair = tuple[str, str]


def to_check(problem: WorkedProblem, drawn: Sequence[Draw]) -> list[int]:
    """The places of the combinations that are to be solved anew."""
    pairs = dict.fromkeys(pair for d in drawn for pair in d.values)
    numbers = {pair: base_numbers(problem.problem, dict([pair])).get(pair[0], 0.0) for pair in pairs}
    of_file = {s.name: s.written for s in problem.problem.given}
    wanted = [pair for pair in pairs if pair[1] != of_file.get(pair[0])]
    chosen = _covering(drawn, wanted, COVERED)
    if chosen is not None:
        return chosen
    names = dict.fromkeys(name for name, _ in pairs)
    ends = {
        end(wanted_of, key=numbers.__getitem__) for n in names for end in (min, max) for wanted_of in [_of(pairs, n)]
    }
    return _covering(drawn, sorted(ends), EXTREMES, cut=True) or []


def _of(pairs: Iterable[Pair], name: str) -> list[Pair]:
    return [pair for pair in pairs if pair[0] == name]


def _covering(drawn: Sequence[Draw], wanted: Iterable[Pair], most: int, cut: bool = False) -> list[int] | None:
    """Few combinations in which every wanted value stands. None: they are more than the `most`, and not `cut` there."""
    left = set(wanted)
    chosen: list[int] = []
    while left:
        if len(chosen) == most:
            return chosen if cut else None
        best = max(range(len(drawn)), key=lambda k: (len(left.intersection(drawn[k].values)), -k))
        chosen.append(best)
        left -= set(drawn[best].values)
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
