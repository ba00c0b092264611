"""Variants of a problem: values of its given names that keep the physics what it is.

A combination of values is taken only where the same case holds (roll or slip, taut or slack), each answer keeps its
sign, no answer hangs on the last digit of a datum, and each typical mistake still gives a clearly wrong number. The
equations are solved once and carried out for all combinations together; where a problem has answers that do not follow
from written equations, each variant is solved by itself.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from itertools import islice

import numpy as np

from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.powers_of_ten import is_of_a_datum
from planar_cli.homework.variants.fit_variants import (
    ILL,
    NO_VALUE,
    NUDGE,
    OTHER_CASE,
    OTHER_SIGN,
    STEEP,
    TOO_CLOSE,
    UNSOLVED,
    Judge,
    in_equations,
    is_of_physics,
    objection,
    signs,
    variant_solved,
)
from planar_cli.homework.variants.given_letters import with_given
from planar_cli.homework.variants.own_gravity import GRAVITY
from planar_cli.homework.variants.same_formula import as_in_file
from planar_cli.homework.variants.solved_anew import REFUSED, Anew, is_same, to_check
from planar_cli.homework.variants.told_letters import Formulas
from planar_cli.homework.variants.variant_draws import Draw, draws
from planar_cli.homework.variants.worked_problem import (
    APART,
    Carried,
    Part,
    WorkedProblem,
    base_expected,
    base_numbers,
    expected_of,
    models_of,
    with_other_number,
)
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.sections.variations import Variation, variations_of
from planar_cli.records import changing, record
from planar_cli.replay.solver import Numbers
from planar_cli.solve.solution import Found

AT_MOST = 4
"""So many combinations are tried for each variant that is wanted, where each is solved by itself."""
SPARE, AT_LEAST = 1.5, 500
"""Carried out together are so many for each variant that is wanted, and no fewer than that."""


@record
class Variant:
    """One variant: its values, and its finds without mistakes."""

    draw: Draw
    expected: tuple[Expected, ...]
    alone: WorkedProblem | None = None
    """Itself, where it was solved by itself: the equations of the file are not its own."""


@changing
class Variants:
    """What was drawn: the variants taken, how many were tried, and why others were not taken."""

    taken: list[Variant] = field(default_factory=list)
    tried: int = 0
    rejected: Counter[str] = field(default_factory=Counter)
    note: str = ""
    met: dict[tuple[str, str], Counter[str]] = field(default_factory=dict)
    """Each value of a name that was tried: how many combinations with it are fit, "", or are not, by the reason."""
    combinations: int = 0
    """So many there are of the values that the file allows."""
    refused: dict[tuple[str, str], tuple[Draw, str]] = field(default_factory=dict)
    """By each value of a name, the first combination with it that is not fit by the equations, and why."""
    alike: list[Variant] = field(default_factory=list)
    """Fit combinations with the answers of one that is taken: they are taken where there are too few others."""
    repeated: int = 0
    """So many of these are taken."""
    answers: set[tuple[object, ...]] = field(default_factory=set)
    """Those of the variants taken, as a key tells them."""

    def take(self, variant: Variant) -> None:
        """One that is fit."""
        answers = tuple(map(_answer, variant.expected))
        (self.alike if answers in self.answers else self.taken).append(variant)
        self.answers.add(answers)

    def meet(self, draw: Draw, why: str) -> None:
        """A combination, and what the equations have against it."""
        for pair in draw.values:
            self.met.setdefault(pair, Counter())[why] += 1
            if why:
                self.refused.setdefault(pair, (draw, why))

    def refuse(self, draw: Draw) -> None:
        """One that is fit by the equations and has no solution."""
        self.rejected[UNSOLVED] += 1
        for pair in draw.values:
            # `+`: without what is counted no more.
            self.met[pair] = +(self.met[pair] - Counter({"": 1}))
        self.meet(draw, UNSOLVED)

    def fill(self, count: int) -> None:
        """So many variants where others that differ in an answer are not there."""
        more = self.alike[: max(count - len(self.taken), 0)]
        self.taken += more
        self.repeated = len(more)

    @property
    def never(self) -> tuple[tuple[tuple[str, str], Counter[str]], ...]:
        """The values of names with which no combination that was tried is fit, and how many for which reason."""
        return tuple(sorted(((pair, why) for pair, why in self.met.items() if not why[""]), key=lambda one: one[0]))

    @property
    def rate(self) -> float:
        """The part of the combinations tried that was fit."""
        return 1.0 if not self.tried else 1 - sum(self.rejected.values()) / self.tried


def _answer(expected: Expected) -> tuple[object, ...]:
    """As a key tells it; a formula with the numbers of its letters."""
    inside = dict(expected.letters)
    return expected.text, *(pair for pair in expected.known if pair[0] in inside)


def variations(problem: WorkedProblem) -> tuple[Variation, ...]:
    """The values that the file allows."""
    return variations_of(problem.node, Report())


def variants_of(problem: WorkedProblem, count: int, seed: int, formulas: Formulas | None = None) -> Variants:
    """So many variants, or as many as there are; the same for the same seed. `formulas`: tells answers in letters, of
    which the formula is not that of the file.
    """
    varied = variations(problem)
    found = Variants(combinations=math.prod(len(v.values) for v in varied))
    if not varied or count < 1:
        return found
    key = f"{seed}/{problem.name}"
    if problem.is_written:
        anew = Anew(problem)
        # Where one that was solved anew is refused, each that is taken has to be solved.
        for each in (False, True):
            found = Variants(combinations=found.combinations)
            _take_written(problem, draws(varied, key), count, found, anew if each else None)
            found.fill(count)
            if anew.differs or not _solved_anew_agree(problem, found, anew):
                break
            if each or not anew.refuses:
                return found
        note = "solved one by one, as the equations of the file do not fit all values"
        found = Variants(note=note, combinations=found.combinations)
    drawn = draws(varied, key)
    _take_solved(problem, drawn, count, found, formulas)
    found.fill(count)
    return found


# --- carried out together --------------------------------------------------------------------------------------------


def columns(problem: WorkedProblem, drawn: Sequence[Draw]) -> dict[str, Numbers]:
    """The values of each name, one for each combination, in base units."""
    rows = [base_numbers(problem.problem, dict(d.values)) for d in drawn]
    return {name: np.array([row[name] for row in rows]) for name in (rows[0] if rows else ())}


def _take_written(
    problem: WorkedProblem, drawn: Iterator[Draw], count: int, found: Variants, anew: Anew | None
) -> None:
    """Combinations that are fit by the equations, in blocks. `anew`: solves each of them too; one that is refused is
    not taken.
    """
    together, solved = max(int(SPARE * count), AT_LEAST), 0
    while len(found.taken) < count and (some := list(islice(drawn, together))):
        out = _CarriedOut(problem, some)
        why = _objections(problem, out.values, out.base, out.numbers, out.carried, len(some))
        for draw, reason in zip(some, why, strict=True):
            found.meet(draw, reason)
        for k, draw in enumerate(some):
            if len(found.taken) >= count or solved >= AT_MOST * count:
                return
            found.tried += 1
            if why[k]:
                found.rejected[why[k]] += 1
                continue
            variant = Variant(draw, out.expected(k))
            if anew is not None:
                solved += 1
                if anew.refuses_one(draw, variant.expected):
                    found.refuse(draw)
                    continue
                if anew.differs:
                    return
            found.take(variant)


class _CarriedOut:
    """The equations of a problem carried out for some combinations."""

    def __init__(self, problem: WorkedProblem, drawn: Sequence[Draw]) -> None:
        self.problem, self.values = problem, columns(problem, drawn)
        self.base = {e.find: e for e in base_expected(problem)}
        self.carried = Carried(problem, self.values)
        self.numbers = {f.name: self.carried.asked(p, f) for p, f in in_equations(problem)}
        self._signs = {n: signs(self.base[n].values, self.base[n].scale) for n in self.numbers}

    def expected(self, k: int) -> tuple[Expected, ...]:
        """The finds of one combination."""
        data = {name: float(column[k]) for name, column in self.values.items()}

        def of(part: Part, one: Found) -> Expected:
            if one.name not in self.numbers:
                return self.base[one.name]
            pairs = zip(self.numbers[one.name], self._signs[one.name], strict=True)
            own = tuple(float(n[k]) if due else 0.0 for n, due in pairs)
            plain = len(own) == 1 and GRAVITY not in data
            other = with_other_number(self.base[one.name], one, own[0]) if plain else None
            return other or expected_of(self.problem, part, one, own, self.base[one.name].scale, data)

        return tuple(of(part, one) for part, one in self.problem.finds)


def _objections(
    problem: WorkedProblem,
    values: Mapping[str, Numbers],
    base: Mapping[str, Expected],
    numbers: Mapping[str, tuple[Numbers, ...]],
    carried: Carried,
    count: int,
) -> list[str]:
    """Why each combination is not taken; "" where it is."""
    why = [""] * count

    def object_where(bad: np.ndarray, reason: str) -> None:
        for k in np.flatnonzero(np.broadcast_to(bad, count)):
            why[k] = why[k] or reason

    for find, parts in numbers.items():
        for n in parts:
            object_where(~np.isfinite(n), NO_VALUE.format(find))
    for run in carried.runs.values():
        object_where(~np.broadcast_to(run.holds(), count), OTHER_CASE)
    for find, parts in numbers.items():
        here = signs(parts, base[find].scale)
        for sign, due in zip(here, signs(base[find].values, base[find].scale), strict=True):
            object_where(sign != due, OTHER_SIGN.format(find))
    for name, column in values.items():
        nudged = Carried(problem, {**values, name: column * (1 + NUDGE)})
        for part, one in problem.finds:
            if one.name in numbers:
                for n, before in zip(nudged.asked(part, one), numbers[one.name], strict=True):
                    size = np.maximum(np.abs(before), 1e-6 * base[one.name].scale)
                    object_where(np.abs(n - before) > STEEP * NUDGE * size, ILL.format(one.name, name))
    for mistake, find, close in _too_close(problem, values, base, numbers):
        object_where(close, TOO_CLOSE.format(mistake, find))
    return why


def _too_close(
    problem: WorkedProblem,
    values: Mapping[str, Numbers],
    base: Mapping[str, Expected],
    numbers: Mapping[str, tuple[Numbers, ...]],
) -> Iterator[tuple[str, str, np.ndarray]]:
    """Where mistakes that give a clearly wrong number with the values of the file do not: which, of which find."""
    for name, model in models_of(problem):
        if is_of_a_datum(model.model.feedback):
            # With a value of little influence elsewhere than its decimal point no combination is spoilt.
            continue
        try:
            here, there = Carried(problem, {}, model), Carried(problem, values, model)
        except NOT_CARRIED_OUT:
            continue
        for part, one in problem.finds:
            if one.name not in numbers:
                continue
            due = np.array(base[one.name].values)
            tolerance = base[one.name].tolerance
            wrong = np.array([float(n[0]) for n in here.asked(part, one)])
            if not np.isfinite(wrong).all() or np.hypot.reduce(wrong - due) <= APART * tolerance * np.hypot.reduce(due):
                continue
            off = np.sqrt(sum((a - b) ** 2 for a, b in zip(there.asked(part, one), numbers[one.name], strict=True)))
            size = np.sqrt(sum(n**2 for n in numbers[one.name]))
            yield name, one.name, off <= APART * tolerance * size


def _solved_anew_agree(problem: WorkedProblem, found: Variants, anew: Anew) -> bool:
    """Does solving some of the variants anew give the same, by the same course of modes, where it is not refused? And
    are combinations that are not fit by the equations not fit when they are solved?
    """
    for k in to_check(problem, [v.draw for v in found.taken], [v.expected for v in found.taken]):
        if not anew.refuses_one(found.taken[k].draw, found.taken[k].expected) and anew.differs:
            return False
    refused = {why: draw for draw, why in (found.refused[pair] for pair, _ in found.never) if is_of_physics(why)}
    return not any(_is_fit_after_all(problem, draw, why) for why, draw in islice(refused.items(), REFUSED))


def _is_fit_after_all(problem: WorkedProblem, draw: Draw, why: str) -> bool:
    """A combination that was not taken: is it fit when it is solved, or does it come to other numbers?"""
    anew = variant_solved(problem, draw)
    if anew is None or objection(problem, anew, draw):
        return False
    return why == OTHER_CASE or not is_same(_CarriedOut(problem, [draw]).expected(0), base_expected(anew))


# --- solved one by one -----------------------------------------------------------------------------------------------


def _take_solved(
    problem: WorkedProblem, drawn: Iterator[Draw], count: int, found: Variants, formulas: Formulas | None
) -> None:
    judge = Judge(problem)
    base = with_given(problem, base_expected(problem), {})
    for draw in islice(drawn, AT_MOST * count):
        if len(found.taken) >= count:
            return
        found.tried += 1
        anew = variant_solved(problem, draw)
        reason = UNSOLVED if anew is None else objection(problem, anew, draw) or judge.objection(anew, draw)
        if anew is None or reason:
            found.rejected[reason] += 1
            continue
        expected = with_given(problem, base_expected(anew), dict(draw.values))
        told = {} if formulas is None or not any(e.formula for e in expected) else formulas(anew.solution, {})
        pairs = zip(base, expected, strict=True)
        taken = tuple(replace(as_in_file(before, now, told.get(now.find)), scale=before.scale) for before, now in pairs)
        found.take(Variant(draw, taken, anew))
