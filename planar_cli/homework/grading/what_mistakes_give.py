"""What typical mistakes give in each variant of a problem: its equations carried out with one thing changed."""

from __future__ import annotations

import math
from bisect import bisect_left, insort
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT, Mistake
from planar_cli.homework.sets.paper import Expected, Mistaken
from planar_cli.homework.sets.powers_of_ten import POWER_OF_TEN, POWERS
from planar_cli.homework.variants.worked_problem import Carried, WorkedProblem, models_of
from planar_cli.registry import members
from planar_cli.replay.solver import Numbers

NOTHING = 1e-6
"""A number below this part of the right one is what is left of zero, and no mistake that somebody makes."""
TELLING = 1.2
"""A mistake is told where it gives a number that is off by so many tolerances: less is right, or may be rounding."""
SAME = 1e-6
"""Relative: two mistakes that give the same number."""
VANISHED = 2e-3
"""Relative: what a datum gives that is a power of ten off, beside what another mistake gives."""
ZERO = 1e-9
"""In parts of the largest given quantity of its dimension: what rounding leaves of a zero."""


Found = dict[tuple[str, str, tuple[float, ...]], None]
"""What mistakes give, each once: name, feedback, values."""


def with_mistakes(
    problem: WorkedProblem, expected: Iterable[Sequence[Expected]], values: Mapping[str, Numbers]
) -> list[tuple[Expected, ...]]:
    """The finds of each variant with what every mistake gives there. `values`: as of `Carried`."""
    papers = [list(one) for one in expected]
    found: list[list[Found]] = [[{} for _ in one] for one in papers]
    nearly: list[list[Found]] = [[{} for _ in one] for one in papers]
    index = {f.name: i for i, (_, f) in enumerate(problem.finds)}
    fit = _fit(problem, papers, values)
    for name, model in models_of(problem):
        try:
            run = Carried(problem, values, model)
            for part, one in problem.finds:
                if one.name not in fit:
                    continue
                i, numbers = index[one.name], run.asked(part, one)
                changed = _apart(numbers, fit[one.name]) & np.isfinite(fit[one.name]).all(0)
                if name == POWER_OF_TEN:
                    # Where the answer is off by a power of ten too, nobody knows where that came in: the slip says so.
                    changed &= ~_off_by_ten(numbers, fit[one.name])
                for k, mistaken, clearly in _wrong(numbers, [paper[i] for paper in papers], changed):
                    (found if clearly else nearly)[k][i].setdefault((name, model.model.feedback, mistaken))
        except NOT_CARRIED_OUT:
            continue
    for one_found in (f for of_variant in found for f in of_variant):
        _leave_vanished(one_found)
    for name, kind in members("homework.mistakes").items():
        mistake: Mistake = kind()
        if type(mistake).slips is Mistake.slips:
            continue
        for k, paper in enumerate(papers):
            for i, one_expected in enumerate(paper):
                if one_expected.kind in ("number", "vector"):
                    _add_slips(found[k][i], one_expected, name, mistake)
    return [
        tuple(
            replace(e, mistakes=(*e.mistakes, *(Mistaken(*m) for m in made)), nearly=tuple(Mistaken(*m) for m in near))
            for e, made, near in zip(paper, mistakes, others, strict=True)
        )
        for paper, mistakes, others in zip(papers, found, nearly, strict=True)
    ]


def _leave_vanished(found: Found) -> None:
    """A value that is so small, or so large, that a term drops out was rather left out: that mistake tells more."""
    off = [m for m in found if m[0] == POWER_OF_TEN]
    if not off or len(off) == len(found):
        return
    others = sorted(m[2] for m in found if m[0] != POWER_OF_TEN)
    for one in off:
        if _has_near(others, one[2], VANISHED * math.hypot(*one[2])):
            del found[one]


def _has_near(known: Sequence[tuple[float, ...]], one: tuple[float, ...], least: float) -> bool:
    """Is one of the sorted ones as near as that?"""
    place = bisect_left(known, (one[0] - least,))
    while place < len(known) and known[place][0] <= one[0] + least:
        if len(known[place]) == len(one) and math.dist(one, known[place]) <= least:
            return True
        place += 1
    return False


