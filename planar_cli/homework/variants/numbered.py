"""A problem in letters solved once more with numbers in place of its letters. At several values of the letters (places)
its equations tell what mistakes, and own earlier results, make of an answer in letters.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from planar_cli.base_units import in_base
from planar_cli.errors import PlanarError
from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT
from planar_cli.homework.sets.paper import Expected, Mistaken, Place
from planar_cli.homework.typed.typed_formula import values_at
from planar_cli.homework.typed.unreadable import Unreadable
from planar_cli.homework.variants.given_letters import GRAVITY, Given, given_numbers
from planar_cli.homework.variants.worked_problem import Carried, ModelOf, Part, WorkedProblem, models_of, worked
from planar_cli.problem.nodes.nodes import Mapping as MappingNode
from planar_cli.problem.nodes.nodes import Node, Scalar
from planar_cli.problem.sections.variations import with_first_values
from planar_cli.records import record
from planar_cli.replay.solver import Numbers
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.units import PURE, Unit, parse_unit

PLACES, NEEDED = 10, 6
"""So many places are tried; at so many the numbers must come to what the formulas come to."""
SAME = 1e-7
"""Relative: the same number."""
LEFT_OUT = ("given", "symbols", "assume", "answers", "variants", "tolerance")
"""Keys of a file that one with numbers has otherwise, or not at all."""


@record
class Numbered:
    """The problem with numbers, and the places: values of its letters in SI units. `factors`: what one SI unit of a
    name is in the base units of the problem.
    """

    problem: WorkedProblem
    places: tuple[Mapping[str, float], ...]
    factors: Mapping[str, float]

    def at(self, whole: WorkedProblem, values: Mapping[str, str]) -> list[dict[str, float]]:
        """The places of a variant of the `whole` problem, with the numbers that it gives."""
        known = {name: float(v) * in_base(unit, us=False) for name, (v, unit) in _given(whole, values).items()}
        return [{**place, **known} for place in self.places]


def numbered(problem: WorkedProblem) -> Numbered | None:
    """The same problem with numbers; None: it has no letters, or its equations do not tell its answers."""
    symbols = _symbols(problem)
    drawn = [_drawn(part) for part in problem.parts]
    # What is assumed of a case holds of the file too, but not the other way round. With the numbers of the others
    # a case may have no solution: then they go without it.
    for node in (problem.node, _without_cases(problem.node)):
        for first in reversed(drawn if symbols else ()):
            letters = {name: v for one in (*drawn, first) for name, v in one.items()}
            if letters.keys() >= symbols.keys():
                found = _solved_with(problem, node, symbols, letters)
                if found is not None:
                    return found
    return None


def _without_cases(node: Node) -> Node:
    assert isinstance(node, MappingNode)
    return MappingNode(tuple((k, v) for k, v in node.pairs if k.text != "cases"), node.mark)


def _solved_with(
    problem: WorkedProblem, node: Node, symbols: Mapping[str, str], drawn: Mapping[str, float]
) -> Numbered | None:
    """The file, with its cases or without, with these numbers, which are in its base units. None: it is not solved with
    them.
    """
    us = problem.problem.us
    units = {GRAVITY[0]: "ft/s^2" if us else GRAVITY[1], **symbols}
    letters = {n: v / in_base(parse_unit(units[n]), us) for n, v in drawn.items() if n in units}
    try:
        with_numbers = worked(problem.path, problem.name, _with_numbers(node, letters, units))
    except (PlanarError, Disagreement):
        return None
    if all(part.replay is None for part in with_numbers.parts):
        return None
    us = with_numbers.problem.us
    known = {name: unit for name, (_, unit) in _given(problem, {}).items()}
    known |= {name: parse_unit(unit) for name, unit in units.items()}
    factors = {name: 1 / in_si(unit, us) for name, unit in known.items()}
    si = {n: v * in_base(parse_unit(units[n]), us=False) for n, v in letters.items()}
    return Numbered(with_numbers, tuple(_places(si, units)), factors)


def in_si(unit: Unit, us: bool) -> float:
    """What the base unit of a problem, of the dimension of `unit`, is in SI units."""
    return in_base(unit, us=False) / in_base(unit, us)


def _symbols(problem: WorkedProblem) -> dict[str, str]:
    """The letters of the file and of its cases, with their units."""
    whole = problem.problem
    return {s.name: s.unit or "1" for p in (*(c.problem for c in whole.cases), whole) for s in p.symbols}


def _given(whole: WorkedProblem, values: Mapping[str, str]) -> Given:
    """The numbers of the file and of its cases; where a case has another one, that of the file."""
    given: Given = {}
    for own in (*(c.problem for c in whole.problem.cases), whole.problem):
        given |= given_numbers(own, whole.problem, values)
    return given


def _drawn(part: Part) -> dict[str, float]:
    """The values with which the solution in letters was looked at, in base units: they are as the file assumes."""
    solution = part.solution
    if solution.motion is not None:
        value = solution.motion.value
    elif solution.instants:
        value = solution.instants[-1].instant.scene.valuations[0]
    else:
        return {}
    return {s.name: float(value.values[s]) for s in sorted(value.drawn, key=lambda s: s.name)}


def _with_numbers(node: Node, letters: Mapping[str, float], units: Mapping[str, str]) -> Node:
    """The file with numbers for its letters and those of its cases. `letters`: numbers in `units`."""
    node = with_first_values(node)
    assert isinstance(node, MappingNode)
    whole = _numbers_given(node, letters, units)
    # A letter that the file gives as a number is one for a case alone; all others vary with those of the file.
    given = node.get("given")
    known = {key.text for key, _ in given.pairs} if isinstance(given, MappingNode) else set()
    of_cases = {n: v for n, v in letters.items() if n in known}
    pairs = tuple((k, _cases(v, of_cases, units) if k.text == "cases" else v) for k, v in whole.pairs)
    return MappingNode(pairs, node.mark)


def _cases(node: Node, letters: Mapping[str, float], units: Mapping[str, str]) -> Node:
    if not isinstance(node, MappingNode):
        return node

    def own(case: Node) -> Node:
        symbols = case.get("symbols") if isinstance(case, MappingNode) else None
        names = [key.text for key, _ in symbols.pairs] if isinstance(symbols, MappingNode) else []
        return (
            _numbers_given(case, {n: letters[n] for n in names if n in letters}, units)
            if isinstance(case, MappingNode)
            else case
        )

    return MappingNode(tuple((key, own(case)) for key, case in node.pairs), node.mark)


def _numbers_given(node: MappingNode, letters: Mapping[str, float], units: Mapping[str, str]) -> MappingNode:
    """A file, or a case, in which the letters are given."""
    given = node.get("given")
    pairs = given.pairs if isinstance(given, MappingNode) else ()
    own = {key.text for key, _ in pairs}

    def scalar(text: str) -> Scalar:
        return Scalar(text, False, node.mark, node.mark)

    numbers = {n: f"{v:.6f}" for n, v in letters.items() if n not in own}
    more = tuple((scalar(n), scalar(f"{v} {units[n]}".removesuffix(" 1"))) for n, v in numbers.items())
    kept = tuple((k, v) for k, v in node.pairs if k.text not in LEFT_OUT)
    if not (*pairs, *more):
        return MappingNode(kept, node.mark)
    return MappingNode(((scalar("given"), MappingNode((*pairs, *more), node.mark)), *kept), node.mark)


def _places(letters: Mapping[str, float], units: Mapping[str, str]) -> Iterator[dict[str, float]]:
    """Values near those that were drawn, so that the same case holds."""
    rng = random.Random(1)
    for _ in range(PLACES):
        yield {name: value * _factor(units[name], rng) for name, value in letters.items()}


def _factor(unit: str, rng: random.Random) -> float:
    made = parse_unit(unit)
    near = 0.1 if made.dimension == PURE else 0.3
    return 1 + near * (2 * rng.random() - 1)


# --- what mistakes give ----------------------------------------------------------------------------------------------


def with_wrong_values(
    problem: WorkedProblem,
    same: Numbered,
    expected: Sequence[tuple[Expected, ...]],
    values: Sequence[Mapping[str, str]],
) -> list[tuple[Expected, ...]]:
    """The finds of each variant, formulas with their places, and with what every mistake gives there. `values`: of the
    variants, as a file writes them.
    """
    every = [same.at(problem, v) for v in values]
    columns = {n: np.array([place[n] for places in every for place in places]) * same.factors[n] for n in every[0][0]}
    right = _asked(same.problem, columns, None)
    wrong = [(name, model, _asked(same.problem, columns, model)) for name, model in models_of(same.problem)]
    made = []
    for k, row in enumerate(expected):
        changed = list(row)
        for finds in _of_each_case(problem):
            kept = _where_same([row[i] for i in finds], every[k], right, k * PLACES)
            if len(kept) >= NEEDED:
                places = tuple(tuple(sorted(every[k][i].items())) for i in kept)
                at = [k * PLACES + i for i in kept]
                for i in finds:
                    changed[i] = _with_wrong(row[i], places, at, right, wrong)
        made.append(tuple(changed))
    return made


def _of_each_case(problem: WorkedProblem) -> Iterator[list[int]]:
    """The places of the finds of the file, and of each case."""
    for case in dict.fromkeys(part.solution.case for part, _ in problem.finds):
        yield [i for i, (part, _) in enumerate(problem.finds) if part.solution.case == case]


def _asked(problem: WorkedProblem, columns: Mapping[str, Numbers], model: ModelOf | None) -> dict[str, Numbers]:
    """The finds that are one number, in SI units; none where a model cannot be carried out."""
    us = problem.problem.us
    try:
        run = Carried(problem, columns, model)
        return {
            one.name: np.broadcast_to(numbers[0], len(next(iter(columns.values())))) * in_si(one.unit, us)
            for part, one in problem.finds
            if part.replay is not None and one.name in part.replay.equations.asked
            for numbers in [run.runs[part.solution.case].asked(one.name)]
            if len(numbers) == 1
        }
    except NOT_CARRIED_OUT:
        return {}


def _where_same(
    row: Sequence[Expected], places: Sequence[Mapping[str, float]], right: Mapping[str, Numbers], first: int
) -> list[int]:
    """The places at which the numbers are those of the formulas."""
    here = tuple(tuple(sorted(p.items())) for p in places)
    kept = list(range(len(places)))
    for one in row:
        if one.kind == "formula" and one.find in right:
            due = values_at(one.formula, here)
            kept = [i for i in kept if math.isclose(due[i], right[one.find][first + i], rel_tol=SAME)]
    return kept


def _with_wrong(
    one: Expected,
    places: tuple[Place, ...],
    at: Sequence[int],
    right: Mapping[str, Numbers],
    wrong: Sequence[tuple[str, ModelOf, Mapping[str, Numbers]]],
) -> Expected:
    if one.kind != "formula" or one.find not in right:
        return one
    due = right[one.find][at]
    found: list[Mistaken] = []
    for name, model, numbers in wrong:
        values = numbers[one.find][at] if one.find in numbers else due
        off, size = np.abs(values - due), np.abs(due)
        if not np.isfinite(values).all() or not values.any() or (np.abs(values) <= SAME * size).any():
            continue
        if (off > 1e-4 * size).any() and (np.abs(values + due) > 1e-4 * size).any():
            mistaken = Mistaken(name, model.model.feedback, tuple(map(float, values)))
            found += [] if mistaken in found else [mistaken]
    known = {(m.name, m.feedback) for m in found}
    before = [m for m in one.mistakes if (m.name, m.feedback) not in known or not _is_among(m, found, places)]
    return replace(one, places=places, mistakes=(*before, *found))


def _is_among(mistake: Mistaken, found: Sequence[Mistaken], places: tuple[Place, ...]) -> bool:
    """Does a mistake that was made in the formula give what one in the equations gives?"""
    try:
        values = values_at(mistake.formula, places)
    except Unreadable:
        return False
    return any(all(map(_close, values, m.values)) for m in found if m.name == mistake.name)


def _close(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=SAME)
