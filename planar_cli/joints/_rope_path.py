"""The free parts of a rope: where it leaves each pulley and drum, and what its tension does there."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

from planar_cli.errors import Mark
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Action, Anchor, Segment
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.keys import RopeStop
from planar_cli.problem.scene.setting import Setting
from planar_cli.records import record


@record
class RopePath:
    """How a rope runs, as the file says it."""

    name: str
    """The joint's name."""
    stops: tuple[RopeStop, ...]
    """Points, pulleys passed over or under, and drums on which the rope is wound, in order."""
    along: Side | None
    """The direction of all its parts; None: each runs straight from stop to stop."""
    mark: Mark
    """The place of the entry in the file."""


@record
class Stop:
    """One stop: the body that it is on, its centre (or point), its radius, and on which side of the rope the centre is.

    `side`: +1 when the centre lies to the left of the running rope. `rim`: the point where a wound rope leaves the
    drum.
    """

    body: str
    center: Vec
    radius: Any
    side: int
    rim: Vec | None


def free_parts(
    rope: RopePath, scene: Setting
) -> tuple[tuple[Segment, ...], tuple[tuple[str, Any], ...], tuple[Action, ...]]:
    """Segments between stops, spins of drums, and the actions of a unit of tension.

    The rate of the rope's length is Σ direction · (v_end - v_start) over the segments, plus what drums give out; a
    pulley on which the rope only turns adds nothing beyond the motion of its centre.
    """
    stops = stops_of(rope, scene)
    segments, actions = [], []
    spins: list[tuple[str, Any]] = []
    for (start, end), ends in zip(pairwise(stops), pairwise(rope.stops), strict=True):
        _demand_along(rope, scene, (start.rim or start.center, end.rim or end.center), ends)
        direction, length = _tangent(rope, scene, start, end)
        segments.append(Segment(Anchor(start.body, start.center), Anchor(end.body, end.center), direction, length))
        for stop, pull in ((start, direction), (end, -direction)):
            actions.append(Action(stop.body, stop.rim or stop.center, pull))
            if stop.rim is not None:
                spins.append((stop.body, -(stop.rim - stop.center).cross(pull)))
    return tuple(segments), tuple(spins), tuple(actions)


def stops_of(rope: RopePath, scene: Setting) -> list[Stop]:
    """What the path says: each stop with its body, centre, radius and side."""
    return [_stop(rope, scene, i) for i in range(len(rope.stops))]


def _stop(rope: RopePath, scene: Setting, index: int) -> Stop:
    stop = rope.stops[index]
    if stop.way == "on":
        body = stop.body or ""
        rim = scene.point(stop.name)
        return Stop(body, scene.hub(body, rim), 0, 0, rim)
    if stop.way == "point":
        return Stop(scene.owner(stop.name), scene.point(stop.name), 0, 0, None)
    if not 0 < index < len(rope.stops) - 1:
        raise scene.refuse(
            rope.mark,
            "PL525",
            f"{rope.name}: a rope can not end `{stop.way}` a pulley",
            "let it end at a point, or wound: `T on drum`",
        )
    body = scene.pulley(stop.name)
    radius = scene.radius(body) if body else 0
    center = scene.point(stop.name)
    if rope.along is not None or radius == 0:
        return Stop(body or scene.owner(stop.name), center, 0, 0, None)
    before, after = (_place(scene, rope.stops[i]) for i in (index - 1, index + 1))
    ahead = scene.sign(after.x - before.x)
    if ahead == 0:
        raise scene.refuse(
            rope.mark,
            "PL526",
            f"{rope.name}: the stops beside {stop.name} lie one above the other",
            "`over` and `under` need a left and a right part, or write `along:`",
        )
    return Stop(body or scene.owner(stop.name), center, radius, -ahead if stop.way == "over" else ahead, None)


def _place(scene: Setting, stop: RopeStop) -> Vec:
    return scene.point(stop.name)


def _tangent(rope: RopePath, scene: Setting, start: Stop, end: Stop) -> tuple[Vec, Any]:
    """Direction of the straight part from one stop to the next, and its length (None: the direction stays)."""
    if rope.along is not None:
        direction = scene.unit(rope.along)
        reach = (end.rim or end.center) - (start.rim or start.center)
        return (direction if scene.sign(reach.dot(direction)) >= 0 else -direction), None
    for stop, other, way in ((start, end, 1), (end, start, -1)):
        if stop.rim is not None:
            arm = stop.rim - stop.center
            _demand_apart(rope, scene, arm)
            along = arm.turned() / scene.length(arm)
            towards = scene.sign(((other.rim or other.center) - stop.rim).dot(along)) * way
            direction = along * towards
            _demand_apart(rope, scene, Vec((end.center - start.center).dot(direction), 0))
            return direction, (end.center - start.center).dot(direction)
    reach = end.center - start.center
    _demand_apart(rope, scene, reach)
    offset = end.side * end.radius - start.side * start.radius
    if offset == 0:
        distance = scene.length(reach)
        return reach / distance, distance
    length = scene.root(reach.dot(reach) - offset**2)
    direction = (reach * length - reach.turned() * offset) / reach.dot(reach)
    # What hangs straight down keeps its part of the rope upright, as do parts along the line of what slides.
    steady = scene.steady(direction)
    return (direction, length) if steady is None else (steady, reach.dot(steady))


def _demand_along(rope: RopePath, scene: Setting, places: tuple[Vec, Vec], ends: tuple[RopeStop, RopeStop]) -> None:
    """Refuse a part at right angles to the direction that all parts are said to have: its length would not count."""
    reach = places[1] - places[0]
    if rope.along is None or not scene.is_zero(reach.dot(scene.unit(rope.along))) or scene.is_zero(reach.dot(reach)):
        return
    first, second = ends
    text = f"{rope.name}: its part from {first.name} to {second.name} runs across its direction `along`"
    hint = "leave `along` out, and draw parallel parts parallel, or give each pulley a radius: `over D`, `under E`"
    raise scene.refuse(rope.mark, "PL539", text, hint)


def _demand_apart(rope: RopePath, scene: Setting, reach: Vec) -> None:
    """Refuse a straight part without length."""
    if scene.vanishes(reach.dot(reach)):
        text = f"two stops of {rope.name} are at the same place: the rope has no direction there"
        raise scene.refuse(rope.mark, "PL541", text, "draw them apart, and where a rope is wound on its rim")
