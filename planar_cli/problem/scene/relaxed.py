"""Where the ends of a spring are when it is relaxed, as `relaxed_at` says: coordinates of the file have other values,
bodies that hang on a pin of the ground have other angles, particles at the ends are elsewhere, or the ends are so far
apart.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Protocol

from planar_cli.errors import Mark, refuse
from planar_cli.problem.language.expression import Name, Quantity, Relation, Side, Statement
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Particle, Problem
from planar_cli.records import record

OR_LENGTH = "or give its `natural_length`"
HINT = (
    "write `relaxed_at: [theta = 30 deg]`, theta a coordinate, or `[theta(b) = 30 deg]`, b on a pin of the ground, or "
    f"`[x(P) = 2 m]`, P a particle at its end; {OR_LENGTH}"
)
AXES = ("x", "y")
LEAST = 1e-9
"""A coordinate does not tell where along a guide something is that is nearer to being across it."""


@record
class Relaxed:
    """The relations of `relaxed_at`, sorted."""

    coordinates: Mapping[str, Side]
    """The values of coordinates of the file."""
    turned: Mapping[str, tuple[str, Side]]
    """By the body, its pin on the ground and its angle there."""
    moved: Mapping[str, Mapping[str, Side]]
    """By the particle's point, the coordinates x and y that are told."""
    apart: tuple[frozenset[str], Side] | None
    """Two points, and their distance."""
    called: Mapping[str, str]
    """By the particle, its point; a particle and its point are one place."""
    guides: Mapping[str, Side]
    """By the particle's point, the direction of the straight guide in which it runs."""

    @property
    def by_places(self) -> bool:
        """Do places tell the distance, and not coordinates of the file?"""
        return bool(self.turned or self.moved or self.apart)


class Drawn(Protocol):
    """What is asked of a scene as drawn: exact values or plain numbers."""

    def place_drawn(self, name: str) -> Vec: ...
    def angle_drawn(self, body: str) -> Any: ...
    def value_at(self, side: Side) -> Any: ...
    def heading_of(self, angle: Any) -> Vec: ...
    def owners_of(self, point: str) -> tuple[str, ...]: ...


def relaxed_at(problem: Problem, relations: Iterable[Statement]) -> Relaxed:
    """The relations, sorted. FileProblem where one is of another kind."""
    coordinates: dict[str, Side] = {}
    turned: dict[str, tuple[str, Side]] = {}
    moved: dict[str, dict[str, Side]] = {}
    apart: tuple[frozenset[str], Side] | None = None
    particles = {b.name: b.shape.place for b in problem.bodies if isinstance(b.shape, Particle)}
    called = {name: place if isinstance(place, str) else name for name, place in particles.items()}
    relations = tuple(relations)
    for relation in relations:
        match relation:
            case Relation(left=Name(name=name), operator="=", right=right):
                coordinates[name] = right
            case Relation(left=Quantity(word="theta", things=(body,), parts=(), at=None), operator="=", right=right):
                pins = [
                    at
                    for joint in problem.joints
                    if joint.kind == "pin" and {GROUND, body} <= {*getattr(joint, "between", ())}
                    if (at := getattr(joint, "at", ""))
                ]
                if len(pins) != 1:
                    text = f"{body} does not turn about one pin of the ground: where it is at that angle is open"
                    hint = f"write the place of the spring's end with a coordinate, `relaxed_at: [x = …]`, {OR_LENGTH}"
                    raise refuse(relation.mark, "PL542", text, hint)
                turned[body] = pins[0], right
            case Relation(left=Quantity(things=(thing,), at=None) as left, operator="=", right=right) if _axis(
                left
            ) and (thing in called or thing in called.values()):
                moved.setdefault(called.get(thing, thing), {})[_axis(left)] = right
            case Relation(left=Quantity(word="r", things=(a, b), at=None) as left, operator="=", right=right) if [
                part.kind for part in left.parts
            ] == ["mag"]:
                apart = frozenset((called.get(a, a), called.get(b, b))), right
            case _:
                text = "a relaxed position is given by its coordinates, by the angle of a body or by that of a particle"
                raise refuse(relation.mark, "PL542", text, HINT)
    found = Relaxed(coordinates, turned, moved, apart, called, dict(_guides(problem, called)))
    if (coordinates and found.by_places) or (apart and (turned or moved)):
        mark = relations[0].mark
        raise refuse(mark, "PL542", "a relaxed position is given in one way, by coordinates or by places", HINT)
    return found


