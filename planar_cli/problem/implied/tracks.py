"""The way along which a point can only go: its track, the circle about a pivot, a direction that `motion` states."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from planar_cli.problem.language.expression import Function, Part, PointPair, Quantity, Relation, Side
from planar_cli.problem.language.slopes import put_in, slope
from planar_cli.problem.scene.scene import (
    GROUND,
    Body,
    Circle,
    Curve,
    Line,
    Outline,
    Particle,
    Plate,
    Problem,
    Rod,
    Round,
)

Parts = tuple[Part, ...]


def positive_way(problem: Problem, point: str) -> Parts | None:
    """The positive direction of a point's fixed track: along the angle of a line, counterclockwise round a circle or a
    pivot, along a curve the way in which its variable grows; None: it is on nothing of the kind.
    """
    return next(_ways(problem, point), None)


def stated_way(problem: Problem, point: str) -> Parts | None:
    """The direction that `motion` states of a point's velocity, all the time; None: it states none."""
    names = called(problem, point)
    for law in problem.motion:
        if law.during is None and (told := _stated(law.statement, names)) is not None:
            return (Part("along", told, law.statement.mark),)
    return None


def called(problem: Problem, point: str) -> frozenset[str]:
    """All names of a point: its own, and those of the bodies whose mass centre is there."""
    found = {point}
    for body in problem.bodies:
        place = _centre(body)
        if isinstance(place, str) and point in (body.name, place):
            found |= {body.name, place}
    return frozenset(found)


def _centre(body: Body) -> object:
    match body.shape:
        case Particle(place=place):
            return place
        case Round(center=center) | Plate(center=center) | Outline(center=center):
            return center
    return None


def _ways(problem: Problem, point: str) -> Iterator[Parts]:
    names = called(problem, point)
    for joint in problem.joints:
        if joint.guides and joint.during is None:
            yield from _along(problem, joint, names, point)
    for joint in problem.joints:
        between: tuple[str, ...] = getattr(joint, "between", ())
        if joint.kind == "pin" and joint.during is None and GROUND in between:
            owners = {b.name for b in problem.bodies if point in (*_points_of(b), b.name)}
            about: str = getattr(joint, "at", "")
            if owners & set(between) and about not in names:
                yield (Part("across", PointPair(point, about, joint.mark), joint.mark),)


def _stated(statement: Any, names: frozenset[str]) -> Side | None:
    """The direction that a statement gives the velocity of a point."""
    if not isinstance(statement, Relation) or statement.operator != "=":
        return None
    for side, other in ((statement.left, statement.right), (statement.right, statement.left)):
        match side:
            case Quantity(word="v", things=(thing,), parts=(Part(kind="angle"),), at=None) if thing in names:
                return other
    return None


def _points_of(body: Body) -> tuple[str, ...]:
    """The points of a body that its shape and the file name."""
    ends = (body.shape.start, body.shape.end) if isinstance(body.shape, Rod) else (_centre(body),)
    return (*(e for e in ends if isinstance(e, str)), *body.points)


def _along(problem: Problem, joint: Any, names: frozenset[str], point: str) -> Iterator[Parts]:
    """The way along what keeps a point, or a body whose mass centre it is, on a fixed line or curve."""
    between: tuple[str, ...] = getattr(joint, "between", ())
    if {getattr(joint, "point", None), getattr(joint, "body", None)} & names:
        along = joint.along
    elif len(between) == 2 and len(names & set(between)) == 1:
        along = next(b for b in between if b not in names)
    else:
        return
    if not isinstance(along, str):
        yield (Part("along", along, joint.mark),)
        return
    surface = next((s for s in problem.surfaces if s.name == along and s.body is None and s.speed is None), None)
    match surface and surface.shape:
        case Line(angle=angle):
            yield (Part("along", angle, joint.mark),)
        case Circle(center=center):
            yield (Part("across", PointPair(point, center, joint.mark), joint.mark),)
        case Curve(kind="y", formula=formula):
            steep = slope(formula, "x")
            here = Quantity("x", (point,), None, (), None, joint.mark)
            if steep is not None and any(isinstance(b.shape, Particle) for b in problem.bodies if b.name in names):
                yield (Part("along", Function("atan", put_in(steep, "x", here), None, joint.mark), joint.mark),)
