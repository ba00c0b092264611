"""The rate of a speed, `a(car).t = 7 ft/s^2`, of what starts from rest on a track that is fixed.

At rest nothing has a direction along its velocity, and both ways along the track are alike. The positive one is taken:
counterclockwise round a circle, along the angle of a line; the other one where an inequality of the first state says
so, `a(car).y < 0`, as a particle at rest is accelerated the way it goes. From then on the velocity has that direction.
"""

from __future__ import annotations

import math
from dataclasses import replace

from planar_cli.problem.drawn_directions import DrawnDirections
from planar_cli.problem.expression import AtRest, Negate, Number, Part, PointPair, Quantity, Relation, Side, Statement
from planar_cli.problem.scene import Circle, Line, Particle, Problem

Parts = tuple[Part, ...]
LEVEL = 1e-9
"""A component below this part of a direction is the rounding of zero."""


def with_ways_from_rest(problem: Problem) -> Problem:
    """The problem in which such laws are told along the track."""
    first = next((s for s in problem.states if not s.before), None)
    if first is None:
        return problem
    motion = list(problem.motion)
    for i, law in enumerate(problem.motion):
        point = _rate_of_speed(law.statement)
        if point is None or not problem.holds_at_first(law.during):
            continue
        names = _names(problem, point)
        way = _way(problem, names, point)
        if way is not None and any(_rests(s, names) for s in first.relations):
            assert isinstance(law.statement, Relation)
            drawn = DrawnDirections(problem)
            # A rate below zero already says that it goes against the positive way.
            grows = all((drawn.number(s) or 0) >= 0 for s in (law.statement.left, law.statement.right))
            against = grows and any(_against(drawn, s, names, way) for s in first.relations)
            motion[i] = replace(law, statement=_along(law.statement, point, way, against))
    return replace(problem, motion=tuple(motion))


def _rate_of_speed(statement: Statement) -> str | None:
    """The point of which one side of an equation is the rate of its speed."""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return None
    return next((p for side in (statement.left, statement.right) if (p := _point(side)) is not None), None)


def _point(side: Side) -> str | None:
    match side:
        case Quantity(word="a", things=(point,), parts=(Part(kind="t"),)):
            return point
        case Quantity(word="dot", argument=Quantity(word="v", things=(point,), parts=(Part(kind="mag" | "t"),))):
            return point
    return None


def _names(problem: Problem, point: str) -> frozenset[str]:
    """The point and the particle that is there."""
    found = {point}
    for body in problem.bodies:
        place = body.shape.place if isinstance(body.shape, Particle) else None
        if isinstance(place, str) and point in (body.name, place):
            found |= {body.name, place}
    return frozenset(found)


def _way(problem: Problem, names: frozenset[str], point: str) -> Parts | None:
    """The positive way along the fixed line or circle on which a point is guided; None: on nothing of the kind."""
    joint = next((j for j in problem.joints if j.guides and getattr(j, "point", None) in names), None)
    along = getattr(joint, "along", None)
    if joint is None or along is None:
        return None
    if not isinstance(along, str):
        return (Part("along", along, joint.mark),)
    surface = next((s for s in problem.surfaces if s.name == along and s.body is None and s.speed is None), None)
    match surface and surface.shape:
        case Line(angle=angle):
            return (Part("along", angle, joint.mark),)
        case Circle(center=center):
            return (Part("across", PointPair(point, center, joint.mark), joint.mark),)
    return None


def _rests(statement: Statement, names: frozenset[str]) -> bool:
    match statement:
        case AtRest(body=body):
            return body is None or body in names
        case Relation(left=Quantity(word="v", things=(point,), parts=(Part(kind="mag" | "t"),)), right=Number(value=0)):
            return statement.operator == "=" and point in names
    return False


def _against(drawn: DrawnDirections, statement: Statement, names: frozenset[str], way: Parts) -> bool:
    """Does an inequality say that it is accelerated against the positive way?"""
    match statement:
        case Relation(left=Quantity(word="a", things=(point,), parts=(part,)), right=Number(value=0)):
            below = statement.operator in ("<", "<=")
        case Relation(left=Number(value=0), right=Quantity(word="a", things=(point,), parts=(part,))):
            below = statement.operator in (">", ">=")
        case _:
            return False
    asked, ahead = drawn.direction(part), drawn.direction(way[0])
    if statement.operator == "=" or point not in names or asked is None or ahead is None:
        return False
    along = asked[0] * ahead[0] + asked[1] * ahead[1]
    if abs(along) <= LEVEL * math.hypot(*asked) * math.hypot(*ahead):
        return False
    return (along > 0) is below


def _along(statement: Relation, point: str, way: Parts, against: bool) -> Relation:
    def read(side: Side) -> Side:
        if _point(side) is not None:
            return Quantity("a", (point,), None, way, None, statement.mark)
        return Negate(side, statement.mark) if against else side

    return replace(statement, left=read(statement.left), right=read(statement.right))
