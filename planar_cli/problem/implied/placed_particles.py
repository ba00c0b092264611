"""Free particles on a fixed surface, where the relations of the start put them: `x(P) = 2 m` on `y: x^2/(4 m)`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from planar_cli.problem.language.expression import Name, Quantity, Relation, Side
from planar_cli.problem.language.walk import changed, walk
from planar_cli.problem.scene.scene import At, Body, Curve, Line, Particle, Point, Problem, Surface, TwoFacts

AXES = ("x", "y")


def with_placed_particles(problem: Problem) -> Problem:
    """The problem with every free particle drawn that lies on a surface and whose place the start tells by known
    numbers: by both coordinates, by one along a line, by x on a curve y(x).
    """
    bodies, points = list(problem.bodies), list(problem.points)
    for i, body in enumerate(bodies):
        surface = _under(problem, body)
        if surface is None:
            continue
        place = _place(surface, dict(_told(problem, body.name)))
        if isinstance(place, TwoFacts):
            points.append(Point(body.name, place, body.mark))
            bodies[i] = replace(body, shape=Particle(body.name))
        elif place is not None:
            bodies[i] = replace(body, shape=Particle(place))
    return replace(problem, bodies=tuple(bodies), points=tuple(points))


def _under(problem: Problem, body: Body) -> Surface | None:
    """The fixed surface on which a free particle lies."""
    if not isinstance(body.shape, Particle) or body.shape.place is not None:
        return None
    fixed = {s.name: s for s in problem.surfaces if s.body is None}
    for joint in problem.joints:
        along = getattr(joint, "along", None)
        between = [*getattr(joint, "between", ()), getattr(joint, "point", ""), getattr(along, "name", along)]
        found = [fixed[n] for n in between if isinstance(n, str) and n in fixed]
        if not joint.strikes and body.name in between and found:
            return found[0]
    return None


def _told(problem: Problem, name: str) -> Iterator[tuple[str, Side]]:
    """The coordinates that the start gives by names that are known: (`x`, value)."""
    start = problem.instant if problem.instant is not None else problem.states[0].relations if problem.states else ()
    known = {s.name for s in (*problem.given, *problem.symbols)} | {"pi", "g"}
    for relation in start:
        if not isinstance(relation, Relation) or relation.operator != "=":
            continue
        for left, right in ((relation.left, relation.right), (relation.right, relation.left)):
            if isinstance(left, Quantity) and left.things == (name,) and left.at is None and _known(right, known):
                parts = tuple(p.kind for p in left.parts)
                axis = left.word if not parts else parts[0] if left.word == "r" and len(parts) == 1 else ""
                if axis in AXES:
                    yield axis, right


def _known(side: Side, known: set[str]) -> bool:
    """Is it made of numbers and known names alone?"""
    return all(not isinstance(n, Quantity) and (not isinstance(n, Name) or n.name in known) for n in walk(side))


def _place(surface: Surface, told: dict[str, Side]) -> At | TwoFacts | None:
    """None: the start does not tell it, or two places fit."""
    x, y, shape = told.get("x"), told.get("y"), surface.shape
    if x is not None and y is not None:
        return At(x, y)
    if x is None and y is None:
        return None
    if isinstance(shape, Line):
        return TwoFacts(x, y, ((shape.through, shape.angle),), (), None)
    if isinstance(shape, Curve) and shape.kind == "y" and x is not None:
        return At(x, _with_x(shape.formula, x))
    return None


def _with_x(formula: Side, x: Side) -> Side:
    """The formula of a curve with a value for its variable."""
    return changed(formula, lambda node: x if isinstance(node, Name) and node.name == "x" else None)
