"""What a tolerance does to an honest student: every intermediate result of this very problem rounded to three figures.

Two dangers are told of each find: that rounding on the way moves the result by more than the tolerance, and that a
wrong model gives a result within it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.mistakes.base import NOT_CARRIED_OUT
from planar_cli.homework.sets.paper import Expected
from planar_cli.homework.sets.rules import Rules
from planar_cli.homework.sets.tolerances import relative, within
from planar_cli.homework.variants.variant_draws import Draw
from planar_cli.homework.variants.variants import Variant, columns
from planar_cli.homework.variants.worked_problem import Carried, Part, WorkedProblem, base_expected, models_of
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


@record
class _Own:
    """The file, or a variant of it: a problem whose equations are its own, the finds, and the equations carried out."""

    problem: WorkedProblem
    expected: tuple[Expected, ...]
    run: Carried

    def tells(self, place: int) -> bool:
        """Do the equations tell the find at a place?"""
        part, one = self.problem.finds[place]
        return part.replay is not None and one.name in part.replay.equations.asked


def tolerance_report(
    problem: WorkedProblem, rules: Rules, variants: Sequence[Variant] = ()
) -> tuple[list[tuple[Danger, ...]], list[str]]:
    """For each number that is asked its danger in the file itself and in each variant, and why others have none."""
    rows = [_own(problem, base_expected(problem), Draw(()))]
    rows += [_own(problem, v.expected, v.draw) if v.alone is None else _alone(v.alone, v.expected) for v in variants]
    found: list[tuple[Danger, ...]] = []
    left: list[str] = []
    for place, (part, one) in enumerate(problem.finds):
        if part.replay is None:
            left.append(f"{one.name}: {part.why}")
        elif rows[0].tells(place) and any(rows[0].expected[place].values):
            untold = next((k for k, own in enumerate(rows) if not own.tells(place)), 0)
            if untold:
                left.append(f"{one.name}: the equations of variant {untold} do not tell it")
            else:
                found.append(tuple(_danger(own, place, rules) for own in rows))
    return found, left


def _own(problem: WorkedProblem, expected: tuple[Expected, ...], draw: Draw) -> _Own:
    return _Own(problem, expected, Carried(problem, columns(problem, [draw])))


def _alone(problem: WorkedProblem, expected: tuple[Expected, ...]) -> _Own:
    """Of a variant that was solved by itself."""
    return _Own(problem, expected, Carried(problem, {}))


def _wrong(own: _Own, part: Part, one: Found) -> Iterator[tuple[str, tuple[float, ...]]]:
    """What wrong models give, by their mistakes."""
    for name, model in models_of(own.problem):
        if model.case == part.solution.case:
            with suppress(*NOT_CARRIED_OUT):
                numbers = Carried(own.problem, own.run.values, model).asked(part, one)
                yield name, tuple(float(n[0]) for n in numbers)


def _danger(own: _Own, place: int, rules: Rules) -> Danger:
    (part, one), expected = own.problem.finds[place], own.expected[place]
    assert part.replay is not None
    factor = in_base(one.unit, own.problem.problem.us)
    due = np.array(expected.values)
    known = {s: np.full(DRAWS, n[0]) for s, n in own.run.known(part, part.replay).items()}
    run = part.replay.run({**_inputs(part), **known}, rounding=_rounding(), exact=_places(part))
    honest = float(np.nanmax(_off([n / factor for n in run.asked(one.name)], due)))
    nearest, mistake = None, ""
    passes: dict[str, None] = {}
    for name, numbers in _wrong(own, part, one):
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
