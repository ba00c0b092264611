"""The ground that a body touches, `between: [wheel, ground]`: a horizontal floor through the point where they touch.

Only in a plane where down is told; a wheel touches the floor with its lowest point (a stepped one may stand on a rail
with its hub), a plate that is drawn upright with the middle of its lower edge, else with its lowest corner, a rod with
its lower end, a particle where it is.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from planar_cli.errors import Mark
from planar_cli.joints.base import Joint
from planar_cli.problem.language.expression import Binary, Number, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.nodes.reading import Report
from planar_cli.problem.scene.scene import (
    GROUND,
    At,
    Body,
    Line,
    Outline,
    Particle,
    Place,
    Plate,
    Point,
    Polar,
    Rod,
    Round,
    Surface,
    Tip,
)
from planar_cli.records import record


@record
class Floor:
    """What a file says of the ground before the joints are read for it."""

    plane: str | None
    """`vertical`, `horizontal` or None."""
    name: str
    """What the floor is called: a name that is free."""
    points: Iterator[str]
    """Free names for points."""


@record
class Standing:
    """The joints with the floor where a body touches the ground."""

    joints: tuple[Joint, ...]
    """All of the file."""
    surfaces: tuple[Surface, ...]
    """The floor, if there is one."""
    points: tuple[Point, ...]
    """Those that are new."""


def with_floor(
    joints: tuple[Joint, ...], bodies: tuple[Body, ...], points: tuple[Point, ...], floor: Floor, report: Report
) -> Standing:
    """What changes where a body touches the ground. Reported where the ground may be something else."""
    reading = _Reading({b.name: b for b in bodies}, {p.name: p.place for p in points}, floor, report)
    first = [reading.joint(joint) if joint.touches else joint for joint in joints]
    read = tuple(reading.met(joint) if joint.strikes else joint for joint in first)
    return Standing(read, tuple(reading.surfaces), tuple(reading.points))


class _Reading:
    """One file: the floor and the points found so far."""

    def __init__(self, bodies: dict[str, Body], places: dict[str, Place], floor: Floor, report: Report) -> None:
        self.bodies, self.places, self.floor, self.report = bodies, places, floor, report
        self.surfaces: list[Surface] = []
        self.points: list[Point] = []

    def joint(self, joint: Joint) -> Joint:
        """A joint that touches, with the floor for the ground."""
        touching: Any = joint
        others = [name for name in touching.between if name != GROUND]
        body = self.bodies.get(others[0]) if len(others) == 1 else None
        if body is None or len(touching.between) != 2:
            return joint
        at = touching.at
        if self.floor.plane == "horizontal":
            self._refuse(joint, body, at, "in a horizontal plane the ground is no floor")
            return joint
        at = at or self._lowest(body, joint.mark)
        if not at:
            self._refuse(joint, body, at, f"the point where {body.name} touches it is open")
            return joint
        if not self.surfaces:
            name, line = self.floor.name, Line(at, Number(Fraction(0), "deg", 1, joint.mark))
            self.surfaces.append(Surface(name, line, None, None, joint.mark, inferred=True))
        found: Joint = replace(touching, at=at, between=self._renamed(touching.between))
        return found

    def met(self, joint: Joint) -> Joint:
        """A joint that acts where its partners strike each other: on the floor of another joint."""
        striking: Any = joint
        others = [name for name in striking.between if name != GROUND]
        body = self.bodies.get(others[0]) if len(others) == 1 and len(striking.between) == 2 else None
        if body is None:
            return joint
        if not self.surfaces and striking.at and striking.normal is not None:
            self._refuse_edge(joint, body, striking.at)
            return joint
        if not self.surfaces:
            self._refuse(joint, body, "", "the file does not say where the ground is")
            return joint
        found: Joint = replace(striking, between=self._renamed(striking.between))
        return found

    def _renamed(self, between: tuple[str, ...]) -> tuple[str, ...]:
        return tuple(self.floor.name if name == GROUND else name for name in between)

    def _refuse(self, joint: Joint, body: Body, at: str, why: str) -> None:
        floor, there = self.floor.name, f", at: {at or 'P'}" if joint.touches else ""
        hint = (
            f"declare what it touches: `surfaces: {{{floor}: {{through: {at or 'P'}, angle: 0 deg}}}}` and "
            f"`between: [{body.name}, {floor}]{there}`"
        )
        self.report.add(joint.mark, "PL535", f"the {joint.kind} of {body.name} and the ground: {why}", hint)

    def _refuse_edge(self, joint: Joint, body: Body, at: str) -> None:
        """A fixed point that is struck along a stated normal is a body of its own, which the ground holds."""
        text = f"the {joint.kind} of {body.name} and the ground: a fixed edge at {at} is written as a particle"
        hint = (
            f"`bodies: {{edge: {{particle: {at}}}}}`, `joints: - weld: {{at: {at}, between: [edge, ground]}}`, and "
            f"`between: [{body.name}, edge]` here"
        )
        self.report.add(joint.mark, "PL535", text, hint)

    def _lowest(self, body: Body, mark: Mark) -> str:
        """The point with which a body stands on a floor: its name, or ""."""
        down = Number(Fraction(-90), "deg", 1, mark)
        match body.shape:
            case Particle(place=None):
                return ""
            case Particle(place=place):
                return place if isinstance(place, str) else body.name
            case (
                Round(center=center, radius=radius, hub=hub) | Outline(rim=Round(center=center, radius=radius, hub=hub))
            ):
                rim = radius if hub is None else self._lower_rim(center, radius, hub)
                return self._point(Polar(center, rim, down), mark)
            case Plate(center=center, height=height, angle=angle) if _is_zero(angle):
                half = Binary("/", height, Number(Fraction(2), None, 1, mark), mark)
                return self._point(Polar(center, half, down), mark)
            case Plate() as plate:
                return self._point(Tip(body.name, "", (), plate), mark)
            case Rod(start=start, end=str(end)):
                return self._point(Tip(body.name, "", (start, end), None), mark)
        return ""

    def _lower_rim(self, center: str, radius: Side, hub: Side) -> Side:
        """The radius of the step with which a stepped wheel stands: the larger one, on which it stands on any floor;
        the hub where the centre is drawn as high as that, on a rail beside which the wheel reaches lower.
        """
        place = self.places.get(center)
        told = isinstance(place, At) and _alike(place.y, hub) and not _alike(place.y, radius)
        return hub if told else radius

    def _point(self, place: Place, mark: Mark) -> str:
        self.points.append(Point(next(self.floor.points), place, mark))
        return self.points[-1].name


def _alike(one: Side, other: Side) -> bool:
    """Are two sides written in the same way?"""
    parts = ("name", "value", "unit", "operator", "sense")
    first, second = ([(type(n), *(getattr(n, p, None) for p in parts)) for n in walk(side)] for side in (one, other))
    return first == second


def _is_zero(angle: Side | None) -> bool:
    return angle is None or (isinstance(angle, Number) and angle.value == 0)
