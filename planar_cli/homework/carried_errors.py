"""Errors carried forward: a later find with the student's own value of an earlier one, in the same equations."""

from __future__ import annotations

import math
import pickle
from collections.abc import Mapping

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.paper import Expected, Task
from planar_cli.homework.worked_problem import WorkedProblem
from planar_cli.records import changing, record
from planar_cli.replay.equations import Equations
from planar_cli.replay.numbers import Numbers, Replay
from planar_cli.units import parse_unit

FAR = 1e3
"""A value that is further off by a factor carries nothing: what follows from it is no work of the student's."""
ROUNDS = 40


@record
class Carriable:
    """What carrying needs of a problem, fit to cross processes: by case its equations; `units` of the finds, `cases` in
    which they stand; `values`: by variant, numbers of given names in base units.
    """

    us: bool
    equations: Mapping[str, Equations]
    cases: Mapping[str, str]
    units: Mapping[str, str]
    values: Mapping[int, Mapping[str, float]]


def carriable(problem: WorkedProblem, values: Mapping[int, Mapping[str, float]]) -> Carriable:
    """The same of a worked problem."""
    return Carriable(
        problem.problem.us,
        {p.solution.case: p.replay.equations for p in problem.parts if p.replay is not None},
        {f.name: p.solution.case for p, f in problem.finds},
        {f.name: f.unit.text for _, f in problem.finds},
        values,
    )


@changing
class _Ready:
    """A problem with its equations ready to be carried out."""

    data: Carriable
    replays: dict[str, Replay]

    def replay(self, case: str) -> Replay | None:
        if case not in self.replays and case in self.data.equations:
            self.replays[case] = Replay(self.data.equations[case])
        return self.replays.get(case)


class Carrier:
    """Carries own values through the problems of a set, by their names."""

    def __init__(self, problems: Mapping[str, Carriable]) -> None:
        self.problems = {name: _Ready(data, {}) for name, data in problems.items()}

    def for_variant(self, variant: int) -> CarriedHere:
        """For the submissions of one variant."""
        return CarriedHere(self, variant)


class CarriedHere:
    """The same for one variant."""

    def __init__(self, carrier: Carrier, variant: int) -> None:
        self.carrier, self.variant = carrier, variant

    def __call__(
        self, task: Task, expected: Expected, own: Mapping[str, tuple[float, ...]]
    ) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
        """What a find comes to with own values of earlier finds, in its unit, and which of them it rests on."""
        problem = self.carrier.problems.get(task.problem)
        if problem is None:
            return None
        return _carried(problem, problem.data.values.get(self.variant, {}), expected, task, own)


def _carried(
    problem: _Ready,
    values: Mapping[str, float],
    expected: Expected,
    task: Task,
    own: Mapping[str, tuple[float, ...]],
) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
    """The find with all own values that it rests on."""
    data = problem.data
    case = data.cases[expected.find]
    replay = problem.replay(case)
    if replay is None or expected.find not in replay.equations.asked:
        return None
    equations = replay.equations
    right = {e.find: e for e in task.expected}
    behind = equations.rests_on(equations.asked[expected.find].parts)
    inputs: dict[sp.Symbol, Numbers] = {
        equations.inputs[n]: np.array([v]) for n, v in values.items() if n in equations.inputs
    }
    fixed: dict[sp.Symbol, Numbers] = {}
    names: list[str] = []
    for name, typed in own.items():
        if len(typed) != 1 or not _is_sane(typed[0], right[name].values[0]):
            continue
        number = typed[0] * in_base(parse_unit(data.units[name]), data.us)
        link = equations.inputs.get(f"{data.cases[name]}.{name}")
        if link is not None and link in behind:
            inputs[link] = np.array([number])
            names.append(name)
        elif data.cases[name] == case and (unknown := _unknown_of(replay, name, number, inputs)) is not None:
            symbol, value = unknown
            if symbol in behind:
                fixed[symbol] = np.array([value])
                names.append(name)
    if not names:
        return None
    run = replay.run(inputs, fixed=fixed)
    factor = in_base(parse_unit(data.units[expected.find]), data.us)
    numbers = tuple(float(n[0]) / factor for n in run.asked(expected.find))
    fit = all(math.isfinite(n) for n in numbers) and any(numbers)
    return (numbers, tuple(names)) if fit else None


def _is_sane(value: float, due: float) -> bool:
    """Zero, or a value of quite another size, may make anything come out."""
    return bool(value) and bool(due) and 1 / FAR < abs(value / due) < FAR


def _unknown_of(
    replay: Replay, find: str, number: float, inputs: Mapping[sp.Symbol, Numbers]
) -> tuple[sp.Symbol, float] | None:
    """The one unknown of which a find is made, with its value where the find has a number; None: there are more."""
    asked = replay.equations.asked.get(find)
    if asked is None or len(asked.parts) != 1:
        return None
    known = set(replay.equations.unknowns)
    unknowns = [s for s in asked.parts[0].free_symbols if s in known]
    if len(unknowns) != 1:
        return None
    (symbol,) = unknowns
    value = float(replay.run(inputs).number(symbol)[0])
    for _ in range(ROUNDS):
        nudge = value * 1e-6 + 1e-9
        here, beside = (_at(replay, asked.parts[0], symbol, v, inputs) for v in (value, value + nudge))
        slope = (beside - here) / nudge
        if not math.isfinite(slope) or not slope:
            return None
        step = (here - number) / slope
        value -= step
        if abs(step) <= 1e-9 * max(abs(value), 1e-30):
            return symbol, value
    return None


def _at(replay: Replay, expr: sp.Expr, symbol: sp.Symbol, value: float, inputs: Mapping[sp.Symbol, Numbers]) -> float:
    run = replay.run(inputs, fixed={symbol: np.array([value])})
    return float(run.of(expr)[0])


def unpickled(carrying: Mapping[str, bytes]) -> dict[str, Carriable]:
    """What carrying errors needs of each problem: bytes that this program has written itself, never a file."""
    return {name: pickle.loads(data) for name, data in carrying.items()}
