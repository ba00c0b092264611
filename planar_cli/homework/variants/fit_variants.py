"""When a variant is fit: the same case holds as in the file, each answer keeps its sign, none hangs on the last digit
of a datum, and each typical mistake still gives a clearly wrong number.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

import numpy as np

from planar_cli.errors import Mark, PlanarError
from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.powers_of_ten import is_of_a_datum
from planar_cli.homework.variants.course import course_of
from planar_cli.homework.variants.given_letters import with_given
from planar_cli.homework.variants.same_formula import formula_changes_sign
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.worked_problem import (
    APART,
    Carried,
    Part,
    WorkedProblem,
    base_expected,
    base_numbers,
    models_of,
    with_numbers,
)
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.sections.variations import number_of, written
from planar_cli.replay.solver import Numbers
from planar_cli.solve.solution import Found

NUDGE, STEEP = 1e-5, 40.0
"""A datum is changed by the first part of it; an answer may change by so many times as much."""
ZERO, LEAST = 1e-9, 1e-3
"""A component below the first part of its vector is zero but for rounding; a vector counts as large as the second part
of the largest given quantity of its dimension at least.
"""

OTHER_CASE, UNSOLVED = "another case holds", "it has no solution"
OTHER_SIGN, NO_VALUE, ILL = "{} changes its sign", "{} has no value", "{} hangs on the last digits of {}"
TOO_CLOSE = "the mistake {} gives nearly the right {}"


def is_of_physics(reason: str) -> bool:
    """Does a variant not fit for its physics, not for the mistakes that would be hard to tell in it?"""
    return reason in (OTHER_CASE, UNSOLVED) or reason.endswith((OTHER_SIGN[2:], NO_VALUE[2:]))


def in_equations(problem: WorkedProblem) -> list[tuple[Part, Found]]:
    """The numbers that follow from written equations."""
    numbers = {e.find for e in base_expected(problem) if e.kind in ("number", "vector")}
    asked = {n for p in problem.parts if p.replay is not None for n in p.replay.equations.asked}
    return [(p, f) for p, f in problem.finds if f.name in numbers & asked]


def signs(parts: Sequence[Numbers | float], scale: float) -> list[Numbers]:
    """-1, 0 or 1 of each component; what rounding leaves of a zero is one. `scale`: of the find."""
    rows = [np.asarray(p, dtype=float) for p in parts]
    size = np.sqrt(sum((row**2 for row in rows), np.float64(0)))
    return [np.where(np.abs(row) <= ZERO * np.maximum(size, LEAST * scale), 0.0, np.sign(row)) for row in rows]


def variant_solved(problem: WorkedProblem, draw: Draw) -> WorkedProblem | None:
    """A variant solved; None: it has no solution."""
    try:
        return with_numbers(problem, dict(draw.values))
    except PlanarError:
        return None


def objection(problem: WorkedProblem, anew: WorkedProblem, draw: Draw) -> str:
    """What speaks against a variant by its answers and its modes; "": nothing."""
    if course_of(anew.solution) != course_of(problem.solution):
        return OTHER_CASE
    base = with_given(problem, base_expected(problem), {})
    pairs = zip(base, with_given(problem, base_expected(anew), dict(draw.values)), strict=True)
    return next((r for before, now in pairs if (r := _changed(before, now))), "")


class Judge:
    """Says why variants that are solved by themselves are not fit."""

    def __init__(self, problem: WorkedProblem) -> None:
        self.problem = problem
        self.base = {e.find: e for e in base_expected(problem)}
        wrong = _wrong(problem).items()
        self.wrong = {key for key, v in wrong if all(map(math.isfinite, v)) and _is_apart(self.base[key[2]], v)}

    def objection(self, anew: WorkedProblem, draw: Draw) -> str:
        """What speaks against it by its own equations, at its own values; for a find without equations, by solving it
        once more.
        """
        due = {e.find: e for e in base_expected(anew)}
        for name, number in base_numbers(anew.problem, dict(draw.values)).items():
            nudged = Carried(anew, {name: np.array([number * (1 + NUDGE)])})
            for part, one in in_equations(anew):
                if _is_steep(due[one.name], [float(n[0]) for n in nudged.asked(part, one)]):
                    return ILL.format(one.name, name)
        known = {one.name for _, one in in_equations(anew)}
        others = [e for e in due.values() if e.find not in known and e.kind in ("number", "vector")]
        if others:
            beside = variant_solved(self.problem, _nudged(draw))
            numbers = {} if beside is None else {e.find: e.values for e in base_expected(beside)}
            steep = next((e.find for e in others if _is_steep(e, numbers.get(e.find, ()))), "")
            if steep:
                return ILL.format(steep, " and ".join(name for name, _ in draw.values))
        for (mistake, said, find), values in _wrong(anew).items():
            if (mistake, said, find) in self.wrong and not _is_apart(due[find], values):
                return TOO_CLOSE.format(mistake, find)
        return ""


def _is_steep(due: Expected, beside: Sequence[float]) -> bool:
    """Does an answer change too much, or go, where a datum is changed by a little?"""
    if len(beside) != len(due.values):
        return True
    size = max(math.hypot(*due.values), 1e-6 * due.scale)
    return any(not abs(a - b) <= STEEP * NUDGE * size for a, b in zip(beside, due.values, strict=True))


def _nudged(draw: Draw) -> Draw:
    """A combination with each number changed by a little."""
    more = 1 + Fraction(NUDGE).limit_denominator()

    def changed(text: str) -> str:
        number = number_of(parse_side(text, Mark("<variant>", 1, 1)))
        return text if number is None else f"{written(number[0] * more)} {number[1].text}".removesuffix(" 1")

    return Draw(tuple((name, changed(text)) for name, text in draw.values))


def _wrong(problem: WorkedProblem) -> dict[tuple[str, str, str], tuple[float, ...]]:
    """What mistakes give that can be carried out: by the mistake, what it says, and the find; but for data
    with their decimal point elsewhere.
    """
    found = {}
    for name, model in models_of(problem):
        if is_of_a_datum(model.model.feedback):
            continue
        try:
            run = Carried(problem, {}, model)
            for part, one in in_equations(problem):
                found[name, model.model.feedback, one.name] = tuple(float(n[0]) for n in run.asked(part, one))
        except NOT_CARRIED_OUT:
            continue
    return found


def _is_apart(due: Expected, wrong: Sequence[float]) -> bool:
    """Is a wrong number clearly another one, or none?"""
    off = math.dist(due.values, wrong)
    return not off <= APART * due.tolerance * math.hypot(*due.values)


def _changed(before: Expected, now: Expected) -> str:
    if before.kind != now.kind or (now.kind == "word" and before.text != now.text):
        return OTHER_CASE
    if len(before.values) != len(now.values):
        return OTHER_CASE
    scale = before.scale
    if any(a != b for a, b in zip(signs(before.values, scale), signs(now.values, scale), strict=True)):
        return OTHER_SIGN.format(before.find)
    if before.kind == "formula" and formula_changes_sign(before, now):
        return OTHER_SIGN.format(before.find)
    return ""
