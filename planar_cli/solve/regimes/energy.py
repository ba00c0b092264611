"""The balance of energy of a regime: what the kinetic energy is, and the power of everything that acts."""

from __future__ import annotations

import sympy as sp

from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.regimes.general import General


def balance_of(general: General) -> tuple[sp.Expr, sp.Expr] | None:
    """T = Σ m v²/2 + I ω²/2 and P = Σ F · v + M ω over loads and friction; ideal joints do no work.

    None where it does not give the equation of motion: without mass, with mass that varies, with several freedoms, or
    where something unknown drives the scene. (An Introduction to Planar Dynamics, 4.4.)
    """
    scene, system = general.instant.scene, general.trial.system
    if len(general.free) != 1 or system.reactions is None or not any(b.mass != 0 for b in scene.bodies.values()):
        return None
    if any(b.varies for b in scene.bodies.values()):
        return None
    if any(p.kind == "drive" for p in system.pushes):
        return None
    if any(c.kind == "given" for c in system.acceleration_conditions()):
        return None
    energy, power = _kinetic(general), _power(general)
    return None if general.time in (energy.free_symbols | power.free_symbols) else (energy, power)


def _kinetic(general: General) -> sp.Expr:
    motion = general.quantities.motion
    parts = []
    for name, body in general.instant.scene.bodies.items():
        v, omega = motion.velocity(body.center, name), motion.velocities[name].angular
        parts.append(body.mass * v.dot(v) / 2 + body.inertia * omega**2 / 2)
    return sp.Add(*parts)


def _power(general: General) -> sp.Expr:
    """Of all loads, and of the pushes that follow a law of friction."""
    motion, system = general.quantities.motion, general.trial.system
    assert system.reactions is not None
    parts: list[sp.Expr] = []
    for w in system.wrenches:
        force = w.force or Vec(sp.S.Zero, sp.S.Zero)
        parts.append(force.dot(motion.velocity(w.point, w.body)) + w.couple * motion.velocities[w.body].angular)
    followers = {law.push for law in system.laws}
    for push, value in system.reactions.pushes:
        for act in push.actions if push.name in followers else ():
            if act.force is not None:
                parts.append(act.force.dot(motion.velocity(act.point, act.body)) * value)
            parts.append(act.couple * value * motion.velocities[act.body].angular)
    return sp.Add(*parts)
