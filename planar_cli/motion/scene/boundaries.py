"""What the outline of a body or surface is made of: corners, straight edges, circles and curves, wherever it is."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.places import unit_vector
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import (
    GROUND,
    Circle,
    Composite,
    Curve,
    Line,
    Outline,
    Particle,
    Plate,
    Rod,
    Round,
    Sector,
    Shape,
    Surface,
)
from planar_cli.records import record


@record
class Corner:
    """A point."""

    body: str
    place: Vec


@record
class Edge:
    """A straight edge."""

    body: str
    start: Vec
    along: Vec
    """Unit vector."""
    length: Term | None
    """None: it goes on without end."""
    solid: bool
    """The body is to the right of it, as round a plate; else it may be met from either side."""
    depth: Term | None = None
    """How far the opposite edge of a plate is [m]."""


@record
class Rim:
    """A circle; from inside or from outside, as drawn."""

    body: str
    center: Vec
    radius: Term
    hollow: bool
    """May something be inside? A surface or a ring, not a disk."""


@record
class Bow:
    """A curve y(x) or r(theta)."""

    body: str
    surface: Surface
    curve: Curve


Boundary = Corner | Edge | Rim | Bow


def boundaries(scene: Carried, partner: str) -> list[Boundary]:
    """Of a body or a surface; nothing of the ground as a whole."""
    surface = scene.surfaces.get(partner)
    if surface is not None:
        return [_of_surface(scene, surface)]
    if partner == GROUND:
        return []
    return list(_of_shape(scene, partner, scene.drawn[partner].shape))


def _of_surface(scene: Carried, surface: Surface) -> Boundary:
    body = surface.body or GROUND
    match surface.shape:
        case Line(through):
            return Edge(body, scene.carried(body, through), scene.surface_direction(surface), None, False)
        case Circle(center, radius):
            return Rim(body, scene.carried(body, center), scene.value(radius), True)
        case Curve() as curve:
            return Bow(body, surface, curve)
    raise TypeError(type(surface.shape).__name__)


def _of_shape(scene: Carried, body: str, shape: Shape) -> Iterator[Boundary]:
    match shape:
        case Particle():
            yield Corner(body, scene.places[body].center)
        case Round(kind, center, radius):
            yield Rim(body, scene.carried(body, center), scene.value(radius), kind == "ring")
        case Plate():
            yield from _of_plate(scene, body, shape)
        case Rod(start, end):
            first = scene.carried(body, start)
            along = scene.frame(body)
            length = scene.length(scene.arm(body, first)) * 2
            last = scene.carried(body, end) if end is not None else first + along * length
            yield from _of_rod(body, first, last, along, length)
        case Composite(pieces):
            for piece, middle in zip(pieces, scene.drawn[body].centers, strict=True):
                yield from _of_part(scene, body, piece.shape, middle)
        case Sector(apex):
            yield Corner(body, scene.carried(body, apex))
            yield Rim(body, scene.carried(body, apex), scene.value(shape.radius), False)
        case Outline(rim=Round() as rim):
            yield from _of_shape(scene, body, rim)
        case Outline():
            for point, owners in scene.owners.items():
                if body in owners:
                    yield Corner(body, scene.carried(body, point))


def _of_part(scene: Carried, body: str, shape: Shape, center: Vec) -> Iterator[Boundary]:
    """A part of a composite, drawn with its mass centre there: it has neither a place nor a direction of its own."""
    match shape:
        case Particle():
            yield Corner(body, scene.carried_from(body, center))
        case Rod(start):
            first = scene.carried(body, start)
            half = scene.carried_from(body, center) - first
            length = scene.length(half) * 2
            yield from _of_rod(body, first, first + half * 2, half * 2 / length, length)
        case _:
            yield from _of_shape(scene, body, shape)


def _of_rod(body: str, first: Vec, last: Vec, along: Vec, length: Term) -> Iterator[Boundary]:
    yield Corner(body, first)
    yield Corner(body, last)
    yield Edge(body, first, along, length, False)


def _of_plate(scene: Carried, body: str, shape: Plate) -> Iterator[Boundary]:
    graph = scene.graph
    angle = graph.number(0.0) if shape.angle is None else graph.number(scene.sides.value(shape.angle).value)
    along = scene.turned_with(body, unit_vector(graph, angle))
    width, height = scene.value(shape.width), scene.value(shape.height)
    center = scene.carried(body, shape.center)
    # Round the plate counterclockwise, so that its inside is to the left: edges run the other way.
    corner = center + along * (width / 2) + along.turned() * (height / 2)
    way = along.turned()
    for length, depth in ((height, width), (width, height), (height, width), (width, height)):
        yield Corner(body, corner)
        yield Edge(body, corner, -way, length, True, depth)
        corner = corner - way * length
        way = -way.turned()


def boundary_center(scene: Carried, boundary: Boundary) -> Vec:
    """Where it is, to tell on which side of another: a place, a centre, the mass centre of its body."""
    match boundary:
        case Corner():
            return boundary.place
        case Rim():
            return boundary.center
        case Edge() if boundary.length is not None:
            return scene.center(boundary.body)
    return scene.middle()
