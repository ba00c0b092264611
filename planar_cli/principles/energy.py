"""Work and kinetic energy: a law between two states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any, ClassVar, final

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.kinematics.moving import Moving as MovingScene
from planar_cli.equation.system.guided import guides_nothing
from planar_cli.equation.system.one_body import inner_reactions
from planar_cli.principles._bodies import joined, moving_of, of_mass_centre, of_turning
from planar_cli.principles._frames import Frame, frames, knows_less, power_in, unknown_sizes
from planar_cli.principles.base import Balance, Idle, Position, Principle, Source, Stored
from planar_cli.problem.scene.acting import acting_loads
from planar_cli.problem.scene.facts import Push, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND

WORK, NO_WORK = 0.9, 1.3
"""The cost of the balance; where nothing does work on a group, its momentum tells the speeds sooner."""
FRICTION = "friction at {}"
"""What does work where no load does: what slips."""


@final
class WorkEnergy(Principle):
    """The work of all forces between two states is the change of the kinetic energy.

    Meaning
        The law relates two `states` without the time between them. Weights, springs, other loads and friction do work;
        ideal joints (smooth pins and guides, links, taut ropes, rolling without slip) do none. Where all of it has a
        potential this is the conservation of energy. By itself it is one of the laws that the plan chooses from;
        `method: energy` takes no other law between states. Then states are related even if the motion would not lead
        from one to the other by itself, which is said beside the answer. Of one body on which, beside loads, a rope
        alone works the law tells the tension, where this does not change: where nothing else of forces, accelerations
        or times is asked, the page goes that way.

    YAML
        title: Crate slides to a stop
        plane: vertical
        given: {m: 20 kg, mu: 0.3, v_0: 4 m/s}
        points: {C: [0, 0]}
        surfaces: {floor: {through: C, angle: 0 deg}}
        bodies: {crate: {particle: C, mass: m}}
        joints:
          - contact: {between: [crate, floor], at: C, mu: mu}
        states:
          1: [v(crate).x = v_0]
          2: [crate at rest]
        method: energy
        find: {way: x(crate) @ 2 - x(crate) @ 1, heat: heat(C) @ 1->2}

    Equations
        T_1 + U_1-2 = T_2                       T = Σ (m v_G²/2 + I_G ω²/2)
        weight:  U = m g (y_1 - y_2)            spring:  U = k (s_1² - s_2²)/2
        constant force:  U = F · Δr             couple:  U = M Δθ
        friction:  U = -∫ mu N ds               conservation:  T_1 + V_1 = T_2 + V_2
        a rope on a part:  U = S Δs
        seen from the mass centre G of all:     T'_1 + U'_1-2 = T'_2,  T' = Σ (m (v_i - v_G)²/2 + I_i ω_i²/2)

    Signs
        Work is positive where a force acts along the motion of its point.

    Valid when
        Every force that does work depends on the place alone; a support or belt that moves does work of its own.

    Reference
        An Introduction to Planar Dynamics, 3.3, 3.5, 4.5, equations 4.61 - 4.67, Examples 4-8 to 4-11.
    """

    kind: ClassVar[str] = "energy"
    title: ClassVar[str] = "work-energy"
    alone: ClassVar[str] = "the balance of energy"

    def over(self, position: Position, chosen: bool) -> Iterator[Balance]:
        """T_1 + U_1-2 = T_2 of all bodies, and of each group of them that nothing joins to the others; unless something
        unknown drives the scene, or a support moves.
        """
        for frame in frames(position):
            yield from _seen_from(position, frame)
        if not _closed(position):
            return
        groups, sources = joined(position), list(_sources(position))
        whole = tuple(position.system.scene.bodies)
        if len(groups) > 1:
            for group in groups:
                yield from _of(position, group, [s for s, bodies in sources if bodies & set(group)], group)
        yield from _of(position, whole, [s for s, _ in sources], ())

    def of_part(self, position: Position, body: str, words: str, pull: sp.Expr) -> Balance | None:
        """T_1 + U_1-2 = T_2 of one body, with the work of the reaction that works on it; None: a load acts on another
        body too, as a moment between both does.
        """
        acting = [(s, bodies - {GROUND}) for s, bodies in _sources(position) if body in bodies]
        if not _closed(position) or any(bodies != {body} for _, bodies in acting):
            return None
        balance = next(_of(position, (body,), [*(s for s, _ in acting), Source(words, pull)], (body,)), None)
        return None if balance is None else replace(balance, internal=())


def _of(
    position: Position, bodies: tuple[str, ...], sources: Sequence[Source], told: tuple[str, ...]
) -> Iterator[Balance]:
    """The balance of some bodies; `told`: by which names, none where they are all."""
    scene, motion = position.system.scene, position.motion
    kinetic = []
    for name in bodies:
        body = scene.bodies[name]
        v, omega = motion.velocity(body.center, name), motion.velocities[name].angular
        moving = of_mass_centre(position.system, name, body.mass * v.dot(v) / 2)
        kinetic.append((name, moving + of_turning(name, body.inertia) * omega**2 / 2))
    amounts = tuple((name, energy) for name, energy in kinetic if energy != 0)
    if told and not amounts:
        return
    ideal = _ideal(position, bodies)
    # What is welded together is one body: nobody asks about the work inside it.
    welds = {push.joint for push, _ in inner_reactions(position.system)}
    works = any(expanded(s.rate) != 0 for s in sources)
    yield Balance(
        words="work and kinetic energy",
        name="",
        amounts=amounts,
        sources=tuple(sources),
        cost=WORK if works or not told else NO_WORK,
        bodies=told,
        letter=scene.problem.kinetic_energy,
        bring="U",
        idle=tuple(Idle(position.system.symbols[p.name], _why_idle(position, p)) for p in ideal if not _is_internal(p)),
        internal=tuple(position.system.symbols[p.name] for p in ideal if _is_internal(p) and p.joint not in welds),
        adds=True,
        timeless=True,
        moving=tuple(moving_of(position.system, motion, bodies)),
        longest=500,
    )


def _seen_from(position: Position, frame: Frame) -> Iterator[Balance]:
    """T'_1 + U'_1-2 = T'_2, where no unknown reaction does work as the frame sees it; of the forces of inertia
    in the frame of the mass centre all work cancels (König).
    """
    scene, motion = position.system.scene, position.motion
    amounts, inertia = {}, sp.S.Zero
    for name in frame.bodies:
        body, (_, v) = scene.bodies[name], frame.of(position, name)
        spin = body.inertia * motion.velocities[name].angular ** 2
        amounts[name] = simplified(expanded((body.mass * v.dot(v) + spin) / 2))
        inertia += body.mass * v.dot(frame.inertia)
    brought = {"forces": power_in(position, frame), "forces of inertia": simplified(expanded(inertia))}
    entering = {s for e in brought.values() for s in e.free_symbols}
    if entering & unknown_sizes(position) or not knows_less(position, amounts.values()):
        return
    yield Balance(
        words="work and kinetic energy",
        name="T'",
        amounts=tuple((name, energy) for name, energy in amounts.items() if energy != 0),
        sources=tuple(Source(words, power) for words, power in brought.items() if power != 0),
        cost=1.1,
        heading="work and kinetic energy in the frame that moves with ",
        about=frame.point,
        explained=frame.words,
        letter="T'",
        bring="U'",
        adds=True,
        timeless=True,
        longest=500,
    )


def _closed(position: Position) -> bool:
    """Is there mass, none of it coming or going, and is all that does work in the scene?"""
    system, scene = position.system, position.system.scene
    if not any(b.mass != 0 for b in scene.bodies.values()):
        return False
    if any(b.varies for b in scene.bodies.values()):
        return False
    if any(p.kind == "drive" for p in system.pushes) or any(
        c.kind == "given" for c in system.acceleration_conditions()
    ):
        return False
    facts = [mode.facts for mode in system.modes.values()]
    if any(j.drift is not None for f in facts for j in f.joinings) or any(r.rate != 0 for f in facts for r in f.rows):
        return False
    carried = [t.linear for t in position.motion.velocities.values()]
    return not any(position.time in v.x.free_symbols | v.y.free_symbols for v in carried)


def _sources(position: Position) -> Iterator[tuple[Source, set[str]]]:
    """Weights first, then loads one by one, then the friction of what slips; each with the bodies that it acts on."""
    system, motion = position.system, position.motion
    assert system.reactions is not None
    named: dict[tuple[str, str], list[Wrench]] = {}
    for w in system.wrenches:
        named.setdefault((w.kind, w.name), []).append(w)
    loads: dict[tuple[str, str], list[Any]] = {}
    for x in acting_loads(system.scene.problem):
        loads.setdefault((x.kind, x.name), []).append(x)
    setting = MovingScene(system.scene, motion, position.value)
    for (kind, name), wrenches in named.items():
        power = sp.Add(*(_power(w, motion) for w in wrenches))
        # Those of one kind that the file calls alike are one source.
        alike = loads.get((kind, name), [])
        made = alike[0].stored(setting) if len(alike) == 1 else None
        stored = _stored_in(alike, setting)
        own = alike[0].short_name if len(alike) == 1 else name
        working = alike[0].working or alike[0].phrase(own).removeprefix("the ") if alike else FRICTION
        of = None if made is None else Stored(sp.sympify(made[0]), sp.sympify(made[1]), made[2], made[3])
        function = None if stored is None else -sp.sympify(stored)
        yield Source(working.format(name), power, function, of), {w.body for w in wrenches}
    followers = {law.push for law in system.laws}
    for push, value in system.reactions.pushes:
        if push.name not in followers or value == 0:
            continue
        parts = [a.force.dot(motion.velocity(a.point, a.body)) for a in push.actions if a.force is not None]
        parts += [a.couple * motion.velocities[a.body].angular for a in push.actions]
        yield Source(FRICTION.format(push.place), sp.Add(*parts) * value), {a.body for a in push.actions}


def _stored_in(loads: Sequence[Any], setting: MovingScene) -> sp.Expr | None:
    """The potential of all of them; None: one has none."""
    found = [x.potential(setting) for x in loads]
    return None if not found or any(e is None for e in found) else sp.Add(*found)


def _power(w: Wrench, motion: Motion) -> sp.Expr:
    force = w.force or Vec(sp.S.Zero, sp.S.Zero)
    return force.dot(motion.velocity(w.point, w.body)) + w.couple * motion.velocities[w.body].angular


def _ideal(position: Position, bodies: tuple[str, ...]) -> list[Push]:
    """The reactions on bodies that do no work in all: those of ideal joints, as far as they are not nought."""
    system = position.system
    followers = {law.push for law in system.laws}
    own = [p for p in system.pushes if any(a.body in bodies for a in p.actions)]
    drawn = [p for p in own if not guides_nothing(system, p)]
    return [p for p in drawn if p.name not in followers and p.kind != "drive"]


def _why_idle(position: Position, push: Push) -> str:
    """Why a reaction between a body and the ground does no work: its point rests, or it moves across the force."""
    system = position.system
    if push.kind == "tension":
        return _across(position, push) if len({a.body for a in push.actions}) == len(push.actions) else ""
    joinings = (j for mode in system.modes.values() for j in mode.facts.joinings if j.joint == push.joint)
    joining = next((j for j in joinings if GROUND in (j.mover, j.base)), None)
    if joining is None or joining.drift is not None:
        return ""
    if joining.path is not None:
        return _across(position, push) if any(a.force is not None for a in push.actions) else "no rotation"
    if not joining.turns:
        return "at rest"
    pinned = any(j.name == push.joint and j.kind == "pin" for j in system.scene.problem.joints)
    return f"{joining.place or 'the pin'} is fixed" if pinned else "the point of contact is at rest"


def _across(position: Position, push: Push) -> str:
    """Why a force on one body does no work: its point rests, as does the one in which a thread leaves a wheel that
    climbs it, or it moves across the force.
    """
    forces = [a for a in push.actions if a.body != GROUND]
    if len(forces) == 1 and _rests(position, position.motion.velocity(forces[0].point, forces[0].body)):
        body, scene = forces[0].body, position.system.scene
        own = [p for p, owners in scene.owners.items() if body in owners and scene.point(p) == forces[0].point]
        if own:
            centre = scene.bodies[body].center == forces[0].point
            return f"{own[0]} is at rest" if centre else f"the point {own[0]} of {body} is at rest"
    return "normal to the motion"


def _rests(position: Position, v: Vec) -> bool:
    """Is a velocity nil in itself, or by one of the conditions that the joints set?"""
    nil = [sp.S.Zero]
    for c in position.system.velocity_conditions():
        if isinstance(c.residual, Vec):
            nil += [c.residual.x, c.residual.y] if c.normal is None else []
        elif not c.now:
            nil.append(c.residual)
    return all(any(expanded(part - e) == 0 or expanded(part + e) == 0 for e in nil) for part in (v.x, v.y))


def _is_internal(push: Push) -> bool:
    """Does it act between bodies that can move?"""
    return len({a.body for a in push.actions} - {GROUND}) > 1
