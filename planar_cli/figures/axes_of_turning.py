"""An upright axis about which something goes round in space, drawn in the plane through it: a light rod whose
acceleration the file gives as v²/r.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.figures.drawn import Drawn
from planar_cli.problem.language.expression import Binary, Number, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import Problem, Rod
from planar_cli.report.document.blocks import Name, line
from planar_cli.report.document.marks import Dimension, Mark, Polyline, Spot, Symbol

BEYOND = 0.25
"""So far an axis goes on beyond its points, in parts of their distance."""
NEAR = 1e-9


def is_axis(problem: Problem, body: str) -> bool:
    """Is a body no more than such an axis?"""
    return any(b.name == body and isinstance(b.shape, Rod) and b.is_massless for b in problem.bodies) and any(
        _turning(problem, body)
    )


def axis_marks(start: Spot, end: Spot) -> Iterator[Mark]:
    """A chain line, held at both ends."""
    (x, y), (u, v) = start, end
    more = (BEYOND * (u - x), BEYOND * (v - y))
    ends = (x - more[0], y - more[1]), (u + more[0], v + more[1])
    yield Polyline(ends, "chain")
    for at, other in (ends, ends[::-1]):
        yield Symbol("wall", at, math.atan2(other[1] - at[1], other[0] - at[0]))


def radius_marks(drawn: Drawn) -> Iterator[Dimension]:
    """The radius, as far as the file measures it from x = 0."""
    problem = drawn.scene.problem
    for body in problem.bodies:
        if is_axis(problem, body.name):
            for radius in _turning(problem, body.name):
                places = [drawn.named(name) for name in radius.things]
                start = places[1] if len(places) > 1 else (0.0, 0.0)
                if places[0] is not None and start is not None and abs(start[0]) < NEAR < abs(places[0][0]):
                    words = line(Name(f"x_{radius.things[0]}"))
                    yield Dimension((0.0, places[0][1]), places[0], words, side=-1, level=True)


def _turning(problem: Problem, body: str) -> Iterator[Quantity]:
    """The radius r where the acceleration of a body is given by v²/r."""
    for relation in problem.instant or ():
        if not isinstance(relation, Relation) or not isinstance(relation.left, Quantity):
            continue
        left = relation.left
        if left.word == "a" and left.things == (body,):
            for node in walk(relation.right):
                if isinstance(node, Binary) and node.operator == "/" and _is_squared(node.left):
                    yield from (q for q in walk(node.right) if isinstance(q, Quantity) and q.word in ("r", "x"))


def _is_squared(side: Side) -> bool:
    powers = (n for n in walk(side) if isinstance(n, Binary) and n.operator == "^")
    return any(isinstance(p.right, Number) and p.right.value == 2 for p in powers)
