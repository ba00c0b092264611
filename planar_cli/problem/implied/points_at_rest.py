"""`P at rest` of a point, and a vector that vanishes, `v(P) = 0`, in one way of saying them.

A point that is a particle rests when its body does. Another one has no velocity: two relations where its state begins
the motion; where the motion arrives at the state, the instant at which the magnitude of the vector vanishes.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from planar_cli.problem.language.expression import AtRest, JustAfter, Number, Part, Quantity, Relation, Side, Statement
from planar_cli.problem.scene.scene import Body, Particle, Point, State

VECTORS = frozenset("r v a friction reaction force momentum".split())
"""Quantities of one instant that are vectors."""


class RestingPoints:
    """The bodies and points of a file, to read what it says of points at rest."""

    def __init__(self, bodies: tuple[Body, ...], points: tuple[Point, ...]) -> None:
        self._particles = {b.shape.place: b.name for b in bodies if isinstance(b.shape, Particle)}
        self._particles |= {b.name: b.name for b in bodies if isinstance(b.shape, Particle)}
        self._points = {p.name for p in points} - {b.name for b in bodies}

    def states(self, states: tuple[State, ...]) -> tuple[State, ...]:
        """With instants at which a vector vanishes, in states at which the motion arrives."""
        return tuple(self._state(s, arrives=i > 0) for i, s in enumerate(states))

    def statements(self, statements: tuple[Statement, ...] | None) -> tuple[Statement, ...] | None:
        """With two relations of every point at rest."""
        return None if statements is None else tuple(map(self._statement, statements))

    def _state(self, state: State, arrives: bool) -> State:
        relations = tuple(map(self._statement, state.relations))
        if arrives and not any(isinstance(r, JustAfter) for r in relations):
            relations = tuple(map(self._instant, relations))
        return replace(state, relations=relations)

    def _statement(self, statement: Statement) -> Statement:
        if not isinstance(statement, AtRest) or statement.body not in self._points:
            return statement
        if statement.body in self._particles:
            return replace(statement, body=self._particles[statement.body])
        mark = statement.mark
        speed = Quantity("v", (statement.body,), None, (), None, mark)
        return Relation(speed, "=", Number(Fraction(0), None, 1, mark), statement.text, mark)

    def _instant(self, statement: Statement) -> Statement:
        """`v(P) = 0` as `P at rest` of a particle, any other vector by its magnitude."""
        if not isinstance(statement, Relation) or statement.operator != "=":
            return statement
        for side, other in ((statement.left, statement.right), (statement.right, statement.left)):
            if _is_zero(other) and isinstance(side, Quantity) and side.word in VECTORS and not side.parts:
                body = self._particles.get(side.things[0]) if side.word == "v" and len(side.things) == 1 else None
                if body is not None and side.at is None:
                    return AtRest(body, statement.text, statement.mark)
                return replace(statement, left=replace(side, parts=(Part("mag", None, side.mark),)), right=other)
        return statement


def _is_zero(side: Side) -> bool:
    return isinstance(side, Number) and not side.value
