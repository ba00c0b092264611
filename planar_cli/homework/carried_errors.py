"""Errors carried forward: a later find with the student's own value of an earlier one, in the same equations."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.paper import Expected, Task
from planar_cli.homework.worked_problem import Part, WorkedProblem
from planar_cli.replay.numbers import Numbers
from planar_cli.units import parse_unit

FAR = 1e3
"""A value that is further off by a factor carries nothing: what follows from it is no work of the student's."""
ROUNDS = 40


class Carrier:
    """Carries own values through the problems of a set. `values`: by problem and variant, numbers of given names."""

    def __init__(
        self, problems: Mapping[str, WorkedProblem], values: Mapping[tuple[str, int], Mapping[str, float]]
    ) -> None:
        self.problems, self.values = problems, values

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
        values = self.carrier.values.get((task.problem, self.variant), {})
        return next(_carried(problem, values, expected, task, own), None)


def _carried(
    problem: WorkedProblem,
    values: Mapping[str, float],
    expected: Expected,
    task: Task,
    own: Mapping[str, tuple[float, ...]],
) -> Iterator[tuple[tuple[float, ...], tuple[str, ...]]]:
    """The find with all own values that it rests on."""
    us = problem.problem.us
    right = {e.find: e for e in task.expected}
    parts = {f.name: (p, f) for p, f in problem.finds}
    part, found = parts[expected.find]
    if part.replay is None or found.name not in part.replay.equations.asked:
        return
    equations = part.replay.equations
    behind = equations.rests_on(equations.asked[found.name].parts)
    inputs: dict[sp.Symbol, Numbers] = {
        equations.inputs[n]: np.array([v]) for n, v in values.items() if n in equations.inputs
    }
    fixed: dict[sp.Symbol, Numbers] = {}
    names: list[str] = []
    for name, typed in own.items():
        earlier, _ = parts[name]
        due = right[name]
        if len(typed) != 1 or not _is_sane(typed[0], due.values[0]):
            continue
        number = typed[0] * in_base(parse_unit(due.unit), us)
        link = f"{earlier.solution.case}.{name}"
        if link in equations.inputs and equations.inputs[link] in behind:
            inputs[equations.inputs[link]] = np.array([number])
            names.append(name)
        elif earlier is part and (unknown := _unknown_of(part, name, number, inputs)) is not None:
            symbol, value = unknown
            if symbol in behind:
                fixed[symbol] = np.array([value])
                names.append(name)
    if not names:
        return
    run = part.replay.run(inputs, fixed=fixed)
    numbers = tuple(float(n[0]) / in_base(found.unit, us) for n in run.asked(found.name))
    if all(math.isfinite(n) for n in numbers) and any(numbers):
        yield numbers, tuple(names)


def _is_sane(value: float, due: float) -> bool:
    """Zero, or a value of quite another size, may make anything come out."""
    return bool(value) and bool(due) and 1 / FAR < abs(value / due) < FAR


def _unknown_of(
    part: Part, find: str, number: float, inputs: Mapping[sp.Symbol, Numbers]
) -> tuple[sp.Symbol, float] | None:
    """The one unknown of which a find is made, with its value where the find has a number; None: there are more."""
    assert part.replay is not None
    equations = part.replay.equations
    asked = equations.asked.get(find)
    if asked is None or len(asked.parts) != 1:
        return None
    unknowns = [s for s in asked.parts[0].free_symbols if s in set(equations.unknowns)]
    if len(unknowns) != 1:
        return None
    (symbol,) = unknowns
    run = part.replay.run(inputs)
    value = float(run.number(symbol)[0])
    for _ in range(ROUNDS):
        here, beside = (_at(part, asked.parts[0], symbol, v, inputs) for v in (value, value * (1 + 1e-6) + 1e-9))
        slope = (beside - here) / (value * 1e-6 + 1e-9)
        if not math.isfinite(slope) or not slope:
            return None
        step = (here - number) / slope
        value -= step
        if abs(step) <= 1e-12 * max(abs(value), 1e-30):
            return symbol, value
    return None


def _at(part: Part, expr: sp.Expr, symbol: sp.Symbol, value: float, inputs: Mapping[sp.Symbol, Numbers]) -> float:
    assert part.replay is not None
    run = part.replay.run(inputs, fixed={symbol: np.array([value])})
    return float(run.of(expr)[0])
