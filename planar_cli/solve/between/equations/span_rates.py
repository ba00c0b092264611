"""What is integrated over a span: rates of work, impulse and heat, speeds, and whatever a mean is taken of."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.errors import refuse
from planar_cli.loads.base import Load
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.scene.acting import kind_of
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Reader


def rates_of(q: Quantity, reader: Reader) -> tuple[sp.Expr, ...]:
    """The expressions that one quantity over a span needs, in the unknowns of the general position.

    One rate; for a path length the two components of the velocity; for a count the residuals of the relation; for the
    impulse of everything on a body no rate, but what it changes.
    """
    quantities = reader.quantities()
    match q.word:
        case "path_length":
            v = quantities.any(replace(q, word="v", parts=(), at=None))
            assert isinstance(v, Vec)
            return v.x.value, v.y.value
        case "mean":
            assert q.argument is not None
            assert not isinstance(q.argument, Relation)
            return (_part(reader.any(q.argument), q),)
        case "count":
            assert isinstance(q.argument, Relation)
            return tuple(parts[1] for parts in reader.relation(q.argument))
        case "work":
            return (quantities.scalar(replace(q, word="power", at=None)).value,)
        case "heat":
            return (_heat(q.things[0], quantities, reader.regime),)
    return changed_by(q, quantities) or (_push(q, quantities),)


def changed_by(q: Quantity, quantities: Quantities) -> tuple[sp.Expr, ...]:
    """What the impulse of everything on a body, or on all of them, changes: its momentum, or that about a point at rest
    or about the mass centre. Nothing: it is the impulse of a part of it, about a moving point, or a body that grows.
    """
    if q.word != "impulse":
        return ()
    scene, (name, *about) = quantities.scene, q.things
    bodies = scene.bodies if name == "all" else {name: scene.bodies[name]} if name in scene.bodies else {}
    if not bodies or any(b.varies for b in bodies.values()):
        return ()
    if q.parts:
        return (_part(quantities.any(replace(q, word="momentum", parts=(), at=None)), q),)
    still = scene.owner(about[0]) == GROUND and about[0] not in scene.bodies
    if not still and (name == "all" or about[0] not in (name, scene.center_name(name))):
        return ()
    return (quantities.scalar(replace(q, word="H", at=None)).value,)


def _part(found: Any, q: Quantity) -> sp.Expr:
    if isinstance(found, Vec):
        found = found.x if q.parts[0].kind == "x" else found.y
    value: sp.Expr = found.value
    return value


def _reactions(quantities: Quantities, q: Quantity) -> Reactions:
    if quantities.reactions is None:
        raise refuse(q.mark, "PL555", f"{q.word}(…) can not stand here", "forces are not known before the motion is")
    return quantities.reactions


def _push(q: Quantity, quantities: Quantities) -> sp.Expr:
    """The component of a force, or its moment about a point: what an impulse is made of."""
    return moment_or_force(q, quantities, on_bodies(q, _reactions(quantities, q)))


def moment_or_force(q: Quantity, quantities: Quantities, acting: list[Wrench]) -> sp.Expr:
    """Σ of the component of what acts that `q` names, or of its moments about the point of `impulse(f/P)`."""
    if q.parts:
        forces = [w.force for w in acting if w.force is not None]
        return sp.Add(*(f.x if q.parts[0].kind == "x" else f.y for f in forces))
    place = quantities.place(q.things[1])
    center = Vec(place.x.value, place.y.value)
    arms = [(w.point - center).cross(w.force) for w in acting if w.force is not None]
    return sp.Add(*arms, *(w.couple for w in acting))


def on_bodies(q: Quantity, reactions: Reactions) -> list[Wrench]:
    """What acts on bodies that move; of a joint or load on the body whose partner is the ground."""
    name = q.things[0]
    acting = [w for w in reactions.acting(name) if w.body != GROUND]
    if len(q.things) == 2 and any(w.body == q.things[1] for w in acting) and name not in (q.things[1], "all"):
        return [w for w in acting if w.body == q.things[1]]
    bodies = {w.body for w in acting}
    owned = name == "all" or name in bodies
    if not owned and len(bodies) > 1:
        text = f"impulse({name}) acts on several bodies: {', '.join(sorted(bodies))}"
        raise refuse(q.mark, "PL559", text, "ask the impulse of everything on one of them, `impulse(b)`")
    return [w for w in acting if name not in bodies or w.body == name]


def _heat(name: str, quantities: Quantities, regime: Regime) -> sp.Expr:
    """What a joint, or everything, takes out of the motion: minus the power of all that it does, on both sides."""
    reactions = quantities.reactions
    assert reactions is not None
    if name != "all":
        return _lost(name, quantities, reactions, regime)
    joints = dict.fromkeys(reactions.joints.values())
    loads = [w for w in reactions.wrenches if (kind_of(w) or Load).dissipates]
    parts = [_lost(j, quantities, reactions, regime) for j in joints]
    return sp.Add(*parts, *(-_power(w, quantities) for w in loads))


def _lost(joint: str, quantities: Quantities, reactions: Reactions, regime: Regime) -> sp.Expr:
    """Minus the power of a joint; a belt, which is no body, moves with the rate of the row that measures the slip."""
    # A load that is called by the same point is none of the joint's own.
    loads = [w for w in reactions.wrenches if kind_of(w) is not None]
    own = [w for w in reactions.acting(joint) if w.name == joint and w not in loads]
    parts = [-_power(w, quantities) for w in own]
    motion = quantities.motion
    for push, expr in reactions.pushes:
        mode = regime.general.trial.system.modes.get(push.joint)
        if reactions.joints.get(push.joint) != joint or push.kind != "friction" or mode is None or mode.sliding is None:
            continue
        row = mode.sliding
        if row.rate != 0:
            pushed = [(a.force, motion.velocity(a.point, a.body)) for a in push.actions if a.force is not None]
            along = sp.Add(*(force.dot(v) for force, v in pushed))
            same = identically_zero(along - motion.row_velocity(row) - row.rate)
            parts.append(expr * row.rate if same else -expr * row.rate)
    return sp.Add(*parts)


def _power(w: Wrench, quantities: Quantities) -> sp.Expr:
    motion = quantities.motion
    spin = w.couple * motion.velocities[w.body].angular
    return spin if w.force is None else w.force.dot(motion.velocity(w.point, w.body)) + spin
