"""What the states of a motion say of equilibria beside it, `y = y @ rest - 5 cm`: these are found first, as numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from typing import Protocol

from planar_cli.base_units import in_base
from planar_cli.motion.regime.model import Model
from planar_cli.motion.trajectory.automaton import Start
from planar_cli.problem.checks.check_dimensions import Kinds
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.language.dimensions import dimension_of
from planar_cli.problem.language.expression import (
    Extreme,
    Function,
    Grouped,
    Name,
    Number,
    Quantity,
    Relation,
    Side,
    Statement,
)
from planar_cli.problem.language.walk import changed, names_of_states
from planar_cli.problem.scene.order_of_states import stands_beside
from planar_cli.problem.scene.scene import Problem
from planar_cli.simulate.measures import Measures, Moment
from planar_cli.units import default_unit


class Scene(Protocol):
    """A scene ready to be followed, and where its motion begins."""

    @property
    def model(self) -> Model: ...
    @property
    def start(self) -> Start: ...


def with_balanced(problem: Problem, prepared: Callable[[Problem], Scene]) -> Problem:
    """The problem whose states have numbers where they speak of equilibria beside the motion."""
    beside = {s.name: s for s in problem.states if stands_beside(s, problem.states)}
    moving = [s for s in problem.states if s.name not in beside]
    spoken = {name for s in moving for r in s.relations for name in names_of_states(r)} & beside.keys()
    if not spoken:
        return problem
    kinds = Kinds(Scope(problem, ()))
    measures = {name: _measured(prepared(replace(problem, states=(beside[name],))), name) for name in spoken}

    def number(side: Side) -> Side | None:
        at = getattr(side, "at", None)
        if not isinstance(at, str) or at not in measures:
            return None
        value = measures[at].number(_there(side), measures[at].moments[at])
        kind = dimension_of(side, kinds.of)
        assert kind.dimension is not None
        unit = default_unit(kind.dimension, kind.angle, problem.us)
        text = None if unit.text == "1" else unit.text
        return Number(Fraction(value / in_base(unit, problem.us)), text, 1, side.mark)

    def told(statement: Statement) -> Statement:
        match statement:
            case Relation():
                return replace(statement, left=changed(statement.left, number), right=changed(statement.right, number))
            case Extreme():
                return replace(statement, side=changed(statement.side, number))
        return statement

    states = (s if s.name in beside else replace(s, relations=tuple(map(told, s.relations))) for s in problem.states)
    return replace(problem, states=tuple(states))


def _there(side: Side) -> Side:
    """What stands before `@ state`."""
    match side:
        case Grouped():
            return side.operand
        case Name() | Quantity() | Function():
            return replace(side, at=None)
    return side


def _measured(scene: Scene, name: str) -> Measures:
    """The measures of an equilibrium."""
    model, start = scene.model, scene.start
    return Measures(model, {name: Moment(model.regime(), {}, start.t, start.y)})
