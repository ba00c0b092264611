"""Where velocities alone are sought: a wheel that rolls on the ground turns about its point of contact.

disk rolls without slipping, C is at rest:   ω_disk = v_O/r = 1/0.1 = 10 rad/s   clockwise
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Paragraph, line
from planar_cli.report.kinematics.by_centre import centre_told
from planar_cli.report.kinematics.given_components import COMPONENT
from planar_cli.report.kinematics.told import Told
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written
from planar_cli.units import RATE, VELOCITY

SHORT = 3
"""An arm of more operations is told by the vector equation."""


def about_centre(w: Written, stage: Stage, stages: Sequence[Stage], told: Told, number: int) -> list[Block]:
    """A relation of velocities by a point of a body that is at rest; nothing where it is another."""
    return _rolled(w, stage, stages, told, number) or centre_told(w, stages, told, number)


def _rolled(w: Written, stage: Stage, stages: Sequence[Stage], told: Told, number: int) -> list[Block]:
    """ω = v_O/r of a wheel whose centre has a velocity that is given, by its size and the way it turns."""
    phrases, units = told.phrases, told.phrases.ledger.units
    alone = all(s.level == "velocity" for s in stages)
    if w.source != "given" or w.times or not alone or phrases.symbolic:
        return []
    edge = next((e for e in told.system.tree.edges if e.spin is not None and e.spin in w.residual.free_symbols), None)
    j = None if edge is None else edge.joining
    if edge is None or edge.spin is None or j is None or j.rolling is None or j.drift is not None:
        return []
    residual = sp.expand(w.residual)
    arm, speed = sp.diff(residual, edge.spin), residual.xreplace({edge.spin: sp.S.Zero})
    letter = speed.as_coeff_Mul()[1]
    given = COMPONENT.match(w.lead)
    if given is None or given[2] != centre_of(told.system.scene, edge.body):
        return []
    known = letter.is_Symbol and letter in units and units[letter].dimension == VELOCITY and speed in (letter, -letter)
    if GROUND not in (j.mover, j.base) or not known or longer(arm, SHORT) or arm.free_symbols & set(told.late):
        return []
    formula, omega = -speed / arm, phrases.certain(edge.spin)
    if phrases.certain(formula) != omega or omega <= 0 or formula.could_extract_minus_sign():
        return []
    value = phrases.of_dimension(omega, RATE, True)
    sense = "clockwise" if told.system.tree.turn((edge.body,)) < 0 else "counterclockwise"
    sides: tuple[Any, ...] = (
        phrases.math(edge.spin),
        phrases.math(formula),
        *phrases.substituted(formula, value),
        value,
    )
    return [
        Paragraph(line(f"{edge.body} rolls without slipping, {j.place} is at rest:")),
        Equation(sides, number, note=line(sense)),
    ]
