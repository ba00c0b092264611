"""A point by which two bodies are drawn is one point as long as a joint holds them together there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from planar_cli.errors import Diagnostic, Mark
from planar_cli.joints.base import Joint
from planar_cli.problem.checks.scope import Scope
from planar_cli.problem.nodes.reading import listed
from planar_cli.problem.scene.shapes import own_points

HOLDING = ("pin", "weld")
"""What holds bodies together at a point."""


def shared_points_are_held(scope: Scope) -> Iterator[Diagnostic]:
    """Where a pin or weld holds some bodies of a point, it holds all of them; and bodies that turn about a pin share no
    other point, as they would part there.
    """
    problem = scope.problem
    members: dict[str, list[str]] = {}
    for body in problem.bodies:
        for point in dict.fromkeys((*own_points(body.shape), *body.points)):
            members.setdefault(point, []).append(body.name)
    # What slides through a point along another body is drawn there, and may belong to both.
    sliding = {getattr(joint, "point", None) for joint in problem.joints}
    # One whose members could not be read holds nobody knows what.
    held = [j for j in problem.joints if j.kind in HOLDING and set(getattr(j, "between", ()))]
    # What touches or strikes another body may be drawn where it does.
    meeting = [j for j in problem.joints if j.touches or j.strikes]
    for point, bodies in members.items():
        if len(bodies) == 1 or point in sliding:
            continue
        here = [j for j in held if getattr(j, "at", None) == point]
        met = [j for j in meeting if len({*getattr(j, "between", ())} & {*bodies}) > 1]
        groups = _joined(bodies, (*here, *met))
        if len(groups) > 1:
            yield from list(_not_held(point, bodies, groups, here)) or _turned_apart(point, groups, held, scope)


def carried_together(point: str, bodies: Sequence[str], joints: Iterable[Joint]) -> list[str]:
    """Those of the bodies of a point that it moves with: the first, and what is held to that there."""
    here = [j for j in joints if j.kind in HOLDING and getattr(j, "at", None) == point]
    group = next(g for g in _joined(bodies, here) if bodies[0] in g)
    return [b for b in bodies if b in group]


def _joined(bodies: Iterable[str], joints: Iterable[Joint]) -> list[set[str]]:
    """The bodies of a point, with those (and the ground) that are joined there, in groups of which each is one."""
    groups = [{body} for body in bodies]
    for joint in joints:
        names = set(getattr(joint, "between", ()))
        meant = [g for g in groups if g & names]
        groups = [g for g in groups if not g & names]
        groups.append(names.union(*meant))
    return groups


def _not_held(point: str, bodies: Iterable[str], groups: list[set[str]], here: list[Joint]) -> Iterator[Diagnostic]:
    """Bodies that a joint at their point leaves out."""
    for joint in here[:1]:
        for group in groups:
            if not any(group & set(getattr(j, "between", ())) for j in here):
                # Several bodies are in a group where they touch each other.
                body = next(b for b in bodies if b in group)
                text = f"{point} is a point of {body} too, which no joint holds there"
                hint = f"name {body} in `between` of the {joint.kind}, or give it a point of its own"
                yield Diagnostic(joint.mark, "PL467", text, hint)


def _turned_apart(point: str, groups: list[set[str]], held: list[Joint], scope: Scope) -> Iterator[Diagnostic]:
    """Bodies of a point that are joined only at another one."""
    told: set[Mark] = set()
    for joint in held:
        at, names = getattr(joint, "at", None), set(getattr(joint, "between", ()))
        parted = [g for g in groups if g & names & scope.bodies.keys()]
        if joint.kind != "pin" or len(parted) < 2 or joint.mark in told:
            continue
        told.add(joint.mark)
        both = listed(sorted(b for g in parted for b in g & names & scope.bodies.keys()), "and")
        text = f"{both} turn about {at}, where a pin holds them, and {point} is a point of both: there they part"
        hint = f"hold them together at {point} as well, or give one of them a point of its own"
        yield Diagnostic(joint.mark, "PL467", text, hint)
