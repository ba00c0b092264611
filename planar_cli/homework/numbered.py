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
from planar_cli.homework.given_letters import GRAVITY, given_numbers
from planar_cli.homework.paper import Expected, Mistaken, Place
from planar_cli.homework.typed_formula import values_at
from planar_cli.homework.unreadable import Unreadable
from planar_cli.homework.worked_problem import Carried, ModelOf, Part, WorkedProblem, models_of, worked
from planar_cli.problem.nodes import Mapping as MappingNode
from planar_cli.problem.nodes import Node, Scalar
from planar_cli.problem.variations import with_first_values
from planar_cli.records import record
from planar_cli.replay.numbers import Numbers
from planar_cli.replay.written import NotWritten
from planar_cli.solve.instant.verify import Disagreement
from planar_cli.units import PURE, parse_unit

PLACES, NEEDED = 10, 6
"""So many places are tried; at so many the numbers must come to what the formulas come to."""
SAME = 1e-7
"""Relative: the same number."""
LEFT_OUT = ("given", "symbols", "assume", "answers", "variants", "tolerance")
"""Keys of a file that one with numbers has otherwise, or not at all."""


@record
class Numbered:
    """The problem with numbers, and the places: values of its letters in SI units."""

    problem: WorkedProblem
    places: tuple[Mapping[str, float], ...]

    def at(self, whole: WorkedProblem, values: Mapping[str, str]) -> list[dict[str, float]]:
        """The places of a variant of the `whole` problem, with the numbers that it gives."""
        given = given_numbers(whole.problem, whole.problem, values)
        known = {name: float(v) * in_base(unit, us=False) for name, (v, unit) in given.items()}
        return [{**place, **known} for place in self.places]


def numbered(problem: WorkedProblem) -> Numbered | None:
    """The same problem with numbers; None: it has no letters, or its equations do not tell its answers."""
    if problem.problem.us or problem.problem.cases or not problem.problem.symbols:
        return None
    drawn = _drawn(problem.parts[0]) if problem.parts else {}
    units = {GRAVITY[0]: GRAVITY[1], **{s.name: s.unit or "1" for s in problem.problem.symbols}}
    if not drawn.keys() >= {s.name for s in problem.problem.symbols}:
        return None
    letters = {n: v for n, v in drawn.items() if n in units}
    try:
        with_numbers = worked(problem.path, problem.name, _with_numbers(problem.node, letters, units))
    except (PlanarError, Disagreement):
        return None
    if any(part.replay is None for part in with_numbers.parts):
        return None
    return Numbered(with_numbers, tuple(_places(letters, units)))


def _drawn(part: Part) -> dict[str, float]:
    """The values with which the solution in letters was looked at: they are as the file assumes."""
    solution = part.solution
    if solution.motion is not None:
        value = solution.motion.value
    elif solution.instants:
        value = solution.instants[-1].instant.scene.valuations[0]
    else:
        return {}
    return {s.name: float(value.values[s]) for s in sorted(value.drawn, key=lambda s: s.name)}


def _with_numbers(node: Node, letters: Mapping[str, float], units: Mapping[str, str]) -> Node:
    node = with_first_values(node)
    assert isinstance(node, MappingNode)
    given = node.get("given")
    pairs = given.pairs if isinstance(given, MappingNode) else ()
    own = {key.text for key, _ in pairs}

    def scalar(text: str) -> Scalar:
        return Scalar(text, False, node.mark, node.mark)

    numbers = {n: f"{v / in_base(parse_unit(units[n]), us=False):.6f}" for n, v in letters.items() if n not in own}
    more = tuple((scalar(n), scalar(f"{v} {units[n]}".removesuffix(" 1"))) for n, v in numbers.items())
    kept = tuple((k, v) for k, v in node.pairs if k.text not in LEFT_OUT)
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
    columns = {n: np.array([place[n] for places in every for place in places]) for n in every[0][0]}
    right = _asked(same.problem, columns, None)
    wrong = [(name, model, _asked(same.problem, columns, model)) for name, model in models_of(same.problem)]
    made = []
    for k, row in enumerate(expected):
        kept = _where_same(row, every[k], right, k * PLACES)
        if len(kept) < NEEDED:
            made.append(row)
            continue
        places = tuple(tuple(sorted(every[k][i].items())) for i in kept)
        at = [k * PLACES + i for i in kept]
        made.append(tuple(_with_wrong(one, places, at, right, wrong) for one in row))
    return made


def _asked(problem: WorkedProblem, columns: Mapping[str, Numbers], model: ModelOf | None) -> dict[str, Numbers]:
    """The finds that are one number, in SI units; none where a model cannot be carried out."""
    try:
        run = Carried(problem, columns, model)
        return {
            one.name: np.broadcast_to(numbers[0], len(next(iter(columns.values()))))
            for part, one in problem.finds
            if part.replay is not None and one.name in part.replay.equations.asked
            for numbers in [run.runs[part.solution.case].asked(one.name)]
            if len(numbers) == 1
        }
    except (ArithmeticError, PlanarError, NotWritten, KeyError, np.linalg.LinAlgError):
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
