"""What a link or a taut cord between two points says of their velocities and accelerations."""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Line, Name, Paragraph, line
from planar_cli.report.kinematics.between_led import between_led
from planar_cli.report.notation.names import index_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.led import is_between_led
from planar_cli.solve.instant.written import Written
from planar_cli.units import ACCELERATION, LENGTH, VELOCITY


def tie_told(
    j: Joining, w: Written, level: str, named: str, system: System, phrases: Phrases, told: set[str]
) -> list[Block]:
    """`named`: what the tie is called; `level`: velocity or acceleration; `told`: keys of what stands on the page."""
    if is_between_led(j, system):
        key = f"length {j.joint}"
        times = "Differentiated" if level == "velocity" else "Differentiated twice"
        times = "Differentiated once more" if key in told else times
        told.add(key)
        normal = _normal(j, system, phrases) if level != "velocity" else ()
        return between_led(j, w, named, times, normal, system, phrases)
    return [Paragraph(line(*_words(j, level, named, system, phrases), ":"))]


def _words(j: Joining, level: str, named: str, system: System, phrases: Phrases) -> Line:
    keeps, own = f"{named} keeps its length", Name(f"{level[0]}_{index_of(j.place)}")
    if j.base == GROUND and level == "velocity":
        return line(f"{keeps}, so that along it ", own, " has no component")
    if j.base == GROUND:
        return line(f"{keeps}; along it ", own, f" is the normal acceleration of {j.place}")
    if level == "velocity":
        return line(f"{keeps}, so that along it the velocities of both ends agree")
    if not swings(j, system):
        return line(f"{keeps}, so that along it the accelerations of both ends agree")
    differ = f"{keeps}; along it the accelerations of its ends differ by v²/l of their relative motion"
    normal = _normal(j, system, phrases)
    return line(differ, *(line(", ", *normal) if normal else ()))


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
    """(0.8² + 0.6²)/0.5 = 2 m/s², where the velocities are known."""
    velocity, arm = _relative(j, system)
    known = [phrases.value.known(sp.sympify(p)) for p in (velocity.x, velocity.y, sp.sqrt(arm.dot(arm)))]
    x, y, length = (k if k is not None else Decimal(0) for k in known)
    if phrases.symbolic or None in known or not length or not (x and y):
        return ()
    numbers = [phrases.of_dimension(abs(n), d).number for n, d in ((x, VELOCITY), (y, VELOCITY), (length, LENGTH))]
    first, second, below = (significant(n, phrases.figures) for n in numbers)
    value = phrases.of_dimension((x * x + y * y) / length, ACCELERATION)
    return line(f"({first}² + {second}²)/{below} = ", value)
