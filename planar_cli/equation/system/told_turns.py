"""In which sense a wheel counts that rolls the way in which the acceleration of its centre is asked, up a slope, or in
which a velocity of its centre is given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.system.system import Statements
from planar_cli.problem.language.expression import AtRest, Name, Part, PointPair, Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Joining, Mode
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND

SPEEDS = ("r", "x", "y", "theta", "v", "omega", "KE")
"""Quantities of places, velocities and energies."""


def rolling_as_asked(
    scene: Scene, statements: Statements, modes: Iterable[tuple[Any, tuple[Mode, ...]]]
) -> dict[str, int]:
    """The sense, 1 counterclockwise and -1 clockwise, in which wheels roll from rest on the ground, where the finds ask
    for the acceleration of their centre among others, all the same way; over time for the velocity of that, or of a
    body on it, such as a cart.
    """
    over_time = bool(scene.problem.states)
    if len(scene.bodies) == 1 or not _rests(scene, statements):
        return {}
    found: dict[str, set[int]] = {}
    for joining in (j for _, ways in modes if len(ways) == 1 for j in ways[0].facts.joinings):
        wheel = joining.mover if joining.base == GROUND else joining.base
        if joining.rolling is None or GROUND not in (joining.mover, joining.base) or wheel == GROUND:
            continue
        for way in _velocities(scene, wheel) if over_time else _asked_ways(scene, wheel):
            found.setdefault(wheel, set()).add(_sense(scene, joining, wheel, way))
    return {wheel: sense for wheel, senses in found.items() if len(senses) == 1 for sense in senses if sense}


def rolling_as_given(
    scene: Scene, statements: Statements, modes: Iterable[tuple[Any, tuple[Mode, ...]]]
) -> frozenset[str]:
    """The wheels that turn clockwise, as they roll on the ground the way in which the velocity of their centre is
    given. Of an instant at which nothing but places, velocities and energies is asked, and not how such a wheel turns.
    """
    given = list(_given_ways(scene, statements))
    wheels = {b for b, _ in given}
    if not given or scene.problem.states or any(_asks_more(f.found.what, wheels) for f in scene.problem.find):
        return frozenset()
    found: set[str] = set()
    for joining in (j for _, ways in modes if len(ways) == 1 for j in ways[0].facts.joinings):
        wheel = joining.mover if joining.base == GROUND else joining.base
        if joining.rolling is not None and joining.drift is None and GROUND in (joining.mover, joining.base):
            found |= {b for b, way in given if b == wheel and _sense(scene, joining, wheel, way) < 0}
    return frozenset(found)


def _given_ways(scene: Scene, statements: Statements) -> Iterator[tuple[str, Vec]]:
    """Bodies of whose mass centre a velocity is given, with the direction in which it is."""
    for relation, _ in statements.relations:
        left, right = relation.left, relation.right
        if not isinstance(left, Quantity) or left.word != "v" or len(left.things) != 1 or len(left.parts) != 1:
            continue
        bodies = [b for b in scene.bodies if left.things[0] in (b, scene.center_name(b)) and scene.rigid(b)]
        letter = scene.ledger.symbols.get(right.name) if isinstance(right, Name) else None
        sense = 0 if letter is None else scene.sign(letter)
        way = _direction(scene, left.parts[0])
        if way is not None and sense:
            yield from ((body, way if sense > 0 else -way) for body in bodies)


def _asks_more(what: Side | Relation, wheels: set[str]) -> bool:
    """Is an acceleration or a force asked, or how one of these wheels turns?"""
    asked = [q for q in walk(what) if isinstance(q, Quantity)]
    return any(q.word not in SPEEDS or (q.word == "omega" and set(q.things) & wheels) for q in asked)


def _rests(scene: Scene, statements: Statements) -> bool:
    """Does everything start from rest?"""
    if not scene.problem.states:
        return None in statements.rest
    first = scene.problem.states[0].relations
    return any(isinstance(s, AtRest) and s.body is None for s in first) and not scene.problem.coordinates


def _velocities(scene: Scene, wheel: str) -> Iterable[Vec]:
    """The directions along which velocities of a wheel are asked, or of what has its centre."""
    center = scene.center_name(wheel)
    going = {wheel, center, *scene.owners.get(center, ())}
    for find in scene.problem.find:
        what = find.found.what
        if isinstance(what, Quantity) and what.word == "v" and len(what.things) == 1 and what.things[0] in going:
            yield from (way for part in what.parts if (way := _direction(scene, part)) is not None)


def _asked_ways(scene: Scene, wheel: str) -> Iterable[Vec]:
    """The directions along which the acceleration of its centre is asked."""
    for find in scene.problem.find:
        what = find.found.what
        if isinstance(what, Quantity) and what.word == "a" and what.things in ((wheel,), (scene.center_name(wheel),)):
            yield from (way for part in what.parts if (way := _direction(scene, part)) is not None)


def _direction(scene: Scene, part: Part) -> Vec | None:
    axes = {"x": Vec(1, 0), "y": Vec(0, 1)}
    if part.kind == "along" and part.direction is not None and not isinstance(part.direction, PointPair):
        # Along a curve it changes with the place.
        changes = any(isinstance(q, Quantity) for q in walk(part.direction))
        return None if changes else scene.direction(part.direction)
    return axes.get(part.kind)


def _sense(scene: Scene, joining: Joining, wheel: str, way: Vec) -> int:
    """In which sense a wheel turns that rolls that way."""
    return scene.sign((scene.center(wheel) - joining.point).turned().dot(way))
