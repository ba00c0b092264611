"""Bodies that would have to change their length: two of their points are written with a coordinate, farther and farther
apart as it grows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.setup import Earlier, Setup
from planar_cli.equation.system.system import Statements
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.problem.checks.unused import coordinates_behind
from planar_cli.problem.scene.scene import Body, Polar, Problem
from planar_cli.problem.scene.shapes import own_points

Pair = tuple[Body, str, str, str]
"""A body, two of its points, and the one coordinate with which these are written."""


def demand_rigid(problem: Problem, earlier: Mapping[str, Earlier]) -> None:
    """NoSolution: in a motion through several positions two points of a body do not keep their distance.

    At one instant a point may be written as it lies then. With several coordinates the body ties one to the other.
    """
    moves = len(problem.states) > 1 or (problem.instant is None and not problem.states and problem.motion)
    pairs = list(_pairs(problem)) if problem.coordinates and moves else []
    if not pairs:
        return
    setup = Setup(problem, Statements.of((), ()), earlier, True)
    wrong = [found for pair in pairs if (found := _stretched(setup.scene, pair)) is not None]
    if wrong:
        raise NoSolution(wrong)


def _pairs(problem: Problem) -> Iterator[Pair]:
    places = {p.name: p.place for p in problem.points}
    for body in problem.bodies:
        slots = [j for j in problem.joints if j.holder() == body.name or body.name in getattr(j, "between", ())]
        sliding = {getattr(j, "point", None) for j in slots} | {getattr(j, "at", None) for j in slots if j.touches}
        names = [p for p in dict.fromkeys((*own_points(body.shape), *body.points)) if p in places and p not in sliding]
        for one, other in combinations(names, 2):
            measured = [getattr(places[p], "origin", None) for p in (one, other) if isinstance(places[p], Polar)]
            behind = coordinates_behind({one, other}, problem)
            if len(behind) == 1 and not {one, other} & set(measured):
                yield body, one, other, min(behind)


def _stretched(scene: Scene, pair: Pair) -> Diagnostic | None:
    body, one, other, name = pair
    reach = scene.point(other) - scene.point(one)
    square, coordinate = sp.sympify(reach.dot(reach)), scene.ledger.symbols[name]
    rate = derivative(square, coordinate)
    rests = scene.rests_on_sought(square.subs(coordinate, scene.valuations[0](coordinate)))
    if rests or any(value.is_zero(rate) for value in scene.valuations):
        return None
    text = f"{one} and {other} are points of {body.name}, and as {name} varies they are not always equally far apart"
    hint = (
        f"write one from the other, such as `{other}: {{from: {one}, distance: l, …}}`, or with a coordinate of its own"
    )
    return Diagnostic(body.mark, "PL625", text, hint)
