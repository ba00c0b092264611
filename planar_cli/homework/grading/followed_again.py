"""Motions that are followed in numbers, followed again with a student's own value: of an earlier find that is one of
their data, or of a place or a velocity at a state from which they go on.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from planar_cli.base_units import in_base
from planar_cli.errors import PlanarError
from planar_cli.homework.variants.literal_data import with_names
from planar_cli.problem.checks.unused import used_names
from planar_cli.problem.language.expression import Name, Quantity, Side
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.nodes.nodes import Node
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import with_first_values, with_values
from planar_cli.problem.structure import problem_of
from planar_cli.records import record
from planar_cli.units import Unit

if TYPE_CHECKING:
    from planar_cli.homework.variants.worked_problem import Part, WorkedProblem
    from planar_cli.simulate.run import Run

Values = Mapping[str, tuple[float, ...]]
MOST = 20_000
"""A motion that takes more evaluations than that is not followed again: a worker follows it for each own value."""
SAME, CLOSE = 1e-5, 1e-9
"""Relative: followed with what is right, a motion gives what is right; a state has the own value."""
ROUNDS, NUDGE = 30, 1e-6
VELOCITIES, PLACES = ("v", "omega", "dot"), ("x", "y", "r", "theta")


@record
class Followable:
    """What following again needs of a problem, fit to cross processes. `units`: of each find; `cases`: in which it
    stands; `read_off`: the finds that come of motions followed in numbers.
    """

    path: str
    node: Node
    us: bool
    units: Mapping[str, Unit]
    cases: Mapping[str, str]
    read_off: frozenset[str]


def followable(problem: WorkedProblem) -> Followable | None:
    """The same of a worked problem; None: no motion of it is followed, or only at great length."""
    parts = [p for p in problem.parts if _is_read_off(p)]
    if not parts:
        return None
    return Followable(
        problem.path,
        problem.node,
        problem.problem.us,
        {f.name: f.unit for _, f in problem.finds},
        {f.name: p.solution.case for p, f in problem.finds},
        frozenset(f.name for p in parts for f in p.solution.found if f.values),
    )


def _is_read_off(part: Part) -> bool:
    """Does a motion that is followed in numbers give a find of it, and at what it may cost once more?"""
    solution = part.solution
    run = solution.followed.run if solution.followed is not None else solution.run
    if run is None or part.problem.symbols or part.problem.unknowns or run.trajectory.work.evaluations > MOST:
        return False
    asked = part.replay.equations.asked if part.replay is not None else {}
    return any(f.values and f.name not in asked for f in solution.found)


def rests_on(problem: WorkedProblem) -> Iterator[tuple[str, str]]:
    """Finds that come of a motion followed in numbers, each with one that may be put into it."""
    found = followable(problem)
    for part, later in problem.finds if found is not None else ():
        if found is None or later.name not in found.read_off:
            continue
        for other, earlier in problem.finds:
            if earlier.values and (
                _link(other.solution.case, earlier.name) in used_names(part.problem)
                or (other is part and _goes_on_from(part.problem, earlier.name, later.name))
            ):
                yield later.name, earlier.name


def _link(case: str, find: str) -> str:
    return f"{case}.{find}"


def _what(problem: Problem, find: str) -> Side | None:
    what = next((f.found.what for f in problem.find if f.name == find), None)
    return what if isinstance(what, Side) else None


def _goes_on_from(problem: Problem, earlier: str, later: str) -> bool:
    """Is the earlier find a place or a velocity at a state, and does the later one ask only of what comes after?"""
    start, what = _state_of(problem, earlier), _what(problem, later)
    order = [s.name for s in problem.states]
    spans = what is None or any(isinstance(n, Quantity) and isinstance(n.at, tuple) for n in walk(what))
    if start is None or what is None or spans:
        return False
    asked = [order.index(name) for name in names_of_states(what) if name in order]
    return bool(asked) and min(asked) > order.index(start)


def _state_of(problem: Problem, find: str) -> str | None:
    """The state at which a find is a place or a velocity; None: it is something else."""
    what = _what(problem, find)
    is_place = isinstance(what, Name) and what.name in {c.name for c in problem.coordinates}
    if not is_place and not (isinstance(what, Quantity) and what.word in (*VELOCITIES, *PLACES)):
        return None
    at = what.at if isinstance(what, Name | Quantity) else None
    return at if isinstance(at, str) and at in {s.name for s in problem.states} else None


class Again:
    """The motions of a problem with the values of one variant, as a file writes them. `right`: numbers of all finds,
    in their units.
    """

    def __init__(self, data: Followable, values: Mapping[str, str], right: Values) -> None:
        self.data, self.right = data, right
        node = with_values(with_names(with_first_values(data.node)), values) if values else data.node
        self._whole, wrong = problem_of(data.path, node, [])
        self._whole = None if wrong else self._whole
        self._known: dict[tuple[str, tuple[tuple[str, tuple[float, ...]], ...]], tuple[float, ...] | None] = {}

    def find(self, name: str, own: Values) -> tuple[tuple[float, ...], tuple[str, ...]] | None:
        """A find with own values of others, and which of these it has in it; None: none of them, or the motion does not
        answer it so.
        """
        problem = self._problem(self.data.cases[name])
        if problem is None or name not in self.data.read_off:
            return None
        put_in = {n: v for n, v in own.items() if self._is_put_in(problem, n, name)}
        if not put_in or not self._gives_what_is_right(name):
            return None
        found = self._answer(problem, name, put_in)
        return None if found is None else (found, tuple(put_in))

    def _is_put_in(self, problem: Problem, earlier: str, name: str) -> bool:
        case = self.data.cases[earlier]
        same = case == self.data.cases[name] and _goes_on_from(problem, earlier, name)
        return same or _link(case, earlier) in used_names(problem)

    def _gives_what_is_right(self, name: str) -> bool:
        problem, due = self._problem(self.data.cases[name]), self.right.get(name, ())
        found = self._answer(problem, name, {}) if problem is not None else None
        return found is not None and len(found) == len(due) and math.dist(found, due) <= SAME * math.hypot(*due)

    def _problem(self, case: str) -> Problem | None:
        whole = self._whole
        return None if whole is None else next((c.problem for c in whole.cases if c.name == case), whole)

    def _answer(self, problem: Problem, name: str, own: Values) -> tuple[float, ...] | None:
        """In its unit."""
        key = name, tuple(own.items())
        if key not in self._known:
            try:
                self._known[key] = self._followed(problem, name, own)
            except PlanarError:
                self._known[key] = None
        return self._known[key]

    def _followed(self, problem: Problem, name: str, own: Values) -> tuple[float, ...] | None:
        from planar_cli.simulate.run import Settings, answered, follow, goes_on

        numbers = {n: self._in_base(n, own.get(n, v)) for n, v in self.right.items()}
        data = {_link(self.data.cases[n], n): v[0] for n, v in numbers.items() if len(v) == 1}
        run = follow(problem, Settings(values=data, estimate=False, balanced=False, check=False, most_steps=MOST))
        states = {n: _state_of(problem, n) for n in own if self.data.cases[n] == self.data.cases[name]}
        for state in (s.name for s in problem.states):
            here = {n: numbers[n] for n, at in states.items() if at == state}
            if here:
                changed = _with_own(run, state, here)
                if changed is None:
                    return None
                run = goes_on(run, state, changed)
        found = next((a for a in answered(run).answers if a.name == name), None)
        if found is None or found.why or not found.values:
            return None
        one = in_base(self.data.units[name], self.data.us)
        return tuple(v / one for v in found.values)

    def _in_base(self, find: str, values: Sequence[float]) -> tuple[float, ...]:
        one = in_base(self.data.units[find], self.data.us)
        return tuple(v * one for v in values)


def _with_own(run: Run, state: str, own: Values) -> tuple[float, ...] | None:
    """Places and velocities at a state at which these finds have own values, in base units: as near to those of the
    motion as the joints allow. None: there are none.
    """
    moment = run.measures.moments[state]
    whats = [replace(w, at=None) for n in own if isinstance(w := _what(run.problem, n), Name | Quantity)]
    functions = [run.measures.function(w, moment.regime) for w in whats]
    kinds = (isinstance(w, Quantity) and w.word in VELOCITIES for w in whats)
    of_rates = np.array([kind for kind, values in zip(kinds, own.values(), strict=True) for _ in values])
    due = np.array([v for values in own.values() for v in values])
    half = len(moment.y) // 2

    def measured(y: Sequence[float]) -> NDArray[np.float64]:
        return np.array([v for function in functions for v in function(moment.t, y)])

    y, size = list(moment.y), float(np.abs(due).max())
    for _ in range(ROUNDS):
        here = measured(y)
        if here.shape != due.shape or not np.isfinite(here).all():
            return None
        if np.abs(here - due).max() <= CLOSE * size:
            return tuple(y)
        slopes = np.zeros((len(due), 2 * half))
        for i in range(2 * half):
            # A velocity is changed by velocities alone, wherever the scene is.
            nudge = NUDGE * (abs(y[i]) or 1.0)
            changed = (measured([*y[:i], y[i] + nudge, *y[i + 1 :]]) - here) / nudge
            slopes[:, i] = np.where(of_rates == (i >= half), changed, 0.0)
        step = np.linalg.lstsq(slopes, due - here, rcond=None)[0]
        y = list(moment.regime.project(moment.t, [a + float(b) for a, b in zip(y, step, strict=True)]))
    return None
