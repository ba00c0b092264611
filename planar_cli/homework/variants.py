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

from planar_cli.errors import PlanarError
from planar_cli.homework.given_letters import with_given
from planar_cli.homework.paper import Expected
from planar_cli.homework.same_formula import as_in_file, formula_changes_sign
from planar_cli.homework.told_letters import Formulas
from planar_cli.homework.variant_draws import Draw, draws
from planar_cli.homework.worked_problem import (
    APART,
    Carried,
    WorkedProblem,
    base_expected,
    base_numbers,
    expected_of,
    models_of,
    scale_of,
    with_numbers,
)
from planar_cli.problem.reading import Report
from planar_cli.problem.variations import Variation, variations_of
from planar_cli.records import changing, record
from planar_cli.replay.numbers import Numbers

AT_MOST = 4
"""So many combinations are tried for each variant that is wanted, where each is solved by itself."""
SPARE, AT_LEAST = 1.5, 500
"""Carried out together are so many for each variant that is wanted, and no fewer than that."""
NUDGE, STEEP = 1e-5, 40.0
"""A datum is changed by the first part of it; an answer may change by so many times as much."""
SAME = 1e-7
"""Relative: a variant solved anew gives the same."""
CHECKED = 2
"""So many variants are solved anew, to see that carrying the equations out gives the same."""

ZERO, LEAST = 1e-9, 1e-3
"""A component below the first part of its vector is zero but for rounding; a vector counts as large as the second part
of the largest given quantity of its dimension at least.
"""

OTHER_CASE, UNSOLVED = "another case holds", "it has no solution"
OTHER_SIGN, NO_VALUE, ILL = "{} changes its sign", "{} has no value", "{} hangs on the last digits of {}"
TOO_CLOSE = "the mistake {} gives nearly the right {}"


@record
class Variant:
    """One variant: its values, and its finds without mistakes."""

    draw: Draw
    expected: tuple[Expected, ...]


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

    @property
    def never(self) -> tuple[tuple[tuple[str, str], Counter[str]], ...]:
        """The values of names with which no combination that was tried is fit, and how many for which reason."""
        return tuple(sorted(((pair, why) for pair, why in self.met.items() if not why[""]), key=lambda one: one[0]))

    @property
    def rate(self) -> float:
        """The part of the combinations tried that was fit."""
        return 1.0 if not self.tried else 1 - sum(self.rejected.values()) / self.tried


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
    drawn = draws(varied, f"{seed}/{problem.name}")
    if problem.is_written:
        together = max(int(SPARE * count), AT_LEAST)
        while len(found.taken) < count and (some := list(islice(drawn, together))):
            _take_written(problem, some, count, found)
        if _solved_anew_agree(problem, found.taken):
            return found
        note = "solved one by one, as the equations of the file do not fit all values"
        found = Variants(note=note, combinations=found.combinations)
        drawn = draws(varied, f"{seed}/{problem.name}")
    _take_solved(problem, drawn, count, found, formulas)
    return found


# --- carried out together --------------------------------------------------------------------------------------------


def columns(problem: WorkedProblem, drawn: Sequence[Draw]) -> dict[str, Numbers]:
    """The values of each name, one for each combination, in base units."""
    rows = [base_numbers(problem.problem, dict(d.values)) for d in drawn]
    return {name: np.array([row[name] for row in rows]) for name in (rows[0] if rows else ())}


def _take_written(problem: WorkedProblem, drawn: Sequence[Draw], count: int, found: Variants) -> None:
    values = columns(problem, drawn)
    base = {e.find: e for e in base_expected(problem)}
    carried = Carried(problem, values)
    numbers = {f.name: carried.asked(p, f) for p, f in problem.finds if _is_number(base[f.name], problem, f.name)}
    why = _objections(problem, values, base, numbers, carried, len(drawn))
    signs = {find: _signs(base[find].values, base[find].scale) for find in numbers}
    for k, draw in enumerate(drawn):
        for pair in draw.values:
            found.met.setdefault(pair, Counter())[why[k]] += 1
    for k, draw in enumerate(drawn):
        if len(found.taken) >= count:
            return
        found.tried += 1
        if why[k]:
            found.rejected[why[k]] += 1
            continue
        expected = []
        for part, one in problem.finds:
            if one.name not in numbers:
                expected.append(base[one.name])
                continue
            own = tuple(float(n[k]) if due else 0.0 for n, due in zip(numbers[one.name], signs[one.name], strict=True))
            scale = scale_of(part, one.unit, problem.problem.us)
            data = {name: float(column[k]) for name, column in values.items()}
            expected.append(expected_of(problem, part, one, own, scale, data))
        found.taken.append(Variant(draw, tuple(expected)))


