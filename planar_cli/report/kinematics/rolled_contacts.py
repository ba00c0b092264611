"""What two bodies that roll on each other say of each other where they touch.

Their points of contact have one velocity, and accelerations that agree along the contact alone. Across it these differ
by (ω_1 - ω_2)² ρ, as each outline bends away from the other; 1/ρ is the difference of their signed curvatures.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.led import turns_about_a_fixed_point
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.candidates import CONTACT
from planar_cli.solve.instant.written import Written
from planar_cli.units import LENGTH


def rolls_on_ground(j: Joining, own: Name, level: str, side: Line) -> Line:
    """What touches the ground does not slip. `own`: the velocity or acceleration there; `side`: the component."""
    if level == "velocity":
        return line(f"{j.mover} rolls: at {j.place} ", own, " = 0; ", side)
    return line(f"{j.mover} rolls: ", own, " has no component along the contact")


def on_fixed_axles(j: Joining, w: Written, level: str, system: System) -> Line:
    """`At C gear_A and gear_B have the same tangential acceleration`; "" where not both turn about fixed points."""
    turning = all(turns_about_a_fixed_point(system, body) for body in (j.mover, j.base))
    if level == "velocity" or j.rolling is None or w.words != CONTACT or not turning:
        return ()
    return line(f"At {j.place} {j.mover} and {j.base} have the same tangential acceleration:")


def rolls_on_body(j: Joining, w: Written, level: str, side: Line, spin: sp.Expr, phrases: Phrases) -> Line:
    """What touches another body does not slip on it. `spin`: ω of the one without that of the other."""
    partner = f"{j.mover} rolls on {j.base if j.base != GROUND else 'the belt'}: at {j.place} both have the same "
    if level == "velocity":
        return line(f"{partner}velocity; ", side)
    if w.words == CONTACT:
        return line(f"{partner}acceleration along the contact")
    if phrases.value.vanishes(spin):
        return line(f"{partner}acceleration; ", *side)
    both = line(f"{partner}acceleration along the contact")
    return line(*both, ", across it they differ by ", phrases.math(spin**2), " ρ, ", *_radius(j, phrases), "; ", *side)


def _radius(j: Joining, phrases: Phrases) -> Line:
    """ρ of the outlines together."""
    assert j.rolling is not None
    bend = simplified(j.rolling.mover - j.rolling.base)
    radius = simplified(1 / (bend if phrases.value(bend) > 0 else -bend))
    if phrases.symbolic:
        return line("ρ = ", phrases.math(radius))
    return line("ρ = ", phrases.of_dimension(phrases.value(radius), LENGTH))
