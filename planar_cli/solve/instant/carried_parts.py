"""The acceleration of a particle that slides along a body that turns, part by part as it is drawn.

    a_P = s" t + 2 ω s' n + κ s'² n  +  a_P′,      a_P′ = α r e_t - ω² r e_r  about a pivot at rest

Along the track, Coriolis and normal part across it, and what the turning body has there (An Introduction to Planar
Dynamics, 2.4). In one lump their resultant has a direction that nobody sees.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer, tidy, trigonometric
from planar_cli.equation.system.system import System
from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, NORMAL, TANGENTIAL, with_mark
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.instant.drawn_ways import guided

LONGEST = 4
"""A distance of more operations is not taken out of an arm."""

Part = tuple[Vec, sp.Expr]


def carried_parts(system: System, body: str, vanishes: Callable[[sp.Expr], bool]) -> list[Part]:
    """Directions, unit vectors where their lengths are short, with the components; none: it is no such particle, or
    the body on which it slides does not turn about a point at rest.
    """
    motion, joining = system.motion, guided(system, body)
    if motion is None or joining is None or joining.base == GROUND or joining.pace is not None:
        return []
    if joining.drift is not None or motion.accelerations[joining.base].linear != Vec(sp.S.Zero, sp.S.Zero):
        return []
    if motion.velocities[joining.base].angular == 0 and motion.accelerations[joining.base].angular == 0:
        return []
    return [(way, part) for way, part in _parts(system, body, joining, vanishes) if not vanishes(part)]


def _parts(system: System, body: str, joining: Joining, vanishes: Callable[[sp.Expr], bool]) -> Iterator[Part]:
    motion, path = system.motion, joining.path
    edge = next(e for e in system.tree.edges if e.body == body)
    assert motion is not None
    assert path is not None
    assert edge.slide is not None
    speed = motion.known.get(edge.slide, edge.slide)
    omega, alpha = motion.velocities[joining.base].angular, motion.accelerations[joining.base].angular
    along, across = path.tangent, path.tangent.turned()
    yield along, sp.sympify(edge.slide_rate)
    yield across, with_mark(2 * speed * omega, CORIOLIS)
    yield across, with_mark(path.curvature * speed**2, NORMAL)
    unit, distance = _arm(system, joining, along, vanishes)
    yield unit.turned(), with_mark(alpha * distance, TANGENTIAL)
    yield -unit, with_mark(omega**2 * distance, NORMAL)


def _arm(system: System, joining: Joining, along: Vec, vanishes: Callable[[sp.Expr], bool]) -> tuple[Vec, sp.Expr]:
    """From the pivot to the particle: a unit vector and the distance; with a long distance the arm itself."""
    motion = system.motion
    assert motion is not None
    arm = motion.arm(motion.accelerations[joining.base].point, joining.point)
    for way in (along, along.turned()):
        if vanishes(arm.cross(way)):
            distance = trigonometric(tidy(arm.dot(way)))
            if longer(distance, LONGEST):
                break
            return (-way, -distance) if system.scene.sign(distance) < 0 else (way, distance)
    length = system.scene.length(arm)
    return (arm, sp.S.One) if longer(length, LONGEST) else (Vec(tidy(arm.x / length), tidy(arm.y / length)), length)
