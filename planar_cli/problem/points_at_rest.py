"""`P at rest` of a point: the particle that it is, or `v(P) = 0` of a point of a larger body."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from planar_cli.problem.expression import AtRest, Number, Quantity, Relation, Statement
from planar_cli.problem.scene import Body, Particle, Point, State


class RestingPoints:
    """The bodies and points of a file, to read what it says of points at rest."""

    def __init__(self, bodies: tuple[Body, ...], points: tuple[Point, ...]) -> None:
        self._particles = {b.shape.place: b.name for b in bodies if isinstance(b.shape, Particle)}
        self._points = {p.name for p in points} - {b.name for b in bodies}

    def states(self, states: tuple[State, ...]) -> tuple[State, ...]:
        return tuple(replace(s, relations=self.statements(s.relations) or ()) for s in states)

    def statements(self, statements: tuple[Statement, ...] | None) -> tuple[Statement, ...] | None:
        return None if statements is None else tuple(map(self._statement, statements))

    def _statement(self, statement: Statement) -> Statement:
        if not isinstance(statement, AtRest) or statement.body not in self._points:
            return statement
        if statement.body in self._particles:
            return replace(statement, body=self._particles[statement.body])
        mark = statement.mark
        speed = Quantity("v", (statement.body,), None, (), None, mark)
        return Relation(speed, "=", Number(Fraction(0), None, 1, mark), statement.text, mark)
