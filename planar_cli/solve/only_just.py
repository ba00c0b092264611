"""States at which a joint presses no more for an instant, as at the top of a loop that is only just run round."""

from __future__ import annotations

from planar_cli.problem.language.expression import Number, Quantity, Relation
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.run import Run
from planar_cli.solve.taken import Taken

AT_A_TOUCH = 1e-5
"""A push that only comes to nought is lost so early: it grows with the square of the time, and the root of this."""


def only_just(problem: Problem, run: Run, taken: Taken) -> str:
    """The state at which the joint that failed does not press any more, where it failed as that state was reached."""
    outcome, t1 = run.trajectory.outcome, run.trajectory.t1
    for state in problem.states:
        nil = any(_is_nil(r, outcome.joint) for r in state.relations if isinstance(r, Relation))
        if nil and abs(taken.times.get(state.name, 0.0) - t1) <= AT_A_TOUCH * t1:
            return state.name
    return ""


def _is_nil(relation: Relation, joint: str) -> bool:
    """Does it say that a joint does not press?"""
    push, other = relation.left, relation.right
    told = isinstance(push, Quantity) and push.word == "N" and push.things[:1] == (joint,)
    return told and relation.operator == "=" and isinstance(other, Number) and other.value == 0
