"""Whether what hangs on a rope may sway: what hangs straight down does so only where the file says so."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from planar_cli.equation.scene.meeting import meeting_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity, Relation, Side
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Facts, Joining, Mode
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.headings import heading
from planar_cli.problem.scene.scene import GROUND

ROPES = ("taut", "slack")
ASIDE = ("x", "angle", "theta")
"""Parts of a place or a velocity that tell of sideways motion; of what can only sway, any part does."""


def sways(scene: Scene, modes: Iterable[Mode], body: str) -> bool:
    """Is a body struck or sent off sideways, does a rope pull it aslant where it is drawn, or does none hold it?"""
    if scene.problem.plane == "horizontal" or any(_strikes_aside(scene, m, body) for m in scene.problem.strikers):
        return True
    if scene.displacement is None:
        return False
    facts = [_held(mode) for mode in modes if mode.name in ROPES]
    ties = [j for f in facts for j in f.joinings if body in (j.mover, j.base) and j.path is not None]
    drawn = {c.symbol: c.drawn for c in scene.displacement.coordinates if c.drawn is not None}
    ends = _directions(facts, ties, body)
    if not ends or any(not scene.is_zero(d.x.xreplace(drawn)) for d in ends):
        return True
    if any(_turns_aside(scene, end, at) for end, at in _far_ends(scene, facts, ties, body)):
        return True
    return sent_aside(scene, body, any(GROUND in (j.mover, j.base) for j in ties))


def _strikes_aside(scene: Scene, member: Any, body: str) -> bool:
    """Does an impact or an impulse send a body aside? Not where it acts straight up or down, and smoothly."""
    between: tuple[str, ...] = getattr(member, "between", ())
    if body not in (*between, getattr(member, "body", "")):
        return False
    if not between:
        angle: Side | None = getattr(member, "angle", None)
        return angle is None or not scene.is_zero(scene.unit(angle).x)
    if getattr(member, "mu", None) is not None:
        return True
    said: Side | None = getattr(member, "normal", None)
    normal = meeting_of(scene, between, None if said is None else heading(scene, said), member.mark).normal
    return not scene.is_zero(normal.x)


def _held(mode: Mode) -> Facts:
    """What a rope keeps while it is taut."""
    return mode.touching if mode.parted else mode.facts


def _directions(facts: list[Facts], ties: list[Joining], body: str) -> list[Vec]:
    """The directions in which ropes pull a body."""
    segments = [s for f in facts for row in f.rows for s in row.segments]
    found = [s.direction for s in segments if body in (s.start.body, s.end.body)]
    return found + [j.path.tangent.turned() for j in ties if j.path is not None]


def _far_ends(scene: Scene, facts: list[Facts], ties: list[Joining], body: str) -> Iterator[tuple[str, Vec]]:
    """What a body hangs from: other bodies, with the place of the point that holds the rope."""
    for segment in (s for f in facts for row in f.rows for s in row.segments):
        for near, far in ((segment.start, segment.end), (segment.end, segment.start)):
            if near.body == body:
                yield far.body, far.point
    for tie in ties:
        yield (tie.mover, tie.point) if tie.base == body else (tie.base, scene.point(tie.far))


def _turns_aside(scene: Scene, body: str, at: Vec) -> bool:
    """Does a point of a body, at `at` in a general position, go sideways as the body turns?"""
    pose = scene.displacement.poses.get(body) if scene.displacement is not None else None
    return pose is not None and not pose.turn.free_symbols.isdisjoint(at.x.free_symbols)


def sent_aside(scene: Scene, body: str, tied: bool) -> bool:
    """Does a state give a body, or what it catches, a velocity sideways, or a later one another place? `tied`: to a
    fixed point, so that it can only sway.
    """
    concerned = {body, *_caught(scene, body)}
    for i, state in enumerate(scene.problem.states):
        for relation in state.relations:
            if not isinstance(relation, Relation) or relation.operator != "=":
                continue
            for q, other in _quantities(relation):
                if q.things[:1] and not concerned & {q.things[0], scene.owner(q.things[0])}:
                    continue
                parts = [p.kind for p in q.parts]
                aside = any(kind in ASIDE for kind in parts) or q.word == "x" or tied
                if q.word == "v" and aside and not _is_zero(scene, other):
                    return True
                if q.word in ("x", "y", "r") and i and aside and not has_quantity(other):
                    return True
    return False


def _caught(scene: Scene, body: str) -> Iterator[str]:
    """The bodies to which a joint ties it from some state on."""
    for joint in scene.problem.joints:
        between: tuple[str, ...] = getattr(joint, "between", ())
        if joint.during is not None and not joint.touches and body in between:
            yield from (b for b in between if b in scene.bodies)


def _quantities(relation: Relation) -> Iterator[tuple[Quantity, Side]]:
    """The quantities that a relation equates to something."""
    for side, other in ((relation.left, relation.right), (relation.right, relation.left)):
        for node in walk(side):
            if isinstance(node, Quantity) and node.things:
                yield node, other


def has_quantity(side: Side) -> bool:
    """Does a quantity stand in a side?"""
    return any(isinstance(node, Quantity) for node in walk(side))


def _is_zero(scene: Scene, side: Side) -> bool:
    """Is a side plainly zero?"""
    return not has_quantity(side) and scene.value(side) == 0
