"""States that are told by a mode alone: the first instant at which a joint is in that mode.

The motion tells it: it is where an assumption ends and the modes that follow are those that the state asks for.
"""

from __future__ import annotations

from planar_cli.equation.system.system import mode_of
from planar_cli.problem.language.expression import Relation
from planar_cli.problem.scene.scene import Problem, State


def stated_modes(state: State) -> dict[str, str]:
    """By joint: the mode in which a state says that it is."""
    relations = (r for r in state.relations if isinstance(r, Relation) and r.operator == "=")
    return dict(mode for r in relations if (mode := mode_of(r)) is not None)


def is_dated_by_mode(state: State) -> bool:
    """Does a state say in which mode a joint is, and nothing else that would tell when it is?"""
    others = [r for r in state.relations if not (isinstance(r, Relation) and mode_of(r) is not None)]
    return bool(stated_modes(state)) and all(isinstance(r, Relation) and r.operator != "=" for r in others)


def told_by_modes(problem: Problem) -> bool:
    """Is there such a state beyond the first?"""
    return any(is_dated_by_mode(s) for s in problem.states[1:])
