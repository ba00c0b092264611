"""Points where outlines touch and where cords leave rims: they go with the centres, not with the rims."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from planar_cli.errors import Mark
from planar_cli.joints.base import Joint
from planar_cli.loads.base import Load
from planar_cli.motion.scene.carried import Carried
from planar_cli.motion.scene.feet import Foot
from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Span
from planar_cli.problem.scene.scene import GROUND

HubAt = Callable[[str, Vec], Vec]
"""The centre of the rim through a place of a body."""
OutlineAt = Callable[[str, Vec, Mark], Outline]
"""The outline of a partner of a joint at a place."""
SpotAt = Callable[[str, Vec, Span], Vec]
"""Where a partner is touched at a place by a joint that acts between some states."""


def spots_of(
    scene: Carried, outline_at: OutlineAt, spot_at: SpotAt, feet: Mapping[tuple[str, str], Foot], hub_at: HubAt
) -> dict[str, Vec]:
    """The places of such points, by name."""
    found: dict[str, Vec] = {}
    for joint in scene.problem.joints:
        at, between = getattr(joint, "at", None), getattr(joint, "between", ())
        if joint.touches and at is not None and len(between) == 2:
            spot = _touching(scene, outline_at, spot_at, feet, joint, at, between)
            if spot is not None:
                found[at] = spot
    members: tuple[Joint | Load, ...] = (*scene.problem.joints, *scene.problem.loads)
    for member in members:
        for point, body in member.rims():
            center = hub_at(body, scene.carried(body, point))
            found[point] = center + (scene.place_drawn(point) - _drawn(center))
    for joint in scene.problem.joints:
        found |= {point: _tangent(scene, hub_at, point, body, other) for point, body, other in joint.tangents()}
    return found


def _drawn(place: Vec) -> Vec:
    """Where a place is drawn, in plain numbers."""
    return Vec(place.x.value, place.y.value)


def _tangent(scene: Carried, hub_at: HubAt, point: str, body: str, other: str) -> Vec:
    """Where a cord that runs straight to another point leaves a rim: C + ρ n with n = (ρ r - L r × k) / r², r from the
    centre C to that point, L² = r² - ρ².
    """
    graph, center = scene.graph, hub_at(body, scene.carried(body, point))
    arm, reach = scene.place_drawn(point) - _drawn(center), scene.point(other) - center
    square = graph.of(reach.dot(reach))
    radius = graph.call("sqrt", graph.of(arm.dot(arm)))
    way = scene.sign(graph.of(arm.cross(scene.place_drawn(other) - _drawn(center))))
    free = scene.root(square - radius * radius)
    normal: Vec = (reach * radius - reach.turned() * (free * way)) / square
    place: Vec = center + normal * radius
    return place


def _touching(
    scene: Carried,
    outline_at: OutlineAt,
    spot_at: SpotAt,
    feet: Mapping[tuple[str, str], Foot],
    joint: Joint,
    at: str,
    between: tuple[str, ...],
) -> Vec | None:
    """Between the centres of two rims, or off the centre of one across the edge that it touches."""
    place = scene.point(at)
    outlines = [outline_at(p, spot_at(p, place, joint.during), joint.mark) for p in between]
    rounds = [o for o in outlines if o.kind == "arc" and o.center is not None]
    drawn = scene.place_drawn(at)
    if len(rounds) == 2:
        a, b = (_center(o) for o in rounds)
        start = _reference(scene, a)
        reach = _reference(scene, b) - start
        share = (drawn - start).dot(reach) / reach.dot(reach)
        between_rims: Vec = a + (b - a) * share
        return between_rims
    curves = [o.curve for o in outlines if o.curve]
    if len(rounds) == 1 and curves:
        foot = feet.get((curves[0], rounds[0].body))
        return None if foot is None else foot.bend.place
    straight = [o for o in outlines if o.kind == "straight"]
    if len(rounds) == 1 and straight:
        center = _center(rounds[0])
        arm = drawn - _reference(scene, center)
        spot: Vec = center + (scene.turned_with(straight[0].body, arm) if straight[0].body != GROUND else arm)
        return spot
    return None


def _center(outline: Outline) -> Vec:
    assert outline.center is not None
    return outline.center


def _reference(scene: Carried, v: Vec) -> Vec:
    """A place as drawn."""
    graph = scene.graph
    return Vec(graph.number(graph.of(v.x).value), graph.number(graph.of(v.y).value))
