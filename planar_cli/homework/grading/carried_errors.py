"""Errors carried forward: a find with the student's own value of one on which it rests, in the same equations."""

from __future__ import annotations

import math
import pickle
from collections.abc import Callable, Mapping
from dataclasses import field, replace

import numpy as np
import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.homework.grading.dependence import only_unknown
from planar_cli.homework.grading.followed_again import Again, Followable, followable
from planar_cli.homework.grading.own_vectors import own_inputs, with_own
from planar_cli.homework.sets.paper import Expected, Task
from planar_cli.homework.typed.typed_formula import values_at
from planar_cli.homework.variants.worked_problem import AGREES, NEARLY_ZERO, WorkedProblem
from planar_cli.records import record
from planar_cli.replay.equations import Equations
from planar_cli.replay.numbers import Replay
from planar_cli.replay.single import NoNumber, Single, Values
from planar_cli.units import parse_unit

FAR = 1e3
"""A value that is further off by a factor carries nothing: what follows from it is no work of the student's."""
ROUNDS = 40


@record
class Carriable:
    """What carrying needs of a problem, fit to cross processes: by case its equations; `units` of the finds, `cases` in
    which they stand; `values`: by variant, numbers of given names in base units; `own`: by case, names that it gives
    itself, whatever a variant has; `of_variants`: by variant, for those solved by themselves, their own equations.
    """

    us: bool
    equations: Mapping[str, Equations]
    cases: Mapping[str, str]
    units: Mapping[str, str]
    values: Mapping[int, Mapping[str, float]]
    own: Mapping[str, frozenset[str]]
    of_variants: Mapping[int, Mapping[str, Equations]] = field(default_factory=dict)
    followed: Followable | None = None
    written: Mapping[int, Mapping[str, str]] = field(default_factory=dict)
    """Where motions are followed in numbers: by variant, the values of given names as a file writes them."""

    def at(self, variant: int) -> Carriable:
        """For one variant: with its own equations, at its own values, where it has some."""
        if variant not in self.of_variants:
            return self
        return replace(self, equations=self.of_variants[variant], values={}, of_variants={})


def carriable(
    problem: WorkedProblem,
    values: Mapping[int, Mapping[str, float]],
    solved_alone: Mapping[int, WorkedProblem] | None = None,
    written: Mapping[int, Mapping[str, str]] | None = None,
) -> Carriable:
    """The same of a worked problem; of variants that were solved alone, by their equations. `written`: by variant, the
    values of given names as a file writes them, without which no motion is followed again.
    """
    followed = followable(problem) if written is not None else None
    return Carriable(
        problem.problem.us,
        _equations(problem),
        {f.name: p.solution.case for p, f in problem.finds},
        {f.name: f.unit.text for _, f in problem.finds},
        values,
        {p.solution.case: p.own for p in problem.parts},
        {k: _equations(own) for k, own in (solved_alone or {}).items()},
        followed,
        written if written is not None and followed is not None else {},
    )


def _equations(problem: WorkedProblem) -> dict[str, Equations]:
    return {p.solution.case: p.replay.equations for p in problem.parts if p.replay is not None}


class _Part:
    """The equations of one case of a problem, ready to be carried out for one variant after the other."""

    def __init__(self, equations: Equations) -> None:
        self.equations, self.replay = equations, Replay(equations)
        self.single = Single(self.replay)
        self._starts: dict[tuple[int, int], tuple[Values, Values]] = {}
        self._given: dict[tuple[tuple[int, int], str], bool] = {}
        self._behind: dict[str, frozenset[sp.Symbol]] = {}
        self._unknown: dict[str, sp.Symbol | None] = {}

    def start(self, key: tuple[int, int], of_key: Callable[[], Mapping[str, float]]) -> tuple[Values, Values]:
        """The inputs of a variant (or of a place of it), whose values are made once, and all that is right for it."""
        if key not in self._starts:
            equations, values = self.equations, of_key()
            inputs = {s: values.get(n, equations.value[s]) for n, s in equations.inputs.items()}
            run = self.replay.run({s: np.array([v]) for s, v in inputs.items()})
            self._starts[key] = inputs, {s: float(n[0]) for s, n in run.values.items()}
        return self._starts[key]

    def gives(self, key: tuple[int, int], expected: Expected, due: tuple[float, ...]) -> bool:
        """Do the equations, with nothing changed, give what is right? Else nothing is carried by them."""
        if (key, expected.find) not in self._given:
            _, right = self._starts[key]
            numbers = [self.single.of(e, dict(right)) for e in self.equations.asked[expected.find].parts]
            size = max(map(abs, due), default=0.0)
            self._given[key, expected.find] = len(numbers) == len(due) and all(
                abs(a - b) <= AGREES * size + NEARLY_ZERO for a, b in zip(numbers, due, strict=True)
            )
        return self._given[key, expected.find]

    def behind(self, find: str) -> frozenset[sp.Symbol]:
        """Everything on which a find rests."""
        if find not in self._behind:
            self._behind[find] = self.equations.rests_on(self.equations.asked[find].parts)
        return self._behind[find]

    def unknown_of(self, find: str, number: float, right: Values) -> tuple[sp.Symbol, float] | None:
        """The one unknown of which a find is made, with its value where the find has a number; None: there are more."""
        if find not in self._unknown:
            self._unknown[find] = only_unknown(self.equations, find)
        symbol = self._unknown[find]
        if symbol is None or symbol not in right:
            return None
        expr = self.equations.asked[find].parts[0]
        if expr == symbol:
            return symbol, number
        value = right[symbol]
        for _ in range(ROUNDS):
            nudge = value * 1e-6 + 1e-9
            here, beside = (self.single.of(expr, {**right, symbol: v}) for v in (value, value + nudge))
            slope = (beside - here) / nudge
            if not slope:
                return None
            step = (here - number) / slope
            value -= step
            if abs(step) <= 1e-9 * max(abs(value), 1e-30):
                return symbol, value
        return None


