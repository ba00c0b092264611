"""What a link or a taut cord between two points says of their velocities and accelerations."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.plain import identically_zero
from planar_cli.equation.system import System
from planar_cli.problem.facts import Joining
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND
from planar_cli.report.blocks import Line, Name, line
from planar_cli.report.numbers import significant
from planar_cli.report.words import Phrases
from planar_cli.units import ACCELERATION, LENGTH, VELOCITY


def tie_words(j: Joining, level: str, named: str, own: Name, system: System, phrases: Phrases) -> Line:
    """`named`: what the tie is called; `level`: velocity or acceleration; `own`: that of its mover's end."""
    keeps = f"{named} keeps its length"
    if j.base == GROUND and level == "velocity":
        return line(f"{keeps}, so that along it ", own, " has no component")
    if j.base == GROUND:
        return line(f"{keeps}; along it ", own, f" is the normal acceleration of {j.place}")
    if level == "velocity":
        return line(f"{keeps}, so that along it the velocities of both ends agree")
    if not swings(j, system):
        return line(f"{keeps}, so that along it the accelerations of both ends agree")
    differ = f"{keeps}; along it the accelerations of its ends differ by v²/l of their relative motion"
    return line(differ, *_normal(j, system, phrases))


def swings(j: Joining, system: System) -> bool:
    """Is it a tie between two bodies one of whose ends may move across it, seen from the other?"""
    tied = any(push.kind == "tension" for push in system.modes[j.joint].facts.pushes)
    if j.path is None or j.base == GROUND or not tied:
        return False
    return not identically_zero(j.path.tangent.dot(_relative(j, system)[0]))


def _relative(j: Joining, system: System) -> tuple[Vec, Vec]:
    """The velocity and the place of the mover's end, seen from the other."""
    assert system.motion is not None
    far = system.scene.point(j.far) if j.far else j.point
    return system.motion.velocity(j.point, j.mover) - system.motion.velocity(far, j.base), j.point - far


def _normal(j: Joining, system: System, phrases: Phrases) -> Line:
    """, (0.8² + 0.6²)/0.5 = 2 m/s², where the velocities are known."""
    velocity, arm = _relative(j, system)
    known = [phrases.value.known(sp.sympify(p)) for p in (velocity.x, velocity.y, sp.sqrt(arm.dot(arm)))]
    x, y, length = (k if k is not None else Decimal(0) for k in known)
    if phrases.symbolic or None in known or not length or not (x and y):
        return ()
    numbers = [phrases.of_dimension(abs(n), d).number for n, d in ((x, VELOCITY), (y, VELOCITY), (length, LENGTH))]
    first, second, below = (significant(n, phrases.figures) for n in numbers)
    value = phrases.of_dimension((x * x + y * y) / length, ACCELERATION)
    return line(f", ({first}² + {second}²)/{below} = ", value)
