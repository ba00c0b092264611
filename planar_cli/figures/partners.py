"""What the joints and loads of a file say of a drawing: what touches a surface or slides along it, and their signs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from planar_cli.errors import PlanarError
from planar_cli.figures.drawn import Drawn
from planar_cli.joints.base import Joint
from planar_cli.problem.language import expression
from planar_cli.problem.scene.entry import Entry
from planar_cli.problem.scene.scene import Line, Particle, Problem, Surface
from planar_cli.problem.scene.sketches import Hinge, Sketch
from planar_cli.report.document.marks import Spot


def touching(problem: Problem, surface: Surface, joints: Sequence[Joint] | None = None) -> Iterator[str]:
    """The points of the file on a surface: where bodies touch it, and through which it is drawn. `joints`: those of the
    whole file, whenever they hold.
    """
    shape = surface.shape
    if isinstance(shape, Line):
        yield shape.through
    for joint in problem.joints if joints is None else joints:
        if surface.name in between(joint):
            yield from (p for p in (getattr(joint, "at", ""), getattr(joint, "point", "")) if p)
    yield from partners(problem, surface, joints)


def partners(problem: Problem, surface: Surface, joints: Sequence[Joint] | None = None) -> Iterator[str]:
    """The bodies that touch a surface, or slide along it."""
    for joint in problem.joints if joints is None else joints:
        named = between(joint)
        if surface.name in named:
            yield from (p for p in named if p != surface.name)
            point = getattr(joint, "point", None)
            yield from (
                b.name for b in problem.bodies if point and isinstance(b.shape, Particle) and b.shape.place == point
            )


def sliders(problem: Problem, surface: Surface) -> list[str]:
    """The particles that slide along a fixed straight line: blocks that stand on it, not balls that strike it."""
    if surface.body is not None or not isinstance(surface.shape, Line):
        return []
    particles = {b.name for b in problem.bodies if isinstance(b.shape, Particle)}
    joints = [j for j in problem.joints if surface.name in getattr(j, "between", ()) and not j.strikes]
    return [name for j in joints for name in getattr(j, "between", ()) if name in particles]


def is_slot(surface: Surface, joints: Sequence[Joint]) -> bool:
    """Does a point run along a surface, as a pin in a slot?"""
    return any(surface.name in between(j) and getattr(j, "point", "") and not getattr(j, "body", None) for j in joints)


def leads(joint: Joint) -> bool:
    """Does it lead something along a track, and hold it on both sides?"""
    return getattr(joint, "along", None) is not None


def is_lane(problem: Problem, name: str) -> bool:
    """Is a fixed surface a bend of a road, a rail or a groove that is seen from above? What touches it runs along it,
    and nothing in the file falls.
    """
    own = [j for j in problem.joints if name in between(j)]
    fixed = any(s.name == name and s.body is None and not isinstance(s.shape, Line) for s in problem.surfaces)
    return problem.plane != "vertical" and fixed and bool(own) and all(map(leads, own))


def between(joint: Joint) -> tuple[str, ...]:
    """What a joint is between, by name."""
    along = getattr(joint, "along", None)
    track = along if isinstance(along, str) else along.name if isinstance(along, expression.Name) else ""
    named = (*getattr(joint, "between", ()), track, getattr(joint, "body", None))
    return tuple(n for n in named if isinstance(n, str) and n)


def sketch_of(drawn: Drawn, entry: Entry) -> tuple[Sketch, ...]:
    """What a joint or load looks like; nothing where it does not hold yet, or its direction rests on what moves."""
    try:
        return entry.sketch(drawn.scene)
    except PlanarError:
        return ()


def pivot_of(drawn: Drawn, body: str) -> Spot | None:
    """Where a body turns about a fixed pin all the time; None: it does not."""
    for joint in drawn.scene.problem.joints:
        for sketch in sketch_of(drawn, joint) if joint.during is None else ():
            if isinstance(sketch, Hinge) and sketch.grounded and body in sketch.bodies:
                return drawn.spot(sketch.at)
    return None


def only_pushed(drawn: Drawn, point: str) -> bool:
    """Is a point no more than where a force acts, at a place that the file seeks in a case? A body has its shape
    wherever it is pushed.
    """
    problem = drawn.scene.problem
    loaded = any(point == at for load in problem.loads for at, _ in load.attachments())
    held = any(point in (*getattr(j, "path", ()), *_points_of(j)) for j in problem.joints)
    if not loaded or held or any(isinstance(s.shape, Line) and s.shape.through == point for s in problem.surfaces):
        return False
    sought = {u.name for p in (problem, *(c.problem for c in problem.cases)) for u in p.unknowns}
    place = drawn.scene.point(point)
    return any(s.name in sought for part in (place.x, place.y) for s in sp.sympify(part).free_symbols)


def _points_of(joint: Joint) -> tuple[object, ...]:
    return (getattr(joint, "at", ""), getattr(joint, "point", ""), *between(joint))
