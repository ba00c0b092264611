"""What a tolerance does to an honest student: every intermediate result of this very problem rounded to three figures.

Two dangers are told of each find: that rounding on the way moves the result by more than the tolerance, and that a
wrong model gives a result within it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT
from planar_cli.homework.paper import Expected
from planar_cli.homework.rules import Rules
from planar_cli.homework.tolerances import relative, within
from planar_cli.homework.variant_draws import Draw
from planar_cli.homework.variants import Variant, columns
from planar_cli.homework.worked_problem import Carried, Part, WorkedProblem, base_expected, models_of
from planar_cli.records import record
from planar_cli.replay.numbers import Rounding
from planar_cli.replay.solver import Numbers
from planar_cli.solve.solution import Found
from planar_cli.units import parse_unit

FIGURES = 3
DRAWS = 400
LENGTH = parse_unit("m").dimension
DIFFERENT = 1e-9
"""Relative: a model gives another number."""


@record
class Danger:
    """One find under a tolerance, of a file or of one variant. `honest`: the largest relative error by rounding;
    `nearest`: the smallest relative distance of a wrong model, and which; `passes`: the mistakes of wrong models that
    are within the tolerance.
    """

    find: str
    tolerance: float
    honest: float
    nearest: float | None
    mistake: str = ""
    passes: tuple[str, ...] = ()

    @property
    def fails_honest(self) -> bool:
        """Would somebody be marked wrong who only rounds?"""
        return self.honest > self.tolerance


Columns = Mapping[str, Numbers]
"""The numbers of given names, one for each variant."""


def tolerance_report(
    problem: WorkedProblem, rules: Rules, variants: Sequence[Variant] = ()
) -> tuple[list[tuple[Danger, ...]], list[str]]:
    """For each number that is asked its danger in the file itself and in each variant, and why others have none."""
    rows = [base_expected(problem), *(v.expected for v in variants)]
    draws = [Draw(()), *(v.draw for v in variants)]
    values = [columns(problem, [draw]) for draw in draws]
    found: list[tuple[Danger, ...]] = []
    left: list[str] = []
    for place, (part, one) in enumerate(problem.finds):
        if part.replay is None:
            left.append(f"{one.name}: {part.why}")
        elif one.name in part.replay.equations.asked and any(rows[0][place].values):
            expected = [row[place] for row in rows]
            wrong = [list(_wrong(problem, part, one, own)) for own in values]
            found.append(
                tuple(_danger(problem, part, one, *row, rules) for row in zip(expected, values, wrong, strict=True))
            )
    return found, left


def _wrong(problem: WorkedProblem, part: Part, one: Found, values: Columns) -> Iterator[tuple[str, tuple[float, ...]]]:
    """What wrong models give, by their mistakes."""
    for name, model in models_of(problem):
        if model.case == part.solution.case:
            with suppress(*NOT_CARRIED_OUT):
                numbers = Carried(problem, values, model).asked(part, one)
                yield name, tuple(float(n[0]) for n in numbers)


def _danger(
    problem: WorkedProblem,
    part: Part,
    one: Found,
    expected: Expected,
    values: Columns,
    wrong: Sequence[tuple[str, tuple[float, ...]]],
    rules: Rules,
) -> Danger:
    assert part.replay is not None
    factor = in_base(one.unit, problem.problem.us)
    due = np.array(expected.values)
    inputs = part.replay.equations.inputs
    own = {inputs[n]: np.full(DRAWS, v[0]) for n, v in values.items() if n in inputs}
    run = part.replay.run({**_inputs(part), **own}, rounding=_rounding(), exact=_places(part))
    honest = float(np.nanmax(_off([n / factor for n in run.asked(one.name)], due)))
    nearest, mistake = None, ""
    passes: dict[str, None] = {}
    for name, numbers in wrong:
        off = float(_off([np.array([n]) for n in numbers], due)[0])
        if np.isfinite(off) and off > DIFFERENT:
            passes |= {name: None} if within(expected, numbers, rules) else {}
            if nearest is None or off < nearest:
                nearest, mistake = off, name
    return Danger(one.name, relative(expected, rules), honest, nearest, mistake, tuple(passes))


def _off(numbers: list[Numbers], due: Numbers) -> Numbers:
    """Relative errors; those of a vector by its size."""
    size = float(np.hypot.reduce(due))
    gaps = [np.atleast_1d(n) - d for n, d in zip(numbers, due, strict=True)]
    found: Numbers = np.sqrt(sum(g**2 for g in gaps)) / size
    return found


def _inputs(part: Part) -> dict[sp.Symbol, Numbers]:
    """The given numbers as they are, once for each draw."""
    assert part.replay is not None
    equations = part.replay.equations
    return {s: np.full(DRAWS, equations.value[s]) for s in list(equations.inputs.values())[:1]}


def _places(part: Part) -> frozenset[sp.Symbol]:
    """Lengths that the drawing gives: nobody rounds coordinates and takes their differences afterwards."""
    assert part.replay is not None
    equations = part.replay.equations
    lengths = (s for s in equations.defined if (u := equations.units.get(s)) is not None and u.dimension == LENGTH)
    unknowns = set(equations.unknowns)
    return frozenset(s for s in lengths if unknowns.isdisjoint(equations.rests_on([s])))


def _rounding() -> Rounding:
    """Rounding to three figures, in the first draw as it falls, in the others by anything up to half a place."""
    rng = np.random.default_rng(1)

    def rounded(numbers: Numbers) -> Numbers:
        numbers = np.array(np.broadcast_to(numbers, DRAWS), dtype=float)
        with np.errstate(all="ignore"):
            places = np.floor(np.log10(np.abs(numbers)))
        unit = np.where(np.isfinite(places), 10.0 ** (places - FIGURES + 1), 0.0)
        safe = np.where(unit > 0, unit, 1.0)
        out = numbers + (rng.random(numbers.size) - 0.5) * unit
        out[0] = (np.round(numbers[0] / safe[0]) * safe[0]) if unit[0] > 0 else numbers[0]
        return out

    return rounded
