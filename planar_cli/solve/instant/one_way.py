"""Vector conditions that say the same along x and along y, wherever the bodies are.

A body that sticks to another, on a path that is written with a coordinate, can only be slower or faster along that
path: v_P = v_P' has one direction in every position. As two equations, with the position sought, the second one would
count as a fact about the position, and with it what only follows from the first one differentiated, R ω² = R φ̇².
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.system.conditions import Condition
from planar_cli.problem.scene.geometry import Vec


def along_paths(
    velocities: Sequence[Condition], accelerations: Sequence[Condition], speeds: frozenset[sp.Symbol]
) -> tuple[list[Condition], list[Condition]]:
    """The conditions, each that has one direction in every position taken along it only.

    `speeds`: the unknown velocities. An acceleration follows the velocity that it is the rate of: across that direction
    its condition holds wherever that of the velocity is kept.
    """
    directions = {_name(c): n for c in velocities if (n := _direction(c, speeds)) is not None}
    first, second = ([_along(c, directions.get(_name(c))) for c in level] for level in (velocities, accelerations))
    return first, second


def _name(condition: Condition) -> tuple[str, str, str, str]:
    return condition.kind, condition.text, condition.place, condition.body


def _along(condition: Condition, direction: Vec | None) -> Condition:
    whole = isinstance(condition.residual, Vec) and condition.normal is None
    return replace(condition, normal=direction) if whole and direction is not None else condition


def _direction(condition: Condition, speeds: frozenset[sp.Symbol]) -> Vec | None:
    """The unit vector along which the condition lies in every position; None where there is no such direction."""
    if not isinstance(condition.residual, Vec) or condition.normal is not None:
        return None
    try:
        forms = [linear_form(e, speeds) for e in condition.rows()]
    except Nonlinear:
        return None
    inside = sorted({s for f in forms for s in f.terms}, key=lambda s: s.name)
    parts = [tuple(f.terms.get(s, sp.S.Zero) for f in forms) for s in inside]
    x, y = next(((a, b) for a, b in parts if a != 0 and b != 0), (sp.S.Zero, sp.S.Zero))
    parts.append((forms[0].constant, forms[1].constant))
    if x == 0 or any(simplified(a * y - b * x) != 0 for a, b in parts):
        return None
    size = simplified(sp.sqrt(simplified(x**2 + y**2)))
    return Vec(x / size, y / size)