def _add_slips(found: Found, right: Expected, name: str, mistake: Mistake) -> None:
    """What a step of the solution gives is more to the point than a slip at its end."""
    known = sorted(m[2] for m in found)
    for feedback, slip in mistake.slips(right):
        if not _has_near(known, slip, SAME * math.hypot(*slip)):
            insort(known, slip)
            _add(found, right, name, feedback, slip)


def _fit(
    problem: WorkedProblem, papers: Sequence[Sequence[Expected]], values: Mapping[str, Numbers]
) -> dict[str, Numbers]:
    """What the equations give with nothing changed, one row for each component; NaN in variants where that is not what
    is right, as equations that are wrong themselves tell nothing of a mistake.
    """
    found, index = {}, {f.name: i for i, (_, f) in enumerate(problem.finds)}
    run = Carried(problem, values)
    for part, one in problem.finds:
        if part.replay is None or one.name not in part.replay.equations.asked:
            continue
        right = [paper[index[one.name]] for paper in papers]
        numbers = np.array([np.broadcast_to(n, len(right)) for n in run.asked(part, one)], dtype=float)
        if any(len(e.values) != len(numbers) for e in right):
            continue
        due = np.array([e.values for e in right]).T
        least = np.array([ZERO * e.scale for e in right])
        with np.errstate(all="ignore"):
            same = np.hypot.reduce(numbers - due) <= SAME * np.hypot.reduce(due) + least
        found[one.name] = np.where(same, numbers, np.nan)
    return found


def _apart(numbers: Sequence[Numbers], others: Numbers) -> NDArray[np.bool_]:
    """Where numbers are not the same as others."""
    with np.errstate(all="ignore"):
        off = np.hypot.reduce(np.array([np.broadcast_to(n, others.shape[1]) for n in numbers]) - others)
        apart: NDArray[np.bool_] = off > SAME * np.hypot.reduce(others)
    return apart


def _off_by_ten(numbers: Sequence[Numbers], others: Numbers) -> NDArray[np.bool_]:
    """Where numbers are others with their decimal point elsewhere."""
    off = np.zeros(others.shape[1], dtype=bool)
    for power in POWERS:
        off |= ~_apart(numbers, others * 10.0**power)
    return off


def _wrong(
    numbers: Sequence[Numbers], right: Sequence[Expected], where: NDArray[np.bool_]
) -> Iterator[tuple[int, tuple[float, ...], bool]]:
    """Where a mistake gives another number than the right one, with it, and whether it is clearly another; `right`: by
    variant. The right one with the other sign is none.
    """
    if not where.any() or any(len(e.values) != len(numbers) for e in right):
        return
    wrong = np.array([np.broadcast_to(n, len(right)) for n in numbers], dtype=float)
    due = np.array([e.values for e in right]).T
    size = np.hypot.reduce(due)
    least = TELLING * np.array([e.tolerance for e in right]) * size
    with np.errstate(all="ignore"):
        off = np.hypot.reduce(wrong - due)
        told = np.isfinite(wrong).all(0) & (np.hypot.reduce(wrong) > NOTHING * size) & wrong.any(0)
        if len(numbers) == 1:
            told &= np.abs(wrong[0] + due[0]) > least
        told &= (off > SAME * size) & where
    columns, clearly = wrong.T.tolist(), (off > least).tolist()
    for k in np.flatnonzero(told).tolist():
        yield k, tuple(columns[k]), clearly[k]


def _add(found: Found, right: Expected, name: str, feedback: str, values: tuple[float, ...]) -> None:
    if is_clearly_wrong(right, values):
        found.setdefault((name, feedback, values))


def is_clearly_wrong(right: Expected, values: tuple[float, ...]) -> bool:
    """Is it clearly another number than the right one, and not nothing?"""
    if len(values) != len(right.values) or not all(map(math.isfinite, values)):
        return False
    if len(values) == 1:
        (number,), (due,) = values, right.values
        least = TELLING * right.tolerance * abs(due)
        return abs(number - due) > least and abs(number + due) > least and abs(number) > NOTHING * abs(due)
    size = math.hypot(*right.values)
    apart = math.dist(values, right.values) > TELLING * right.tolerance * size
    return apart and math.hypot(*values) > NOTHING * size
