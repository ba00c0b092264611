"""Particles of which speed, tangential and normal acceleration are told, and no direction: they move on the circle that
osculates their path, whose place and direction are free. It is drawn with its tangent along x and its centre above.

a = v̇ e_t + v²/ρ e_n, so that nothing else of the path has a part in the acceleration (An Introduction to Planar
Dynamics, 1.3).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import count

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Name, Number, Part, Quantity, Relation, Side, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import At, Body, Circle, Particle, Point, Polar, Problem, Surface, Symbol
from planar_cli.registry import member

FREE_OF_AXES: dict[str, frozenset[str]] = {"v": frozenset(("mag", "t")), "a": frozenset(("mag", "t", "n"))}
"""The parts of vectors that are the same in all axes."""
CURVED = (("a", ("n",)), ("rho", ()))
"""Quantities of a particle, with their parts, that tell of its curve."""


def with_osculating_circles(problem: Problem) -> Problem:
    """The problem with a circle for every free particle of which nothing is said that depends on axes."""
    if problem.joints or problem.loads or problem.motion or problem.instant is None:
        return problem
    for body in problem.bodies:
        asked = list(_of(body, problem))
        if _is_free(body, problem) and all(map(_same_in_all_axes, asked)) and any(map(_of_curve, asked)):
            problem = _on_circle(problem, body)
    return problem


def _is_free(body: Body, problem: Problem) -> bool:
    """Is it a particle without mass, drawn nowhere or by numbers that nothing else uses?"""
    shape = body.shape
    if not isinstance(shape, Particle) or body.mass or body.weight or body.any_mass or body.points:
        return False
    uses = [n for p in problem.points for n in (getattr(p.place, "origin", None), *getattr(p.place, "ends", ()))]
    return not {body.name, str(shape.place)}.intersection(uses)


def _of(body: Body, problem: Problem) -> Iterator[Quantity]:
    """Everything that is said and asked of a particle or its point."""
    names = {body.name, getattr(body.shape, "place", None)}
    trees = (*(problem.instant or ()), *(find.found.what for find in problem.find))
    return (n for tree in trees for n in walk(tree) if isinstance(n, Quantity) and names & {*n.things})


def _same_in_all_axes(q: Quantity) -> bool:
    kinds = tuple(part.kind for part in q.parts)
    told = q.word == "rho" or (len(kinds) == 1 and {*kinds} <= FREE_OF_AXES.get(q.word, frozenset()))
    return told and len(q.things) == 1


def _of_curve(q: Quantity) -> bool:
    return (q.word, tuple(part.kind for part in q.parts)) in CURVED


def _on_circle(problem: Problem, body: Body) -> Problem:
    """The problem in which one particle is guided on its circle."""
    mark, shape = body.mark, body.shape
    assert isinstance(shape, Particle)
    names = _Names(problem)
    points, bodies, unknowns = [*problem.points], [*problem.bodies], [*problem.unknowns]
    place = shape.place
    if not isinstance(place, str):
        drawn = place or At(_number(0, mark), _number(0, mark))
        place = body.name
        points.append(Point(place, drawn, mark))
        bodies[bodies.index(body)] = replace(body, shape=Particle(place))
    statements, radius = _radius(problem.instant or (), body)
    if radius is None:
        unknowns.append(Symbol(names.free(f"rho_{body.name}"), None, "m", mark, distance=True))
        radius = Name(unknowns[-1].name, None, mark)
        statements.append(_relation(radius, ">", _number(0, mark), mark))
    if not any(
        q.word == "v" for s in statements for q in walk(s) if isinstance(q, Quantity) and q in _of(body, problem)
    ):
        unknowns.append(Symbol(names.free("v"), None, "m/s", mark))
        speed, along = Name(unknowns[-1].name, None, mark), Part("x", None, mark)
        told = _relation(Quantity("v", (body.name,), None, (along,), None, mark), "=", speed, mark)
        statements.append(replace(told, text=f"v({body.name}).x = {speed.name}"))
        statements.append(_relation(speed, ">", _number(0, mark), mark))
    center, path = names.free("C"), names.free("path")
    points.append(Point(center, Polar(place, radius, _number(90, mark, "deg")), mark))
    guide = member("joints", "guide")(name=body.name, during=None, mark=mark, point=body.name, along=path)
    return replace(
        problem,
        points=tuple(points),
        bodies=tuple(bodies),
        unknowns=tuple(unknowns),
        instant=tuple(statements),
        surfaces=(*problem.surfaces, Surface(path, Circle(center, radius), None, None, mark)),
        joints=(*problem.joints, guide),
    )


def _radius(statements: Iterable[Statement], body: Body) -> tuple[list[Statement], Side | None]:
    """The statements without that of the radius of curvature, and its value; None: nothing tells it."""
    left, radius = [], None
    for s in statements:
        value = _value_of_radius(s, body) if radius is None else None
        radius = value or radius
        left += [] if value else [s]
    return left, radius


def _value_of_radius(s: Statement, body: Body) -> Side | None:
    if isinstance(s, Relation) and s.operator == "=":
        for one, other in ((s.left, s.right), (s.right, s.left)):
            mine = isinstance(one, Quantity) and one.word == "rho" and body.name in one.things
            if mine and not any(isinstance(n, Quantity) for n in walk(other)):
                return other
    return None


class _Names:
    """Names that a file does not use."""

    def __init__(self, problem: Problem) -> None:
        numbers = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
        self._taken = {s.name for s in numbers} | {p.name for p in problem.points} | {f.name for f in problem.find}
        self._taken |= {s.name for s in problem.surfaces} | {b.name for b in problem.bodies}

    def free(self, stem: str) -> str:
        found = next(n for k in count() if (n := f"{stem}_{k}" if k else stem) not in self._taken)
        self._taken.add(found)
        return found


def _number(value: int, mark: Mark, unit: str | None = None) -> Number:
    return Number(Fraction(value), unit, 1, mark)


def _relation(left: Side, operator: str, right: Side, mark: Mark) -> Relation:
    return Relation(left, operator, right, "", mark)
