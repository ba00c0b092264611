"""Angles in a drawing, each from its zero: one that the file writes as ±90°·k ± x is drawn as x from that axis."""

from __future__ import annotations

import math
from collections.abc import Iterator

import sympy as sp

from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.figures.drawn import TINY, Drawn, size_of
from planar_cli.problem.language.expression import Binary, Name, Negate, Number, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.scene import GROUND, Rod
from planar_cli.report.document.blocks import Name as Letter
from planar_cli.report.document.blocks import line
from planar_cli.report.document.marks import Angle, Spot

RIGHT = math.pi / 2
NEAR = 1e-6
CIRCLE = " on its circle"


def angle_from_its_zero(drawn: Drawn, vertex: Spot, side: Side) -> Iterator[Angle]:
    """An angle of the file; not a number of right angles, which is seen."""
    zero, sense, rest = _zero(drawn, side)
    size = drawn.length(rest)
    if size is None or not (words := size_of(rest, size)):
        return
    turned = math.remainder(sense * size, 2 * math.pi)
    lettered = any(isinstance(node, Name) for node in walk(rest))
    if abs(turned if lettered else math.remainder(turned, RIGHT)) > NEAR:
        yield Angle(vertex, zero, turned, words)


def _zero(drawn: Drawn, side: Side) -> tuple[float, int, Side]:
    """The direction from which an angle counts, +1 counterclockwise or -1, and the angle."""
    if isinstance(side, Binary) and side.operator in "+-":
        minus = -1 if side.operator == "-" else 1
        for number, sense, rest, way in ((side.left, 1, side.right, minus), (side.right, minus, side.left, 1)):
            size = drawn.length(number) if _is_number(number) else None
            if size is not None and abs(math.remainder(size, RIGHT)) < NEAR:
                return sense * size, way, rest
    return 0.0, 1, side


def _is_number(side: Side) -> bool:
    return isinstance(side.operand if isinstance(side, Negate) else side, Number)


def angles_of_coordinates(drawn: Drawn) -> Iterator[Angle]:
    """The angles by which a page tells how a rod, or the radius to a particle, stands: from the x axis."""
    moves = drawn.scene.displacement.coordinates if drawn.scene.displacement is not None else ()
    for c in moves:
        vertex, size = _vertex(drawn, c), drawn.number(c.symbol)
        turned = math.remainder(size, 2 * math.pi) if size is not None else 0.0
        if vertex is not None and abs(turned) > TINY:
            # Drawn clockwise, the angle between the axis and the rod is -θ.
            yield Angle(vertex, 0.0, turned, line("-" if turned < 0 else "", Letter(c.symbol.name)))


def _vertex(drawn: Drawn, c: Coordinate) -> Spot | None:
    """Where a coordinate is seen as an angle from the x axis; None: it is none."""
    scene = drawn.scene
    body = scene.bodies.get(c.body)
    if body is None or c.unit != "rad":
        return None
    if isinstance(body.shape, Rod):
        same = sp.sympify(body.theta - c.symbol) == 0
        return drawn.carried(c.body, body.shape.start) if same else None
    if c.words.endswith(CIRCLE):
        places = (getattr(j, "between", ()) for j in scene.problem.joints)
        pivots = (n for pair in places if c.body in {scene.owner(p) for p in pair if p in scene.points} for n in pair)
        fixed = next((n for n in pivots if n in scene.points and scene.owner(n) == GROUND), None)
        return drawn.spot(scene.points[fixed]) if fixed is not None else None
    return None
