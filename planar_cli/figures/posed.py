"""A scene at one moment of a motion that was followed, for whoever draws bodies and joints."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.carried import Pose
from planar_cli.figures.drawn import AS_WRITTEN, Beside, Drawn
from planar_cli.integrators.base import OUTSIDE
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.terms import Term, ordered
from planar_cli.problem.scene.scene import GROUND, Body


class Posed(Drawn):
    """The position of all bodies at one moment: terms have their numbers there."""

    __slots__ = ("_first", "_numbers", "moving")
    moving: MovingScene
    _numbers: dict[Term, float]
    _first: Posed | None

    def __init__(
        self,
        moving: MovingScene,
        variables: dict[Term, float],
        first: Posed | None = None,
        beside: Beside = AS_WRITTEN,
    ) -> None:
        """`variables`: the coordinates, their rates and the time; `first`: the position in which the motion begins;
        `beside`: what in the scene is not where the file has it.
        """
        object.__setattr__(self, "_first", first)
        object.__setattr__(self, "moving", moving)
        # What draws asks it for points, directions and lengths, as it does a scene of formulas.
        object.__setattr__(self, "scene", moving)
        object.__setattr__(self, "_numbers", dict(variables))
        object.__setattr__(self, "beside", beside)

    def number(self, expr: Any) -> float | None:
        """A term as a number; None: it has none here."""
        if not isinstance(expr, Term):
            value = float(expr)
            return value if math.isfinite(value) else None
        known = self._numbers
        if expr not in known:
            for term in ordered([expr]):
                if term not in known:
                    known[term] = _value(term, known)
        found = known[expr]
        return found if math.isfinite(found) else None

    def at_rest(self) -> Posed:
        return self._first or self

    def body(self, name: str) -> BodyModel | None:
        return next((self.model(b) for b in self.moving.problem.bodies if b.name == name), None)

    def pose(self, body: str | None) -> Pose:
        """Where a body is; of the ground and of particles, no turning."""
        place = self.moving.places.get(body or GROUND)
        if place is None:
            return Pose((0.0, 0.0), 0.0)
        at = self.spot(place.center) or (0.0, 0.0)
        return Pose(at, 0.0 if place.theta is None else self.number(place.theta) or 0.0)

    def model(self, body: Body) -> BodyModel:
        """A body as it is drawn."""
        place, drawn = self.moving.places[body.name], self.moving.drawn[body.name]
        theta: Any = place.theta if place.theta is not None else 0.0
        return BodyModel(body.name, body.shape, drawn.rigid, sp.S.Zero, sp.S.Zero, place.center, "", theta)


def _value(term: Term, known: dict[Term, float]) -> float:
    if term.op == "number":
        return term.value
    args = [known[a] for a in term.args]
    try:
        match term.op:
            case "variable":
                return term.value
            case "+":
                return args[0] + args[1]
            case "*":
                return args[0] * args[1]
            case "/":
                return args[0] / args[1]
            case "**":
                return float(args[0] ** args[1])
        return term.graph.function(term.op)(*args)
    except (*OUTSIDE, TypeError):
        return math.nan


def variables_of(run_layout: Any, t: float, y: Sequence[float]) -> dict[Term, float]:
    """The variables of a state with their values."""
    return {**dict(zip(run_layout.state, y, strict=True)), run_layout.time: t}
