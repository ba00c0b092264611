"""Quantities over a blow: the impulses of joints and loads, their work, and what is lost.

    work of an impulse = J · (v_1 + v_2)/2        v_1, v_2 of the point where it acts, just before and just after

(An Introduction to Planar Dynamics, 3.4, 3.7; the work of all impulses is the change of the kinetic energy.)
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import sympy as sp

from planar_cli.equation.kinematics.motion import Twist
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.facts import Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.reactions import Reactions
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import record
from planar_cli.solve.between.equations.span_rates import moment_or_force, on_bodies
from planar_cli.solve.impulsive.impact import Blow

HALF = sp.Rational(1, 2)


@record
class MeanMotion:
    """The mean of the velocities just before and just after a blow."""

    blow: Blow

    def velocity(self, point: Vec, body: str) -> Vec:
        motion = self.blow.system.motion
        assert motion is not None
        found: Vec = (self.blow.scene.arriving(point, body) + motion.acceleration(point, body)) * HALF
        return found

    @property
    def velocities(self) -> dict[str, Twist]:
        motion = self.blow.system.motion
        assert motion is not None
        before = {GROUND: sp.S.Zero, **{b: t.angular for b, t in self.blow.scene.before.items()}}
        return {b: replace(t, angular=(t.angular + before[b]) * HALF) for b, t in motion.accelerations.items()}


def over_blow(blow: Blow, q: Quantity) -> sp.Expr:
    """A quantity over a blow in letters of its states; nothing for those that need time."""
    reactions = impulses(blow)
    found: sp.Expr = sp.S.Zero
    if q.word == "impulse":
        assert blow.system.motion is not None
        quantities = blow.system.quantities_of(blow.system.motion, reactions)
        found = moment_or_force(q, quantities, on_bodies(q, reactions))
    elif q.word == "work":
        found = _work(reactions.upon(q), MeanMotion(blow))
    elif q.word == "heat":
        name = q.things[0]
        joints = dict.fromkeys(reactions.joints.values()) if name == "all" else [name]
        own = [w for j in joints for w in reactions.acting(j) if w.name == j]
        found = -_work(own, MeanMotion(blow))
    return blow.here(found)


def impulses(blow: Blow) -> Reactions:
    """The impulses of joints and loads, without the momenta with which bodies arrive."""
    reactions = blow.system.reactions
    assert reactions is not None
    return replace(reactions, wrenches=tuple(w for w in reactions.wrenches if w.kind != "momentum"))


def _work(acting: Iterable[Wrench], mean: MeanMotion) -> sp.Expr:
    parts = []
    for w in acting:
        if w.force is not None:
            parts.append(w.force.dot(mean.velocity(w.point, w.body)))
        parts.append(w.couple * mean.velocities[w.body].angular)
    return sp.Add(*parts)
