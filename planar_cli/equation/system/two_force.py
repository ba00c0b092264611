"""Two-force members: a body without mass on which nothing acts but two pins. Its balance of forces and of moments says
that both forces are of one size and stand along the line of the pins, one against the other; so its own equations are
not written, and one unknown stands for four.

    A_x, A_y, B_n, B_t   →   S_AB along AB, at A and at B
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from planar_cli.equation.scene.scene import Scene
from planar_cli.loads.base import Load
from planar_cli.problem.scene.facts import Action, Facts, Push
from planar_cli.problem.scene.geometry import Vec


def with_two_force_members(
    scene: Scene, facts: Sequence[Facts], pushes: Sequence[Push], drivers: Sequence[Push]
) -> tuple[Push, ...]:
    """The pushes, where the two pins of every such body have one force along it each; they pull where it is positive.
    Of two such bodies that are pinned together the first one is taken.
    """
    found = list(pushes)
    for body in _idle_bodies(scene, facts, drivers):
        acting = [p for p in found if any(a.body == body for a in p.actions)]
        pins = list(dict.fromkeys(p.joint for p in acting))
        own = {pin: [p for p in acting if p.joint == pin] for pin in pins}
        if len(pins) != 2 or not all(_is_pin(parts) for parts in own.values()):
            continue
        places = [_place(own[pin][0], body) for pin in pins]
        reach = places[1] - places[0]
        if scene.is_zero(reach.dot(reach)):
            continue
        along = reach / scene.length(reach)
        first = _pull(own[pins[0]][0], body, along, f"S_{body}")
        second = replace(_pull(own[pins[1]][0], body, -along, f"S_{body}_2"), like=first.name)
        made = {pins[0]: first, pins[1]: second}
        firsts = {own[pin][0].name: made[pin] for pin in pins}
        gone = {p.name for parts in own.values() for p in parts[1:]}
        found = [firsts.get(p.name, p) for p in found if p.name not in gone]
    return tuple(found)


def acts_on(load: Load, scene: Scene, bodies: Collection[str]) -> bool:
    """Does a load act on one of these bodies? Weights act on what has mass."""
    if load.kind == "weight":
        return load.name in bodies and scene.bodies[load.name].mass != 0
    ends: tuple[str, ...] = getattr(load, "between", None) or ()
    return not {getattr(load, "body", ""), *ends, *(scene.owner(end) for end in ends)}.isdisjoint(bodies)


def _idle_bodies(scene: Scene, facts: Sequence[Facts], drivers: Sequence[Push]) -> list[str]:
    """The rigid bodies without mass on which no load acts, nothing rubs and nothing drives."""
    taken = {a.body for p in drivers for a in p.actions} | {s.body for f in facts for s in f.skids}
    light = [n for n, b in scene.bodies.items() if b.rigid and b.mass == 0 and b.inertia == 0 and not b.varies]
    return [n for n in light if n not in taken and not any(acts_on(load, scene, (n,)) for load in scene.problem.loads)]


def _is_pin(parts: Sequence[Push]) -> bool:
    """Are these both components of one pin, and nothing besides?"""
    return len(parts) == 2 and all(p.kind == "component" and p.unit == "N" and len(p.actions) == 2 for p in parts)


def _place(push: Push, body: str) -> Vec:
    return next(a.point for a in push.actions if a.body == body)


def _pull(push: Push, body: str, along: Vec, name: str) -> Push:
    """The force at one pin that a pull of the member brings. `along`: from that pin to the other."""
    actions = tuple(Action(a.body, a.point, -along if a.body == body else along) for a in push.actions)
    return replace(push, name=name, kind="tension", actions=actions, member=body)
