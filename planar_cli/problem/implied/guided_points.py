"""The point of a guide by a second name: it belongs to the body of which a point stands at that place.

Only what slides can be held by a guide. So where a guide has a point that nothing else uses, and one point of a body
stands there, that body is meant.
"""

from __future__ import annotations

from dataclasses import replace

from planar_cli.problem.checks.scope import Scope, members_of
from planar_cli.problem.implied.drawn_directions import DrawnDirections
from planar_cli.problem.scene.scene import Body, Problem
from planar_cli.problem.scene.shapes import attached, closest_first, own_points

SAME = 1e-12
"""Places that are apart by less than this part of their coordinates are one."""


def with_guided_points(problem: Problem) -> Problem:
    """The problem in which the points of guides that stand where a body has a point are points of that body too."""
    found = {name: body for name in _loose(problem) if (body := _standing_at(problem, name)) is not None}
    if not found:
        return problem
    added = {b.name: tuple(p for p, body in found.items() if body is b) for b in problem.bodies}
    bodies = tuple(replace(b, points=(*b.points, *added[b.name])) if added[b.name] else b for b in problem.bodies)
    return replace(problem, bodies=bodies)


def _loose(problem: Problem) -> list[str]:
    """The points of guides that belong to nothing, and that no other joint or load uses."""
    guides = [j for j in problem.joints if j.kind == "guide" and getattr(j, "point", None)]
    if not guides:
        return []
    owned = {p for b in problem.bodies for p in (b.name, *own_points(b.shape), *b.points)}
    owned |= {point for point, _ in attached(problem)}
    points = {p.name for p in problem.points}
    names = [p for j in guides if (p := str(getattr(j, "point", ""))) in points - owned]
    scope = Scope(problem, ())
    used = {p for m in members_of(problem) if m not in guides for p in scope.mentioned(m)} if names else set()
    return [p for p in dict.fromkeys(names) if p not in used]


def _standing_at(problem: Problem, name: str) -> Body | None:
    """The body of which one point stands at the place of another; None: there is none, or there are several points."""
    drawn = DrawnDirections(problem.given, problem.points, problem.bodies)
    place = drawn.place(name)
    if place is None:
        return None
    size = SAME * max(map(abs, place))
    here: dict[str, Body] = {}
    for body in closest_first(problem.bodies):
        for point in dict.fromkeys((*own_points(body.shape), *body.points)):
            other = drawn.place(point)
            if other is not None and all(abs(a - b) <= size for a, b in zip(place, other, strict=True)):
                here.setdefault(point, body)
    return next(iter(here.values())) if len(here) == 1 else None