def _is_number(expected: Expected, problem: WorkedProblem, find: str) -> bool:
    return expected.kind in ("number", "vector") and any(
        p.replay is not None and find in p.replay.equations.asked for p in problem.parts
    )


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
        here = _signs(parts, base[find].scale)
        for sign, due in zip(here, _signs(base[find].values, base[find].scale), strict=True):
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


def _signs(parts: Sequence[Numbers | float], scale: float) -> list[Numbers]:
    """-1, 0 or 1 of each component; what rounding leaves of a zero is one. `scale`: of the find."""
    rows = [np.asarray(p, dtype=float) for p in parts]
    size = np.sqrt(sum((row**2 for row in rows), np.float64(0)))
    return [np.where(np.abs(row) <= ZERO * np.maximum(size, LEAST * scale), 0.0, np.sign(row)) for row in rows]


def _too_close(
    problem: WorkedProblem,
    values: Mapping[str, Numbers],
    base: Mapping[str, Expected],
    numbers: Mapping[str, tuple[Numbers, ...]],
) -> Iterator[tuple[str, str, np.ndarray]]:
    """Where mistakes that give a clearly wrong number with the values of the file do not: which, of which find."""
    for name, model in models_of(problem):
        try:
            here, there = Carried(problem, {}, model), Carried(problem, values, model)
        except (ArithmeticError, KeyError, np.linalg.LinAlgError):
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


def _solved_anew_agree(problem: WorkedProblem, taken: Sequence[Variant]) -> bool:
    """Does solving some of the variants anew give the same?"""
    for variant in (*taken[: CHECKED - 1], *taken[CHECKED - 1 :][-1:]):
        try:
            anew = {e.find: e for e in base_expected(with_numbers(problem, dict(variant.draw.values)))}
        except PlanarError:
            return False
        for expected in variant.expected:
            if expected.kind in ("number", "vector"):
                other = anew[expected.find]
                size = max(*map(abs, expected.values), 1e-6 * expected.scale)
                pairs = zip(expected.values, other.values, strict=False)
                if len(other.values) != len(expected.values) or any(abs(a - b) > SAME * size for a, b in pairs):
                    return False
            elif anew[expected.find].text != expected.text:
                return False
    return True


# --- solved one by one -----------------------------------------------------------------------------------------------


def _take_solved(
    problem: WorkedProblem, drawn: Iterator[Draw], count: int, found: Variants, formulas: Formulas | None
) -> None:
    base = with_given(problem, base_expected(problem), {})
    for draw in islice(drawn, AT_MOST * count):
        if len(found.taken) >= count:
            return
        found.tried += 1
        values = dict(draw.values)
        try:
            solved = with_numbers(problem, values)
            expected = with_given(problem, base_expected(solved), values)
        except PlanarError:
            found.rejected[UNSOLVED] += 1
            continue
        pairs = list(zip(base, expected, strict=True))
        reason = next((r for before, now in pairs if (r := _changed(before, now))), "")
        if reason:
            found.rejected[reason] += 1
            continue
        told = {} if formulas is None or not any(e.formula for e in expected) else formulas(solved.solution, {})
        taken = tuple(replace(as_in_file(before, now, told.get(now.find)), scale=before.scale) for before, now in pairs)
        found.taken.append(Variant(draw, taken))


def _changed(before: Expected, now: Expected) -> str:
    if before.kind != now.kind or (now.kind == "word" and before.text != now.text):
        return OTHER_CASE
    if len(before.values) != len(now.values):
        return OTHER_CASE
    scale = before.scale
    if any(a != b for a, b in zip(_signs(before.values, scale), _signs(now.values, scale), strict=True)):
        return OTHER_SIGN.format(before.find)
    if before.kind == "formula" and formula_changes_sign(before, now):
        return OTHER_SIGN.format(before.find)
    return ""
