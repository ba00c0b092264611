"""Where two bodies touch of which the file does not say it: only where the shapes leave no choice.

A particle touches where it is; a round rim, its hub or the arc of a sector at the foot on a straight edge, or on the
line of centres of two; a plate with the middle of the edge that lies flush on another, or else with the corner that
stands on it; a rod with that of its ends which stands on a line.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

from planar_cli.joints.base import Joint
from planar_cli.problem.implied.drawn_directions import DrawnDirections
from planar_cli.problem.implied.rod_ends import standing_end
from planar_cli.problem.language.expression import Side
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.scene.scene import (
    GROUND,
    Body,
    Circle,
    Composite,
    Foot,
    Line,
    Outline,
    Particle,
    Piece,
    Place,
    Plate,
    Point,
    Problem,
    Rims,
    Rod,
    Round,
    Sector,
    Surface,
    Tip,
)
from planar_cli.records import record

HINT = "the point where they touch"
FACES = "the middle of the face with which one stands on the other, such as `at: [0, 0.2 m]`"


@record
class _Straight:
    """An edge through a point: of a rod towards its other end, else at an angle."""

    name: str
    through: str
    angle: Side | None
    towards: str | None


@record
class _Rim:
    center: str
    radii: tuple[Side, ...]


@record
class _Face:
    """A plate, which lies flush on a straight edge or stands on it with a corner."""

    body: str
    plate: Plate


def with_touching_points(
    joints: tuple[Joint, ...],
    bodies: tuple[Body, ...],
    surfaces: tuple[Surface, ...],
    drawn: DrawnDirections,
    names: Iterator[str],
    report: Report,
) -> tuple[tuple[Joint, ...], tuple[Point, ...]]:
    """The joints, each with its point, and the points that are new. Reported where more than one can be meant."""
    shapes: dict[str, Body | Surface] = {s.name: s for s in surfaces} | {b.name: b for b in bodies}
    read: list[Joint] = []
    points: list[Point] = []
    for joint in joints:
        touching: Any = joint
        if not joint.touches or getattr(touching, "at", "given") != "":
            read.append(joint)
            continue
        found = _place([shapes.get(name) for name in touching.between], drawn)
        if isinstance(found, str):
            read.append(replace(touching, at=found))
        elif found is not None:
            points.append(Point(next(names), found, joint.mark))
            read.append(replace(touching, at=points[-1].name))
        elif GROUND not in touching.between:
            faces = all(isinstance(_edge(shapes.get(name)), _Face) for name in touching.between)
            hint = FACES if faces else HINT
            if (wheel := next(filter(None, map(_without_radius, map(shapes.get, touching.between))), None)) is not None:
                hint = f"{hint}; or the `radius` of {wheel}, if it is a wheel: its rim tells where"
            report.add(joint.mark, "PL311", f"the {joint.kind} needs the key 'at'", hint)
            read.append(joint)
        else:
            read.append(joint)
    return tuple(read), tuple(points)


def with_later_meetings(problem: Problem) -> Problem:
    """The problem, in which a rim touches an edge that it meets after the first state where it comes nearest to it."""
    bodies = {b.name for b in problem.bodies}
    touching: list[Any] = [j for j in problem.joints if j.touches and j.during is not None]
    former = {}
    for joint in (j for j in touching if not problem.holds_at_first(j.during)):
        ours = bodies & {*joint.between}
        before = (j.at for j in touching if j.during[1] == joint.during[0] and ours & {*j.between})
        former[joint.at] = next(before, "")

    def later(point: Point) -> Point:
        place = point.place
        if point.name not in former or not isinstance(place, Foot) or not place.radii:
            return point
        return replace(point, place=replace(place, later=True, former=former[point.name]))

    return replace(problem, points=tuple(map(later, problem.points)))


def _place(partners: list[Body | Surface | None], drawn: DrawnDirections) -> Place | str | None:
    """The place of the point, or the name of a particle or of the end of a rod that touches there."""
    for partner in partners:
        if isinstance(partner, Body) and isinstance(partner.shape, Particle):
            return partner.shape.place if isinstance(partner.shape.place, str) else partner.name
    match partners:
        case [Body(shape=Rod() as rod), Surface(shape=Line() as ground)] | [
            Surface(shape=Line() as ground),
            Body(shape=Rod() as rod),
        ] if end := standing_end(rod, ground, drawn):
            return end
    edges = [_edge(partner) for partner in partners]
    match edges:
        case [_Rim() as a, _Rim() as b]:
            return Rims(a.center, a.radii, b.center, b.radii)
        case [_Rim() as rim, _Straight() as line] | [_Straight() as line, _Rim() as rim]:
            return Foot(rim.center, line.through, line.angle, line.towards, rim.radii)
        case [_Face() as face, _Straight() as line] | [_Straight() as line, _Face() as face]:
            return Tip(face.body, line.name, (), face.plate, line.through, line.angle, line.towards)
        case [_Straight(towards=str(end)) as bar, _Straight(towards=None) as line] | [
            _Straight(towards=None) as line,
            _Straight(towards=str(end)) as bar,
        ]:
            return Tip(bar.name, line.name, (bar.through, end), None, line.through, line.angle)
    return None


def _without_radius(partner: Body | Surface | None) -> str | None:
    """The name of a body of which a mass centre alone is told."""
    bare = isinstance(partner, Body) and isinstance(partner.shape, Outline) and not partner.points
    return partner.name if bare and partner is not None else None


def _edge(partner: Body | Surface | None) -> _Rim | _Straight | _Face | None:
    match partner:
        case Body(shape=Composite(pieces)):
            rims = [piece.shape for piece in pieces if isinstance(piece.shape, Round)]
            return _rim(rims[0]) if len(rims) == 1 and not any(map(_has_edges, pieces)) else None
        case Surface(name=name, shape=Line(through=through, angle=angle)):
            return _Straight(name, through, angle, None)
        case Surface(shape=Circle(center=center, radius=radius)):
            return _Rim(center, (radius,))
        case Body(shape=Round() as rim) | Body(shape=Outline(rim=Round() as rim)):
            return _rim(rim)
        case Body(shape=Sector(apex=apex, radius=radius)):
            return _Rim(apex, (radius,))
        case Body(name=name, shape=Plate() as plate):
            return _Face(name, plate)
        case Body(name=name, shape=Rod(start=start, end=str(end))):
            return _Straight(name, start, None, end)
        case Body(name=name, shape=Rod(start=start, angle=angle)) if angle is not None:
            return _Straight(name, start, angle, None)
    return None


def _rim(rim: Round) -> _Rim:
    return _Rim(rim.center, (rim.radius,) if rim.hub is None else (rim.radius, rim.hub))


def _has_edges(piece: Piece) -> bool:
    """May another body touch this part as well as the rim that stands beside it?"""
    return not isinstance(piece.shape, Particle | Round)
