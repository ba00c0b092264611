"""Letters of a formula that the sheet gives as numbers: in a file with `symbols` the names of `given` stay letters, and
an answer may be written with them or with their numbers.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.errors import Mark
from planar_cli.homework.sets.own_names import own_names
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.variants.worked_problem import Part, WorkedProblem, ledger_of
from planar_cli.problem.language.parser import parse_side
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import number_of
from planar_cli.units import Unit, parse_unit, pretty_unit

GRAVITY = "g", "m/s^2"
_TOLD = re.compile(r"(?<![\d.])(9\.81|32\.2)(?!\d)")
"""In the words of a problem: its own g. Metric or in feet."""
Given = dict[str, tuple[Fraction, Unit]]


def with_given(
    problem: WorkedProblem, expected: tuple[Expected, ...], values: Mapping[str, str]
) -> tuple[Expected, ...]:
    """The finds of a variant, formulas with the letters that its sheet gives as numbers and those that may stand there
    too. `values`: of the variant, as a file writes them.
    """
    pairs = zip(problem.finds, expected, strict=True)
    return tuple(_with_given(problem, part.problem, one, values) if one.formula else one for (part, _), one in pairs)


def _with_given(problem: WorkedProblem, own: Problem, one: Expected, values: Mapping[str, str]) -> Expected:
    given = given_numbers(own, problem.problem, values)
    known = tuple((n, float(v) * in_base(u, us=False)) for n, (v, u) in given.items())
    others = _letters(own, given) if one.kind == "formula" else ()
    there = {name for name, _ in one.letters}
    return replace(one, known=known, others=tuple(o for o in others if o[0] not in there))


def pure_numbers(problem: WorkedProblem, values: Mapping[str, str]) -> dict[str, sp.Rational]:
    """The pure numbers that a variant gives, exactly: these can be put into a formula without their units."""
    given = given_numbers(problem.problem, problem.problem, values)
    return {n: sp.Rational(v.numerator, v.denominator) for n, (v, unit) in given.items() if unit.text == "1"}


def given_numbers(own: Problem, whole: Problem, values: Mapping[str, str]) -> Given:
    """The numbers of `given` in a part with its `own` names; a case that gives a number itself keeps it,
    whatever the variant of the `whole` file.
    """
    kept = own_names(own, whole)
    found: Given = {}
    for name in own.given:
        varied = name.name in values and name.name not in kept
        side = parse_side(values[name.name], Mark("<variant>", 1, 1)) if varied else name.value
        number = None if side is None else number_of(side)
        if number is not None:
            found[name.name] = number
    return found


def _letters(problem: Problem, given: Given) -> tuple[tuple[str, str], ...]:
    symbols = {s.name: s.unit or "1" for s in problem.symbols}
    numbers = {name: unit.text for name, (_, unit) in given.items()}
    return tuple({GRAVITY[0]: GRAVITY[1], **symbols, **numbers}.items())


def gravity_told(problem: WorkedProblem) -> tuple[str, ...]:
    """g with the number that it has, where answers rest on it and the file does not give it."""
    own = {s.name for s in (*problem.problem.given, *problem.problem.symbols)}
    if GRAVITY[0] in own or problem.problem.symbols or _TOLD.search(problem.problem.text):
        return ()
    for part in problem.parts:
        ledger = ledger_of(part)
        symbol = None if ledger is None else ledger.symbols.get(GRAVITY[0])
        if symbol is None or symbol not in ledger.values or not _rests_on(part, symbol):
            continue
        unit = parse_unit("ft/s^2") if problem.problem.us else ledger.units[symbol]
        return (f"g = {float(ledger.values[symbol]) / in_base(unit, problem.problem.us):.4g} {pretty_unit(unit.text)}",)
    return ()


def _rests_on(part: Part, symbol: sp.Symbol) -> bool:
    if part.replay is None:
        return part.problem.plane == "vertical"
    equations = part.replay.equations
    return symbol in equations.rests_on(e for a in equations.asked.values() for e in a.parts)
