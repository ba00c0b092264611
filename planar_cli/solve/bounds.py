"""The inequality that bounds what is largest or smallest over a constant: the stiffest buffer that still holds.

Where the best value is the last one with which an inequality holds, both sides of that are equal there. The problem
with this equation in the place of the inequality and of the extreme is solved like any other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from planar_cli.problem.language.expression import Extreme, Relation, Statement
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.records import record
from planar_cli.simulate.run import Run
from planar_cli.simulate.shooting import shooting
from planar_cli.simulate.shooting_of_extremes import Best, best_value
from planar_cli.solve.stated_inequalities import false_ones

NEAR = 1e-4
"""The root of the equation is within this part of the last value with which the inequality held."""


@record
class Sought:
    """Numbers of the unknowns [SI], and the problem whose equations give them."""

    problem: Problem
    values: Mapping[str, float]


def best_allowed(problem: Problem, known: Mapping[str, float]) -> Best | None:
    """The best value of the only unknown among those with which all inequalities hold; see `best_value`.

    An inequality chooses among the times at which a state may be; where that bounds nothing, it is a condition on the
    first of them.
    """

    def allowed(run: Run) -> bool:
        return next(false_ones(problem, run), None) is None

    best = best_value(problem, known, allowed)
    less = tuple(replace(s, relations=tuple(r for r in s.relations if not _bounds(s, r))) for s in problem.states)
    if best is not None or less == problem.states:
        return best
    return best_value(replace(problem, states=less), known, allowed)


def _bounds(state: State, statement: Statement) -> bool:
    """Is it an inequality that may bound what is largest or smallest in its state?"""
    sought = any(isinstance(r, Extreme) for r in state.relations)
    return sought and isinstance(statement, Relation) and statement.operator != "="


def at_bound(problem: Problem, best: Best, known: Mapping[str, float]) -> Sought | None:
    """The problem with the inequality that ceases to hold at the best value as an equation; None: it is not that."""
    name = problem.unknowns[0].name
    for bounded in _with_equation(problem):
        roots = shooting(bounded, known) or ()
        near = [r for r in roots if abs(r - best.value) <= NEAR * abs(best.value)]
        if len(near) == 1:
            return Sought(bounded, {name: near[0]})
    return None


def _with_equation(problem: Problem) -> Iterator[Problem]:
    """The problem with each of the inequalities beside an extreme in turn as an equation."""
    for state in problem.states[1:]:
        extreme = next((r for r in state.relations if isinstance(r, Extreme)), None)
        for relation in state.relations if extreme is not None else ():
            if not isinstance(relation, Relation) or not _bounds(state, relation):
                continue
            assert extreme is not None
            text = relation.text.replace(relation.operator, "=", 1)
            kept: list[Statement] = [r for r in state.relations if r is not extreme]
            kept = [replace(r, operator="=", text=text) if r is relation else r for r in kept]
            states = tuple(replace(s, relations=tuple(kept)) if s is state else s for s in problem.states)
            yield replace(problem, states=states, bounded=((extreme.text, text),))
