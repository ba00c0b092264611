"""Where the ends of a spring are when it is relaxed, as `relaxed_at` says: coordinates of the file have other values,
or bodies that hang on a pin of the ground have other angles.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol

from planar_cli.errors import Mark, refuse
from planar_cli.problem.expression import Name, Quantity, Relation, Side, Statement
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Problem
from planar_cli.records import record

OR_LENGTH = "or give its `natural_length`"
HINT = (
    "write `relaxed_at: [theta = 30 deg]`, theta a coordinate, or `[theta(b) = 30 deg]`, b on a pin of the ground; "
    f"{OR_LENGTH}"
)


@record
class Relaxed:
    """The relations of `relaxed_at`, sorted."""

    coordinates: Mapping[str, Side]
    """The values of coordinates of the file."""
    turned: Mapping[str, tuple[str, Side]]
    """By the body, its pin on the ground and its angle there."""


class Drawn(Protocol):
    """What is asked of a scene as drawn: exact values or plain numbers."""

    def place_drawn(self, name: str) -> Vec: ...
    def angle_drawn(self, body: str) -> Any: ...
    def angle_at(self, side: Side) -> Any: ...
    def heading_of(self, angle: Any) -> Vec: ...
    def owners_of(self, point: str) -> tuple[str, ...]: ...


def relaxed_at(problem: Problem, relations: Iterable[Statement]) -> Relaxed:
    """The relations, sorted. FileProblem where one is of another kind."""
    coordinates: dict[str, Side] = {}
    turned: dict[str, tuple[str, Side]] = {}
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
            case _:
                text = "a relaxed position is given by its coordinates or by the angle of a body"
                raise refuse(relation.mark, "PL542", text, HINT)
    if coordinates and turned:
        mark = next(r.mark for r in relations)
        raise refuse(
            mark, "PL542", "a relaxed position is given by coordinates or by angles of bodies, not by both", HINT
        )
    return Relaxed(coordinates, turned)


def reach_of(scene: Drawn, found: Relaxed, ends: tuple[str, str], mark: Mark) -> Vec:
    """From one end of the spring to the other, with bodies turned about their pins. FileProblem where an end is on
    another body, which the relations do not place.
    """
    a, b = (_place(scene, found, name, mark) for name in ends)
    return b - a


def _place(scene: Drawn, found: Relaxed, name: str, mark: Mark) -> Vec:
    place, owners = scene.place_drawn(name), scene.owners_of(name)
    body = next((b for b in owners if b in found.turned), None)
    if body is None:
        if owners:
            hint = f"tell the angle of {owners[0]} too, `theta({owners[0]}) = …`, {OR_LENGTH}"
            raise refuse(mark, "PL542", f"where {name} is when the spring is relaxed is open", hint)
        return place
    pin, side = found.turned[body]
    pivot = scene.place_drawn(pin)
    arm, way = place - pivot, scene.heading_of(scene.angle_at(side) - scene.angle_drawn(body))
    turned: Vec = pivot + Vec(arm.x * way.x - arm.y * way.y, arm.x * way.y + arm.y * way.x)
    return turned
