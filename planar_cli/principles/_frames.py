"""Frames that do not turn and move with a point: the mass centre of all, or a body whose motion is prescribed.

In such a frame the laws of a system take up the force of inertia -m a_C of every body; where C is the mass centre of
the system it brings neither moment nor work, whatever the acceleration of C is.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Position
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record

ZERO = Vec(sp.S.Zero, sp.S.Zero)


@record
class Frame:
    """A frame, and a system that is looked at in it."""

    point: str
    """The name of its point C."""
    place: Vec
    velocity: Vec
    inertia: Vec
    """-a_C, the force of inertia per mass; zero in the frame of the mass centre, where all of it cancels."""
    bodies: tuple[str, ...]
    """The system."""
    acting: tuple[Wrench, ...]
    """What acts on it, forces between its bodies included."""
    words: str = ""
    """What its point is, where that has no name in the file."""

    def of(self, position: Position, body: str) -> tuple[Vec, Vec]:
        """Place and velocity of the mass centre of a body in it."""
        center = position.system.scene.bodies[body].center
        return center - self.place, position.motion.velocity(center, body) - self.velocity


def frames(position: Position) -> Iterator[Frame]:
    """None where a mass comes or goes."""
    system, scene = position.system, position.system.scene
    if system.reactions is None or any(b.varies for b in scene.bodies.values()):
        return
    acting = tuple(w for w in system.reactions.acting("all") if w.body != GROUND)
    yield from _of_mass_centre(position, acting)
    yield from _driven(position, acting)


def _of_mass_centre(position: Position, acting: tuple[Wrench, ...]) -> Iterator[Frame]:
    """Of all bodies where nothing unknown acts from outside: with a reaction from there, what is seen from the mass
    centre knows no less of it than what is seen from the ground.
    """
    scene = position.system.scene
    heavy = {n: b for n, b in scene.bodies.items() if b.mass != 0}
    outside = resultant(acting)
    if len(heavy) < 2 or (outside.x.free_symbols | outside.y.free_symbols) & unknown_sizes(position):
        return
    whole = sp.Add(*(b.mass for b in heavy.values()))
    place, velocity = ZERO, ZERO
    for name, body in heavy.items():
        place += body.center * (body.mass / whole)
        velocity += position.motion.velocity(body.center, name) * (body.mass / whole)
    taken = {*scene.points, *scene.bodies, *(scene.center_name(b) for b in scene.bodies)}
    letter = "cm" if "G" in taken else "G"
    yield Frame(letter, place, velocity, ZERO, tuple(scene.bodies), acting, ", the mass centre of all")


def _driven(position: Position, acting: tuple[Wrench, ...]) -> Iterator[Frame]:
    """Of all that is not driven itself, seen from bodies that move in a prescribed way without turning."""
    system, scene, motion = position.system, position.system.scene, position.motion
    driven = {a.body for p in system.pushes if p.kind == "drive" for a in p.actions}
    others = tuple(b for b in scene.bodies if b not in driven)
    if not any(scene.bodies[b].mass != 0 for b in others):
        return
    own = tuple(w for w in acting if w.body in others)
    for name in (b for b in scene.bodies if b in driven and motion.velocities[b].angular == 0):
        center = scene.bodies[name].center
        v, a = motion.velocity(center, name), motion.acceleration(center, name)
        yield Frame(scene.center_name(name) or name, center, v, -a, others, own)


def unknown_sizes(position: Position) -> set[sp.Symbol]:
    """The letters of reactions that no law ties to another."""
    followers = {law.push for law in position.system.laws}
    return {position.system.symbols[p.name] for p in position.system.pushes if p.name not in followers}


def knows_less(position: Position, amounts: Iterable[sp.Expr]) -> bool:
    """Do not all velocities enter? Else the same amounts seen from the ground are the shorter ones."""
    entering = {s for e in amounts for s in e.free_symbols}
    return not entering.issuperset(
        s for s in position.motion.tree.velocity_unknowns() if s not in position.motion.known
    )


def resultant(wrenches: Iterable[Wrench]) -> Vec:
    """The sum of their forces."""
    forces = [w.force for w in wrenches if w.force is not None]
    return Vec(expanded(sp.Add(*(f.x for f in forces))), expanded(sp.Add(*(f.y for f in forces))))


def power_in(position: Position, frame: Frame) -> sp.Expr:
    """The work per time of all that acts on the system, as the frame sees it."""
    power, motion = sp.S.Zero, position.motion
    for w in frame.acting:
        power += w.couple * motion.velocities[w.body].angular
        if w.force is not None:
            power += w.force.dot(motion.velocity(w.point, w.body) - frame.velocity)
    return simplified(expanded(power))