class _Ready:
    """A problem with its equations, made ready as they are needed."""

    def __init__(self, data: Carriable) -> None:
        self.data = data
        self._parts: dict[tuple[str, tuple[str, ...]], _Part] = {}
        self._units: dict[tuple[str, str], float] = {}

    def part(self, case: str, vectors: tuple[str, ...] = ()) -> _Part | None:
        """The equations of a case, with letters for the components of some finds."""
        if (case, vectors) not in self._parts and case in self.data.equations:
            plain = _Part(self.data.equations[case]) if not vectors else self.part(case)
            assert plain is not None
            self._parts[case, vectors] = _Part(with_own(plain.replay, vectors)) if vectors else plain
        return self._parts.get((case, vectors))

    def asks(self, case: str, find: str) -> bool:
        """Does a find follow from the equations of a case?"""
        equations = self.data.equations.get(case)
        return self.data.cases[find] == case and equations is not None and find in equations.asked

    def unit(self, find: str, kind: str) -> float:
        """What a find is counted in, in base units of the problem: its unit, or for a formula that of SI."""
        if (find, kind) not in self._units:
            one = parse_unit(self.data.units[find])
            self._units[find, kind] = in_base(one, self.data.us) / (
                in_base(one, us=False) if kind == "formula" else 1.0
            )
        return self._units[find, kind]

    def input_units(self, find: str) -> Mapping[str, float]:
        """What the base units of the inputs behind a find are in SI units."""
        equations = self.data.equations.get(self.data.cases[find])
        if equations is None or not self.data.us:
            return {}
        units = {name: equations.units[s] for name, s in equations.inputs.items() if s in equations.units}
        return {name: in_base(unit, us=False) / in_base(unit, us=True) for name, unit in units.items()}


class Carrier:
    """Carries own values through the problems of a set, by their names."""

    def __init__(self, problems: Mapping[str, Carriable]) -> None:
        self.problems = dict(problems)
        self._ready: dict[tuple[str, int], _Ready] = {}
        self._again: dict[tuple[str, int], Again] = {}

    def ready(self, problem: str, variant: int) -> _Ready | None:
        """A problem as a variant has it; None: nothing is carried in it."""
        data = self.problems.get(problem)
        if data is None:
            return None
        # Where the variants have the same equations, they are made ready once.
        key = problem, variant if variant in data.of_variants else -1
        if key not in self._ready:
            self._ready[key] = _Ready(data.at(variant))
        return self._ready[key]

    def again(self, task: Task, variant: int) -> Again | None:
        """The motions of a problem that are followed in numbers, to be followed again; None: it has none."""
        data = self.problems.get(task.problem)
        if data is None or data.followed is None:
            return None
        key = task.problem, variant
        if key not in self._again:
            right = {e.find: e.values for e in task.expected if e.values}
            self._again[key] = Again(data.followed, data.written.get(variant, {}), right)
        return self._again[key]

    def for_variant(self, variant: int) -> CarriedHere:
        """For the submissions of one variant."""
        return CarriedHere(self, variant)


class CarriedHere:
    """The same for one variant."""

    def __init__(self, carrier: Carrier, variant: int) -> None:
        self.carrier, self.variant = carrier, variant

    def __call__(
        self, task: Task, expected: Expected, own: Mapping[str, tuple[float, ...]], way: int = 0
    ) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
        """What a find comes to with own values of earlier finds, in its unit, and which of them it rests on. `way`:
        where more equations than one tell it then, by which; None: by none more.
        """
        problem = self.carrier.ready(task.problem, self.variant)
        if problem is None:
            return None
        right = {e.find: e.values for e in task.expected if e.values}
        try:
            if expected.kind == "formula":
                return _at_places(problem, self.variant, expected, task, own, way)
            numbers = problem.data.values.get(self.variant, {})
            found = _carried(problem, (self.variant, -1), numbers, expected, right, own, way)
        except NoNumber:
            found = None
        again = self.carrier.again(task, self.variant) if found is None and not way else None
        if again is None:
            return found
        return again.find(expected.find, {n: v for n, v in own.items() if n in right and _is_sane(v, right[n])})


