"""A particle on which only forces to or from one fixed point act is followed in polar coordinates about that point.

Then its angular momentum about the point is r² φ' m, and work and energy hold r alone (An Introduction to Planar
Dynamics, 3.3). The file's own coordinates come first; where it has some, none are added.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields, replace
from fractions import Fraction
from typing import Any

from planar_cli.errors import Mark, NoSolution, Undecided
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import AtRest, Binary, Name, Negate, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import is_endless
from planar_cli.problem.scene.scene import At, Body, Particle, Point, Polar, Problem, State, Symbol
from planar_cli.solve.solved_problem import Solution

QUARTER = {(1, 0): 0, (0, 1): 90, (-1, 0): 180, (0, -1): -90}
"""The direction [degrees] of the axes."""


def best_placed(problem: Problem, solve: Callable[[Problem], Solution]) -> Solution:
    """The solution in polar coordinates, where there are some and they lead to it; else in those of the file.

    Undecided: neither leads to it; what polar coordinates leave open is told, as they leave less open.
    """
    polar = in_polar_coordinates(problem)
    if polar is problem:
        return solve(problem)
    open_still: Undecided | None = None
    try:
        return solve(polar)
    except Undecided as undecided:
        open_still = undecided
    except NoSolution:
        # The way may lead through the fixed point, where it has no direction.
        pass
    try:
        return solve(problem)
    except Undecided:
        if open_still is not None:
            raise open_still from None
        raise


def in_polar_coordinates(problem: Problem) -> Problem:
    """The problem with polar coordinates for what moves about a fixed point; the same object where nothing does."""
    cases = tuple(replace(case, problem=_part(case.problem)) for case in problem.cases)
    found = _part(problem)
    same = found is problem and all(a.problem is b.problem for a, b in zip(cases, problem.cases, strict=True))
    return problem if same else replace(found, cases=cases)


def _part(problem: Problem) -> Problem:
    endless = any(is_endless(s.relations) for s in problem.states)
    if problem.coordinates or endless or not problem.states[1:] or problem.plane == "vertical":
        return problem
    if any(isinstance(r, AtRest) for r in problem.states[0].relations):
        # What starts from rest runs through the point.
        return problem
    for body in problem.bodies:
        found = _placed(problem, body)
        if found is not None:
            problem = _with_polar(problem, body, *found)
    return problem


def _placed(problem: Problem, body: Body) -> tuple[str, Side, Side] | None:
    """The fixed point, and the distance and the direction at which the body begins; None: it has no such point."""
    if not isinstance(body.shape, Particle) or body.shape.place is None:
        return None
    where = body.shape.place
    names = {body.name, where} if isinstance(where, str) else {body.name}
    centre = _centre(problem, names)
    points = {p.name: p.place for p in problem.points}
    about = points.get(centre or "")
    shared = any(_names_in(b.shape) & names or set(b.points) & names for b in problem.bodies if b.name != body.name)
    if centre is None or shared or not isinstance(about, At) or _belongs(problem, centre):
        return None
    place = points.get(where) if isinstance(where, str) else where
    if isinstance(place, Polar) and place.origin == centre:
        return centre, place.distance, place.angle
    found = _from_axes(problem, place, about) if isinstance(place, At) else None
    return None if found is None else (centre, *found)


def _centre(problem: Problem, names: set[str]) -> str | None:
    """The one point through which all that acts on a particle always passes."""
    found: set[str] = set()
    for entry in (*problem.loads, *problem.joints):
        if _names_in(entry) & names:
            through = entry.passes_through(frozenset(names))
            if through is None:
                return None
            found |= {through} if through else set()
    return found.pop() if len(found) == 1 else None


def _names_in(entry: Joint | Load | Any) -> set[str]:
    """All names that an entry holds, whatever they are of."""
    found: set[str] = set()
    waiting = [getattr(entry, f.name) for f in fields(entry)] if hasattr(entry, "__dataclass_fields__") else []
    while waiting:
        value = waiting.pop()
        if isinstance(value, str):
            found.add(value)
        elif isinstance(value, tuple):
            waiting += value
        elif hasattr(value, "__dataclass_fields__") and not isinstance(value, Mark | Number | Name | Binary | Quantity):
            waiting += [getattr(value, f.name) for f in fields(value)]
    return found


def _belongs(problem: Problem, point: str) -> bool:
    """Is a point one of a body?"""
    return any(point in _names_in(b.shape) | set(b.points) for b in problem.bodies)


def _from_axes(problem: Problem, place: At, about: At) -> tuple[Side, Side] | None:
    """Distance and direction of a place that lies beside the fixed point along an axis, where both are plain."""
    if not all(_nothing(s) for s in (about.x, about.y)):
        return None
    for part, other, axis in ((place.x, place.y, (1, 0)), (place.y, place.x, (0, 1))):
        if not _nothing(other):
            continue
        back = isinstance(part, Negate)
        size = part.operand if isinstance(part, Negate) else part
        if isinstance(size, Number) and size.value < 0:
            back, size = not back, replace(size, value=-size.value)
        if _positive(problem, size):
            way = (-axis[0], -axis[1]) if back else axis
            mark = problem.states[0].mark
            return size, Number(Fraction(QUARTER[way]), "deg", 1, mark)
    return None


def _nothing(side: Side) -> bool:
    return isinstance(side, Number) and side.value == 0


def _positive(problem: Problem, side: Side) -> bool:
    """Is a length surely positive, by how it is written?"""
    match side:
        case Number():
            return side.value > 0
        case Name():
            known = next((s for s in problem.given if s.name == side.name), None)
            letter = any(s.name == side.name for s in problem.symbols)
            return letter or (known is not None and known.value is not None and _positive(problem, known.value))
        case Binary():
            return side.operator in "+*/^" and all(_positive(problem, s) for s in (side.left, side.right))
    return False


def _with_polar(problem: Problem, body: Body, centre: str, distance: Side, angle: Side) -> Problem:
    """The body at a distance r and an angle φ, which the first state tells as drawn."""
    r, phi = _free(problem, "r", body), _free(problem, "phi", body)
    mark = problem.states[0].mark
    place = Polar(centre, Name(r, None, mark), Name(phi, None, mark))
    first = problem.states[0]
    begun = tuple(Relation(Name(n, None, mark), "=", s, n, mark) for n, s in ((r, distance), (phi, angle)))
    states: tuple[State, ...] = (replace(first, relations=(*first.relations, *begun)), *problem.states[1:])
    coordinates = (*problem.coordinates, Symbol(r, None, "m", mark, distance=True), Symbol(phi, None, "rad", mark))
    assert isinstance(body.shape, Particle)
    if isinstance(body.shape.place, str):
        points = tuple(_moved(p, body.shape.place, place) for p in problem.points)
        return replace(problem, coordinates=coordinates, points=points, states=states)
    # What is placed by numbers is a point of its body's name.
    placed = replace(body, shape=replace(body.shape, place=body.name))
    bodies = tuple(placed if b.name == body.name else b for b in problem.bodies)
    points = (*problem.points, Point(body.name, place, body.mark))
    return replace(problem, coordinates=coordinates, points=points, bodies=bodies, states=states)


def _moved(point: Point, name: str, place: Polar) -> Point:
    return replace(point, place=place) if point.name == name else point


def _free(problem: Problem, stem: str, body: Body) -> str:
    """A name that nothing of the file has."""
    named: list[Symbol | Point] = [*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates]
    named += problem.points
    taken = {x.name for x in named} | {b.name for b in problem.bodies} | {s.name for s in problem.surfaces}
    taken |= {s.name for s in problem.states} | {f.name for f in problem.find}
    tries = (stem, f"{stem}_{body.name}", *(f"{stem}_{body.name}_{i}" for i in range(99)))
    return next(name for name in tries if name not in taken)
