"""Rods of known length of which one end is at no place of the file: the angle of such a rod is a coordinate."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from fractions import Fraction
from itertools import chain, count

from planar_cli.problem.language.expression import Binary, Name, Number, Side
from planar_cli.problem.scene.scene import Body, Point, Polar, Problem, Rod, Symbol


def with_open_ends(problem: Problem) -> Problem:
    """The problem with a place for the open end of each rod, and a coordinate for the angle of the rod, its theta.

    An end that several rods share stays open: their lengths place it, on one of two sides, which the file must say.
    """
    placed = {p.name for p in problem.points} | {b.name for b in problem.bodies}
    shared = Counter(end for b in problem.bodies if isinstance(b.shape, Rod) for end in (b.shape.start, b.shape.end))
    points, coordinates = [*problem.points], [*problem.coordinates]
    for body in problem.bodies:
        rod = body.shape
        if not isinstance(rod, Rod) or rod.length is None or not rod.start or not rod.end:
            continue
        lacking = [end for end in (rod.start, rod.end) if end not in placed]
        if len(lacking) != 1 or shared[lacking[0]] > 1:
            continue
        (end,) = lacking
        angle = _free_name(f"theta_{body.name}", problem)
        coordinates.append(Symbol(angle, None, "deg", body.mark))
        origin = rod.start if end == rod.end else rod.end
        points.append(Point(end, Polar(origin, rod.length, _direction(angle, body, origin == rod.start)), body.mark))
    return replace(problem, points=tuple(points), coordinates=tuple(coordinates))


def _direction(angle: str, body: Body, forward: bool) -> Side:
    """Of the open end from the other one; theta is counted from the first end to the second."""
    name = Name(angle, None, body.mark)
    return name if forward else Binary("+", name, Number(Fraction(180), "deg", 1, body.mark), body.mark)


def _free_name(name: str, problem: Problem) -> str:
    """The name itself, or with a number behind it, where the file uses it."""
    numbers = (*problem.given, *problem.symbols, *problem.unknowns, *problem.coordinates)
    used = {x.name for x in numbers} | {p.name for p in problem.points}
    used |= {b.name for b in problem.bodies} | {s.name for s in problem.surfaces}
    numbered = (f"{name}_{k}" for k in count(1))
    return next(n for n in chain((name,), numbered) if n not in used)
