"""Which way bodies move, where the data of an instant tell it: speeds along their paths count as positive that way."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import Statements
from planar_cli.errors import PlanarError
from planar_cli.problem.language.expression import Negate, Number, Quantity, Relation, Scaled
from planar_cli.problem.scene.facts import Path
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.going import Going

ACROSS = 1e-6
"""A smaller share of a unit vector is none."""


def headings(scene: Scene, statements: Statements) -> Callable[[str, Path], int]:
    """Tells of a body and its path +1 or -1: forward or backward along the tangent; 0 where the data do not tell. What
    moves along an axis keeps the sense of the axis, unless it is asked for in the other one: a(block).along(-90 deg);
    or it goes one way through a whole motion.
    """
    ways: dict[str, Vec] = {}
    wanted = dict(_asked(scene)) if scene.displacement is None and not scene.problem.states else {}
    if scene.displacement is None:
        for relation in (*(r for r, _ in statements.relations), *statements.inequalities):
            for body, way in _told(scene, relation):
                ways.setdefault(body, way)

    going = dict(scene.problem.going)

    def heading(body: str, path: Path) -> int:
        if body in going and path.curvature == 0 and (sense := _sense(scene, path.tangent, going[body])):
            return sense
        if path.curvature == 0 and body in wanted and body not in ways:
            return scene.sign(path.tangent.dot(wanted[body]))
        way = ways.get(body)
        plain = path.curvature == 0 and 0 in (path.tangent.x, path.tangent.y)
        return 0 if way is None or plain else scene.sign(path.tangent.dot(way))

    return heading


def _asked(scene: Scene) -> Iterator[tuple[str, Vec]]:
    """The bodies of which a part along a direction in degrees is asked, with that direction."""
    for find in scene.problem.find:
        q = find.found.what
        if not isinstance(q, Quantity) or q.word not in ("v", "a") or len(q.things) != 1 or len(q.parts) != 1:
            continue
        direction = q.parts[0].direction
        body = q.things[0] if q.things[0] in scene.bodies else scene.owner(q.things[0])
        if q.parts[0].kind == "along" and body in scene.bodies and isinstance(direction, Number | Negate | Scaled):
            angle = scene.value(direction)
            yield body, Vec(sp.cos(angle), sp.sin(angle))


def _told(scene: Scene, relation: Relation) -> Iterator[tuple[str, Vec]]:
    """The body and its direction, where a relation tells them: v(B).y = 600 km/h, v(B).x < 0."""
    q = relation.left
    if not isinstance(q, Quantity) or q.word != "v" or len(q.things) != 1 or len(q.parts) != 1:
        return
    axis = {"x": Vec(sp.S.One, sp.S.Zero), "y": Vec(sp.S.Zero, sp.S.One)}.get(q.parts[0].kind)
    body = q.things[0] if q.things[0] in scene.bodies else scene.owner(q.things[0])
    if axis is None or body not in scene.bodies:
        return
    try:
        size = scene.valuations[0].known(scene.value(relation.right))
    except PlanarError:
        return
    if size is None:
        return
    if relation.operator == "=":
        sign = (size > 0) - (size < 0)
    else:
        sign = 0 if size else 1 if relation.operator in (">", ">=") else -1
    if sign:
        yield body, axis * sign


def _sense(scene: Scene, tangent: Vec, going: Going) -> int:
    """Does something go along a direction, 1, or against it, -1? 0: across it, or the direction is still sought."""
    value = scene.valuations[0]
    x, y = value.known(tangent.x), value.known(tangent.y)
    if x is None or y is None:
        return 0
    along = float(x) * going.x + float(y) * going.y
    return 0 if abs(along) < ACROSS else 1 if along > 0 else -1