Due = tuple[tuple[float, ...], tuple[str, ...]]


def _at_places(
    problem: _Ready, variant: int, expected: Expected, task: Task, own: Mapping[str, tuple[float, ...]], way: int
) -> Due | None:
    """A formula, by its values at places, with own formulas of earlier finds."""
    places = expected.places
    right = {e.find: values_at(e.formula, places) for e in task.expected if e.kind == "formula" and e.places == places}
    values: list[float] = []
    names: tuple[str, ...] = ()
    units = problem.input_units(expected.find)
    for k, place in enumerate(places):
        here = {n: (typed[k],) for n, typed in own.items() if n in right and len(typed) == len(places)}
        due = {n: (numbers[k],) for n, numbers in right.items()}
        known = {n: v / units.get(n, 1.0) for n, v in place}
        try:
            found = _carried(problem, (variant, k), known, expected, due, here, way)
        except NoNumber:
            found = None
        values.append(found[0][0] if found is not None and len(found[0]) == 1 else math.nan)
        names = found[1] if found is not None else names
    return (tuple(values), names) if any(map(math.isfinite, values)) else None


def _carried(
    problem: _Ready,
    key: tuple[int, int],
    given: Mapping[str, float],
    expected: Expected,
    due: Mapping[str, tuple[float, ...]],
    own: Mapping[str, tuple[float, ...]],
    way: int,
) -> Due | None:
    """The find with all own values that it rests on. `key`: of a variant, or of a place of it, with the numbers that
    are `given` there; `due`: the right ones. Formulas have their values in SI units, numbers in the units of finds.
    """
    data, case = problem.data, problem.data.cases[expected.find]
    own = {n: typed for n, typed in own.items() if n in due and _is_sane(typed, due[n])}
    vectors = tuple(n for n, typed in own.items() if len(typed) == 2 and problem.asks(case, n))
    part = problem.part(case, vectors)
    if part is None or expected.find not in part.equations.asked:
        return None

    def in_base_units(find: str, numbers: tuple[float, ...]) -> tuple[float, ...]:
        factor = problem.unit(find, expected.kind)
        return tuple(n * factor for n in numbers)

    def of_key() -> dict[str, float]:
        known = {s.name: n for v in vectors for s, n in own_inputs(part.equations, v, in_base_units(v, due[v])).items()}
        return {n: v for n, v in given.items() if n not in data.own[case]} | known

    inputs, right = part.start(key, of_key)
    factor = problem.unit(expected.find, expected.kind)
    if not part.gives(key, expected, tuple(n * factor for n in due.get(expected.find, ()))):
        return None
    inputs = dict(inputs)
    fixed: Values = {}
    names: list[str] = []
    behind = part.behind(expected.find)
    for name, typed in own.items():
        put_in, held = _as_input(part, data, case, name, in_base_units(name, typed), right)
        if behind.isdisjoint((*put_in, *held)):
            continue
        inputs |= put_in
        fixed |= held
        names.append(name)
    if not names or (way and way >= part.replay.ways(frozenset(fixed))):
        return None
    values = part.single.run(inputs, fixed, right, way)
    numbers = tuple(part.single.of(e, values) / factor for e in part.equations.asked[expected.find].parts)
    fit = all(math.isfinite(n) for n in numbers) and any(numbers)
    return (numbers, tuple(names)) if fit else None


def _as_input(
    part: _Part, data: Carriable, case: str, name: str, numbers: tuple[float, ...], right: Values
) -> tuple[Values, Values]:
    """An own value as inputs of the equations, or as unknowns that are held fast."""
    if len(numbers) == 2:
        asked = part.equations.asked.get(name)
        parts = asked.parts if asked is not None and data.cases[name] == case else ()
        held = {p: n for p, n in zip(parts, numbers, strict=False) if p.is_Symbol}
        return dict(own_inputs(part.equations, name, numbers)), held
    link = part.equations.inputs.get(f"{data.cases[name]}.{name}")
    if link is not None:
        return {link: numbers[0]}, {}
    unknown = part.unknown_of(name, numbers[0], right) if data.cases[name] == case else None
    return {}, dict((unknown,)) if unknown is not None else {}


def _is_sane(values: tuple[float, ...], due: tuple[float, ...]) -> bool:
    """Zero, or a value of quite another size, may make anything come out."""
    size, right = math.hypot(*values), math.hypot(*due)
    return len(values) == len(due) and bool(size) and bool(right) and 1 / FAR < size / right < FAR


def unpickled(carrying: Mapping[str, bytes]) -> dict[str, Carriable]:
    """What carrying errors needs of each problem: bytes that this program has written itself, never a file."""
    return {name: pickle.loads(data) for name, data in carrying.items()}
