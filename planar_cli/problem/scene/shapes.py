"""What the shape of a body tells of itself."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from planar_cli.problem.scene.scene import Body, Circle, Line, Outline, Particle, Problem, Rod, Round, Sector


def closest_first(bodies: Iterable[Body]) -> list[Body]:
    """Bodies in the order in which they claim a point: a particle is nothing but its point, so it comes first."""
    return sorted(bodies, key=lambda body: not isinstance(body.shape, Particle))


def rim_of(shape: Any) -> Round | None:
    """The rim of a wheel, whether its mass centre is in the middle or not; None: it is none."""
    rim = shape.rim if isinstance(shape, Outline) else shape
    return rim if isinstance(rim, Round) else None


def own_points(shape: Any) -> tuple[str, ...]:
    """The points by which a shape is drawn and which move with it."""
    match shape:
        case Particle():
            return (shape.place,) if isinstance(shape.place, str) else ()
        case Rod():
            return (shape.start, shape.end) if shape.end else (shape.start,)
        case Outline(center=center, rim=rim):
            return tuple(name for name in (center, rim.center if rim else None) if name)
        case Round():
            return (shape.center,) if shape.center else ()
        case Sector():
            return (shape.apex,)
    pieces = getattr(shape, "pieces", None)
    if pieces is not None:
        return tuple(p for piece in pieces for p in own_points(piece.shape))
    return (shape.center,)


def drawn_by(body: Body) -> tuple[str, ...]:
    """The points by which a body of no particular shape is drawn; of any other body none."""
    if not isinstance(body.shape, Outline) or body.shape.rim is not None:
        return ()
    return tuple(dict.fromkeys((*own_points(body.shape), *body.points)))


def fixed_points(problem: Problem) -> frozenset[str]:
    """The points of bodies that joints keep in their places on the ground all the time."""
    return frozenset(p for joint in problem.joints if (p := joint.fixes()) is not None)


def attached(problem: Problem) -> Iterator[tuple[str, str]]:
    """Points with what carries them: as joints and loads tell, and of surfaces on bodies those that nothing else has.

    A bowl cut in a cart moves with it, and so does its centre, though no one lists that among the points of the cart.
    """
    taken = {p for body in problem.bodies for p in (body.name, *own_points(body.shape), *body.points)}
    for member in (*problem.joints, *problem.loads):
        for point, partner in member.attachments():
            taken.add(point)
            yield point, partner
    for surface in problem.surfaces:
        shape = surface.shape
        through = shape.center if isinstance(shape, Circle) else shape.through if isinstance(shape, Line) else ""
        if surface.body is not None and through and through not in taken:
            yield through, surface.body
