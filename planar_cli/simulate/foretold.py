"""States whose relations speak of states that are reached later, such as 95 % of the speed at t = infinity."""

from __future__ import annotations

import math

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.motion.regime.model import Model
from planar_cli.problem.language.expression import Extreme, Name, Relation
from planar_cli.problem.language.walk import names_of_states, walk
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.simulate.measures import Moment
from planar_cli.simulate.timetable import is_time

SAME = 1e-6
"""What is known beforehand agrees with what is reached to this part of its scale."""


def spoken_before(problem: Problem) -> dict[str, set[str]]:
    """Of which later states the relations of a state speak, by the state's name. A state beyond those that are looked
    for is later, too.
    """
    order = {state.name: math.inf if _endless(state) else k for k, state in enumerate(problem.states)}
    found: dict[str, set[str]] = {}
    for state in problem.states[1:]:
        sides = [s.side if isinstance(s, Extreme) else s for s in state.relations if isinstance(s, Relation | Extreme)]
        spoken = {n for side in sides for n in names_of_states(side)}
        later = {n for n in spoken - {state.name} if order.get(n, math.inf) > order[state.name]}
        if later:
            found[state.name] = later
    return found


def demand_unchanged(problem: Problem, model: Model, name: str, before: Moment, reached: Moment | None) -> None:
    """NoSolution: a state is another one when the states that speak of it are looked for, too."""
    half, scale = model.layout.count, model.scale
    state = next(s for s in problem.states if s.name == name)
    if reached is not None:
        speeds = zip(before.y[half:], reached.y[half:], scale[half:], strict=True)
        same = all(abs(a - b) <= SAME * s for a, b, s in speeds)
        if same and (_endless(state) or abs(before.t - reached.t) <= SAME * model.time_scale):
            return
    text = f"the state {name} is another one than what states before it say of it"
    raise NoSolution([Diagnostic(state.mark, "PL704", text, "list the states in the order in which they happen")])


def _endless(state: State) -> bool:
    """Is a state at t = infinity?"""
    times = [s for s in state.relations if isinstance(s, Relation) and is_time(s)]
    return any(isinstance(node, Name) and node.name == "infinity" for s in times for node in walk(s))
