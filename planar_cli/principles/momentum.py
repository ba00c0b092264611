"""Impulse and momentum: a law between two states."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import ClassVar, final

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.principles._bodies import body_families, moving_of, of_mass_centre, of_turning
from planar_cli.principles._frames import Frame, frames, knows_less, unknown_sizes
from planar_cli.principles.base import Balance, BodyFamily, Impulses, Moving, Position, Principle, Source
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND

WORDS, COST = "impulse and momentum", 1.25
MOST_BODIES = 6
"""So many bodies are taken one by one; of more only all together."""


@final
class ImpulseMomentum(Principle):
    """The impulse of all forces between two states is the change of the momentum.

    Meaning
        The law relates two `states` by the time between them, for a body or a group, in one direction or about one
        point. Taken where no unknown reaction acts it gives speeds at once; where nothing acts at all, momentum is
        conserved, be it in one direction only. Reactions that stay in it have letters for their impulses, which count
        as they act; of the whole system those between its bodies cancel. In a blow (`just after`, `impact`, `impulse`)
        it is the only law. By itself it is one of the laws that the plan chooses from; `method: momentum` takes no
        other law between states.

    YAML
        title: Braked wheel
        plane: vertical
        given: {I: 0.8 kg*m^2, M: 6 N*m}
        points: {O: [0, 0]}
        bodies: {wheel: {disk: O, radius: 0.3 m, mass: 20 kg, inertia: I}}
        joints:
          - pin: {at: O, between: [ground, wheel]}
        loads:
          - torque: {body: wheel, moment: -M}
        states:
          1: [t = 0, omega(wheel) = 30 rad/s]
          2: [omega(wheel) = 0]
        method: momentum
        find: {t: t @ 2}

    Equations
        m v_G1 + ∫F dt = m v_G2
        H_O1 + ∫M_O dt = H_O2                   H_O = Σ (r_G/O × m v_G + I_G ω)
        H_G1 + ∫M_G dt = H_G2                   H_G = Σ ((r_i - r_G) × m_i (v_i - v_G) + I_i ω_i), G of all bodies
        about a point C that moves:  dH_C/dt = ΣM_C - v_C × m v_G

    Signs
        Along x and y; angular momenta counterclockwise. `impulse(f)` is that of the force on the body.

    Valid when
        The point O is fixed, or is the mass centre, or keeps its place beside it; any other point C that moves takes
        the term with its velocity.

    Reference
        An Introduction to Planar Dynamics, 3.4, 3.7, 4.6, equations 4.68 - 4.76, Examples 4-12 to 4-14, 4-18.
    """

    kind: ClassVar[str] = "momentum"
    title: ClassVar[str] = "impulse-momentum"

    def across(self, position: Position) -> Iterator[BodyFamily]:
        """Momentum before + impulses = momentum after, of every body."""
        return body_families(position)

    def over(self, position: Position, chosen: bool) -> Iterator[Balance | Impulses]:
        """For every body and the whole system, along x and y, about every fixed point O, about the mass centre of all,
        and about every other named point C that moves, with the term v_C × m v_G (it vanishes where C stays where it is
        to the mass centre): what no unknown reaction enters. By itself also what such reactions enter.
        """
        yield from _balances(position)
        for frame in frames(position):
            yield from _seen_from(position, frame)
        if chosen:
            yield Impulses(WORDS, COST)


def _balances(position: Position) -> Iterator[Balance]:
    system, scene = position.system, position.system.scene
    if system.reactions is None or any(p.kind == "drive" and not p.actions for p in system.pushes):
        return
    varying = {b.mass for b in scene.bodies.values() if b.varies}
    if any(m.free_symbols & {c.symbol for c in position.coordinates} for m in varying):
        return
    followers = {law.push for law in system.laws}
    loose = {system.symbols[p.name] for p in system.pushes if p.name not in followers}
    acting = [w for w in system.reactions.acting("all") if w.body != GROUND]
    fixed = {n: p for n, p in scene.points.items() if not (scene.owners.get(n) or ()) or _still(p)}
    for group in _groups(scene):
        if all(scene.bodies[b].mass == 0 for b in group):
            continue
        outer = [w for w in acting if w.body in group]
        for d, arrow in ((Vec(sp.S.One, sp.S.Zero), "→ "), (Vec(sp.S.Zero, sp.S.One), "↑ ")):
            rate = expanded(
                sp.Add(*(w.force.dot(d) for w in outer if w.force is not None), _gained(position, group, d))
            )
            if not rate.free_symbols & loose:
                brings = _brings_nothing(position, group, d, outer) if varying else ""
                yield from _balance(group, _linear(position, group, d), rate, arrow, "", brings)
        if varying:
            continue
        centres = {**fixed, **(_own_points(position, group[0]) if len(group) == 1 else {})}
        for name, center in centres.items():
            rate = simplified(expanded(sp.Add(*(_moment(position, w, center) for w in outer))))
            if not rate.free_symbols & loose:
                through, parts = _passing(position, group, center), _angular(position, group, center)
                aside = "" if name in fixed else _beside(position, group[0], name)
                moving = tuple(moving_of(system, position.motion, group))
                if clockwise := position.motion.tree.turn(group) < 0:
                    parts, rate = {b: -e for b, e in parts.items()}, -rate
                arrow = "↻ " if clockwise else "↺ "
                yield from _balance(group, parts, rate, arrow, name, aside, through, moving)


def _balance(
    group: tuple[str, ...],
    parts: dict[str, sp.Expr],
    rate: sp.Expr,
    arrow: str,
    about: str,
    explained: str = "",
    passing: tuple[sp.Expr, ...] = (),
    moving: tuple[Moving, ...] = (),
) -> Iterator[Balance]:
    if sp.Add(*parts.values()) == 0:
        return
    heading, kept = "", "conservation of momentum"
    if about:
        heading, kept = "angular impulse and momentum about ", "conservation of angular momentum about "
    yield Balance(
        words=WORDS,
        name=f"H_{about}" if about else "",
        amounts=tuple(parts.items()),
        sources=(Source("", rate),),
        cost=COST,
        bodies=group,
        heading=heading,
        kept=kept,
        about=about,
        explained=explained,
        passing=passing,
        lead=arrow,
        moving=moving,
    )


def _beside(position: Position, body: str, point: str) -> str:
    """Why the law holds about a point that moves: it keeps its place beside the mass centre."""
    centre = centre_of(position.system.scene, body)
    if point == position.system.scene.center_name(body) or "_" in centre:
        return ""
    return f" ({point} moves parallel to {centre})"


def _passing(position: Position, group: tuple[str, ...], center: Vec) -> tuple[sp.Expr, ...]:
    """The sizes of the forces on a group from outside whose lines of action pass through a point."""
    reactions = position.system.reactions
    assert reactions is not None
    found: list[sp.Expr] = []
    for push, size in reactions.pushes:
        own = [a for a in push.actions if a.body in group]
        if len(own) == 1 and own[0].force is not None and own[0].couple == 0:
            found += [size] * _meets(position, own[0].point, own[0].force, center)
    for w in reactions.wrenches:
        if w.body in group and w.force is not None and w.couple == 0 and w.magnitude != 0:
            found += [w.magnitude] * _meets(position, w.point, w.force, center)
    return tuple(dict.fromkeys(found))


def _meets(position: Position, point: Vec, force: Vec, center: Vec) -> bool:
    scene = position.system.scene
    moment = scene.arms.between(center, point).cross(force)
    # The force of a damper rests on speeds, which have no numbers here: where it passes is not told then.
    return moment == 0 or (all(v.known(moment) is not None for v in scene.valuations) and scene.vanishes(moment))


def _still(place: Vec) -> bool:
    return not (place.x.free_symbols | place.y.free_symbols)


def _groups(scene: Scene) -> list[tuple[str, ...]]:
    """Every body alone, and all together."""
    bodies = tuple(scene.bodies)
    single: list[tuple[str, ...]] = [(b,) for b in bodies[:MOST_BODIES]]
    return [*single, bodies] if len(bodies) > 1 else single


def _own_points(position: Position, body: str) -> dict[str, Vec]:
    """Points that keep their place beside the mass centre of a body that may turn; a particle has no balance of
    moments, whatever presses on the surface that it carries.
    """
    scene = position.system.scene
    if not scene.rigid(body):
        return {}
    center = scene.center(body)
    letters = {c.symbol for c in position.coordinates}
    found = {}
    for name, place in scene.points.items():
        arm = place - center
        if not (simplified(arm.x).free_symbols | simplified(arm.y).free_symbols) & letters:
            found[name] = place
    return found


def _moment(position: Position, w: Wrench, center: Vec) -> sp.Expr:
    turning = position.system.scene.arms.between(center, w.point).cross(w.force) if w.force is not None else sp.S.Zero
    return turning + w.couple


def _linear(position: Position, group: tuple[str, ...], d: Vec) -> dict[str, sp.Expr]:
    scene, motion = position.system.scene, position.motion
    return {b: scene.bodies[b].mass * motion.velocity(scene.center(b), b).dot(d) for b in group}


def _gained(position: Position, group: tuple[str, ...], d: Vec) -> sp.Expr:
    """The momentum per second of what enters or leaves with the velocity of the body: dm/dt v. The push of a stream is
    that of its velocity relative to the body, so that both together are the momentum that it brings.
    """
    scene, motion = position.system.scene, position.motion
    rates = ((b, _filling(position, b)) for b in group)
    return sp.Add(*(rate * motion.velocity(scene.center(b), b).dot(d) for b, rate in rates if rate != 0))


def _filling(position: Position, body: str) -> sp.Expr:
    """dm/dt."""
    return derivative(sp.sympify(position.system.scene.bodies[body].mass), position.time)


def _brings_nothing(position: Position, group: tuple[str, ...], d: Vec, outer: Iterable[Wrench]) -> str:
    """That streams bring no momentum in a direction, where masses vary; "": they do."""
    streams = sp.Add(*(w.force.dot(d) for w in outer if w.force is not None and w.kind == "stream"))
    gained = _gained(position, group, d)
    if gained == 0 or expanded(streams + gained) != 0:
        return ""
    enters = position.value.known(sp.Add(*(_filling(position, b) for b in group)))
    what = "flows" if enters is None else "enters" if enters > 0 else "leaves"
    return f" (what {what} has no velocity along {'x' if d.x != 0 else 'y'})"


def _angular(position: Position, group: tuple[str, ...], center: Vec) -> dict[str, sp.Expr]:
    scene, motion = position.system.scene, position.motion
    parts = {}
    for b in group:
        body = scene.bodies[b]
        arm, v = scene.arms.between(center, body.center), motion.velocity(body.center, b)
        moving = of_mass_centre(position.system, b, body.mass * arm.cross(v))
        parts[b] = moving + of_turning(b, body.inertia) * motion.velocities[b].angular
    return parts


def _seen_from(position: Position, frame: Frame) -> Iterator[Balance]:
    """Angular momentum about the point of a frame, of what moves in it."""
    scene = position.system.scene
    parts, inertia = {}, sp.S.Zero
    for name in frame.bodies:
        body, (arm, v) = scene.bodies[name], frame.of(position, name)
        spin = body.inertia * position.motion.velocities[name].angular
        parts[name] = simplified(expanded(body.mass * arm.cross(v) + spin))
        inertia += body.mass * arm.cross(frame.inertia)
    rate = simplified(expanded(sp.Add(inertia, *(_moment(position, w, frame.place) for w in frame.acting))))
    if not rate.free_symbols & unknown_sizes(position) and knows_less(position, parts.values()):
        yield from _balance(frame.bodies, parts, rate, "↺ ", frame.point, frame.words)
