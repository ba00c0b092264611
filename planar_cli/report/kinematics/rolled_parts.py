"""The acceleration of the mass centre of a wheel out of balance, along the ground on which it rolls and across it.

a_G = a_O + α × r_G/O - ω² r_G/O = [R α - x_G ω², -x_G α]          m R α →,  m x_G α ↓,  m x_G ω² ←

Its arm from the point of contact has a length that nothing else on a page needs.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, line
from planar_cli.report.words.words import Phrases

SHORT, LONGEST = 5, 8
"""A distance, and a component, of more operations is not told so."""


def along_and_across(direction: Vec, turning: sp.Expr, system: System, body: str) -> list[tuple[Vec, sp.Expr]]:
    """The two parts of what turns with such a body; none where it does not roll on straight ground, or the parts are
    long.
    """
    tangent = rolls_along(system, body)
    if tangent is None:
        return []
    parts = [(way, simplified(direction.dot(way))) for way in (tangent, tangent.turned())]
    if any(longer(size, SHORT) or size.is_number for _, size in parts):
        return []
    return [
        (-way, -size * turning) if (size * turning).could_extract_minus_sign() else (way, size * turning)
        for way, size in parts
    ]


def rolls_along(system: System, body: str) -> Vec | None:
    """The direction of the straight ground on which a body rolls; None: there is none."""
    edge = next((e for e in system.tree.edges if e.body == body), None)
    j = edge.joining if edge is not None else None
    if j is None or j.rolling is None or j.drift is not None or {j.mover, j.base} != {body, GROUND}:
        return None
    base = j.rolling.base if j.mover == body else j.rolling.mover
    return j.rolling.tangent if system.scene.is_zero(base) else None


def told_by_axes(system: System, body: str, phrases: Phrases) -> tuple[Line, ...]:
    """The components of the acceleration of its mass centre, on level ground or upright; empty: they are long."""
    tangent, motion = rolls_along(system, body), system.motion
    if tangent is None or motion is None or 0 not in (tangent.x, tangent.y):
        return ()
    a = motion.acceleration(system.scene.center(body), body)
    parts = [simplified(sp.sympify(p)) for p in (a.x, a.y)]
    if 0 in parts or any(longer(p, LONGEST) or p.atoms(sp.Float) for p in parts):
        return ()
    return (line("[", phrases.math(parts[0]), ", ", phrases.math(parts[1]), "]"),)
