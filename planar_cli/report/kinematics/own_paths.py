"""The paths of particles that the file has: of vectors along a straight one, and across one that bends."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.scene.facts import Path
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.solve.solution import InstantSolution


def straight_path(instant: InstantSolution, body: str) -> Vec | None:
    """The direction of the straight line along which a body that is a particle moves; None: it has none."""
    path = _path(instant, body, bent=False)
    return None if path is None else path.tangent


def across_the_path(vector: Vec, instant: InstantSolution, body: str) -> tuple[Vec, sp.Expr] | None:
    """The direction of a vector across the path of a particle, and its size; None: it is not across that."""
    path = _path(instant, body, bent=True)
    if path is None:
        return None
    along, across = path.tangent, Vec(-path.tangent.y, path.tangent.x)
    if simplified(vector.x * along.x + vector.y * along.y) != 0:
        return None
    size = simplified(vector.x * across.x + vector.y * across.y)
    if size == 0:
        return None
    return (-across, -size) if size.could_extract_minus_sign() else (across, size)


def _path(instant: InstantSolution, body: str, bent: bool) -> Path | None:
    system = instant.trial.system
    if instant.instant.scene.rigid(body):
        return None
    joinings = (j for m in system.modes.values() for j in m.facts.joinings if (j.mover, j.base) == (body, GROUND))
    return next((j.path for j in joinings if j.path is not None and (j.path.curvature != 0) == bent), None)
