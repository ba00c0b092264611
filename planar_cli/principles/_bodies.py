"""What principles say of every body: its family of equations, and how it moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import sympy as sp

from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.system.kinetics import body_residuals
from planar_cli.equation.system.led import led, rolls, turns_with_an_axis
from planar_cli.equation.system.system import System
from planar_cli.equation.values.parts_of_accelerations import axis_of, spin_of, with_mark
from planar_cli.principles.base import BodyFamily, Moving, Position


def body_families(position: Position) -> Iterator[BodyFamily]:
    """Σ F - m a_G along x and y, and Σ M - (r_G × m a_G + I_G α) about the origin."""
    for body in position.system.scene.bodies:
        yield BodyFamily(body, *body_residuals(position.system, body))


def moving_of(system: System, motion: Motion, bodies: Iterable[str]) -> Iterator[Moving]:
    """What kinetic energies and momenta are made of; a rotation that counts clockwise in its sense."""
    for name in bodies:
        body, center = system.scene.bodies[name], system.scene.center_name(name)
        v, omega = motion.velocity(body.center, name), motion.velocities[name].angular * motion.tree.turn((name,))
        why, place = led(system, name), (body.center.x, body.center.y)
        speeds = (v.x, v.y, omega)
        yield Moving(name, body.mass, body.inertia, *speeds, center, why, rolls(system, name), place)


def of_mass_centre(system: System, body: str, amount: sp.Expr) -> sp.Expr:
    """What the velocity of the mass centre brings to an energy or a moment of momentum: about a fixed axis it is what
    the parallel-axis theorem adds.
    """
    return with_mark(amount, axis_of(body)) if turns_with_an_axis(system, body) else amount


def of_turning(body: str, inertia: sp.Expr) -> sp.Expr:
    """The moment of inertia about the mass centre, in an energy or a moment of momentum."""
    return with_mark(inertia, spin_of(body))


def joined(position: Position) -> list[tuple[str, ...]]:
    """The bodies in groups: within one, reactions and loads join them; nothing acts between two groups."""
    system = position.system
    acting = [{a.body for a in push.actions} for push in system.pushes]
    loads: dict[tuple[str, str], set[str]] = {}
    for w in system.wrenches:
        loads.setdefault((w.kind, w.name), set()).add(w.body)
    groups: list[set[str]] = [{name} for name in system.scene.bodies]
    for together in (*acting, *loads.values()):
        met = [g for g in groups if g & together]
        groups = [g for g in groups if g not in met] + ([set().union(*met)] if met else [])
    order = list(system.scene.bodies)
    return sorted((tuple(sorted(g, key=order.index)) for g in groups), key=lambda g: order.index(g[0]))