def _axis(quantity: Quantity) -> str:
    """The coordinate that a quantity is: `x(P)`, or `r(P).x`; "" for any other."""
    parts = [part.kind for part in quantity.parts]
    axis = quantity.word if not parts else parts[0] if quantity.word == "r" and len(parts) == 1 else ""
    return axis if axis in AXES else ""


def _guides(problem: Problem, called: Mapping[str, str]) -> Iterator[tuple[str, Side]]:
    for joint in problem.joints:
        along = getattr(joint, "along", None)
        if joint.kind == "guide" and isinstance(along, Side):
            names = (getattr(joint, "point", None), getattr(joint, "body", None))
            yield from ((called.get(name, name), along) for name in names if name)


def reach_of(scene: Drawn, found: Relaxed, ends: tuple[str, str], mark: Mark) -> Vec:
    """From one end of the spring to the other, with bodies turned about their pins. FileProblem where an end is on
    another body, which the relations do not place.
    """
    points = [found.called.get(name, name) for name in ends]
    told = found.moved.keys() | (found.apart[0] if found.apart is not None else set())
    if others := sorted(told.difference(points)):
        text = f"where {others[0]} is tells nothing of the spring, whose ends are {ends[0]} and {ends[1]}"
        raise refuse(mark, "PL542", text, HINT)
    if found.apart is not None:
        length = scene.value_at(found.apart[1])
        return Vec(length, 0 * length)
    a, b = (_place(scene, found, name, mark) for name in points)
    return b - a


def _place(scene: Drawn, found: Relaxed, name: str, mark: Mark) -> Vec:
    place, owners = scene.place_drawn(name), scene.owners_of(name)
    point = found.called.get(name, name)
    if point in found.moved:
        return _elsewhere(scene, found, point, place, mark)
    body = next((b for b in owners if b in found.turned), None)
    if body is None:
        if owners:
            hint = f"tell the angle of {owners[0]} too, `theta({owners[0]}) = …`, {OR_LENGTH}"
            raise refuse(mark, "PL542", f"where {name} is when the spring is relaxed is open", hint)
        return place
    pin, side = found.turned[body]
    pivot = scene.place_drawn(pin)
    arm, way = place - pivot, scene.heading_of(scene.value_at(side) - scene.angle_drawn(body))
    turned: Vec = pivot + Vec(arm.x * way.x - arm.y * way.y, arm.x * way.y + arm.y * way.x)
    return turned


def _elsewhere(scene: Drawn, found: Relaxed, point: str, place: Vec, mark: Mark) -> Vec:
    """The place of a particle where its coordinates say; along a straight guide one of them tells the other."""
    told = {axis: scene.value_at(side) for axis, side in found.moved[point].items()}
    if len(told) == len(AXES):
        return Vec(told["x"], told["y"])
    (axis, number), guide = *told.items(), found.guides.get(point)
    way = Vec(0, 0) if guide is None else scene.heading_of(scene.value_at(guide))
    along: Any = getattr(way, axis)
    if _is_nothing(along):
        other = "y" if axis == "x" else "x"
        text = f"where {point} is when the spring is relaxed is open: {axis}({point}) alone tells it on no guide"
        raise refuse(mark, "PL542", text, f"write `{other}({point}) = …` too, {OR_LENGTH}")
    there: Vec = place + way * ((number - getattr(place, axis)) / along)
    return there


def _is_nothing(number: Any) -> bool:
    """Is it zero, but for rounding? What has letters in it is not."""
    try:
        return abs(float(number)) < LEAST
    except TypeError:
        return False
