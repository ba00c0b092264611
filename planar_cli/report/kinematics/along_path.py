"""A relation of a place that the file gives by a formula: it is the component along the path of the point, where both
coordinates say the same.
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.solve.instant.stages import acceleration_unknowns
from planar_cli.solve.instant.written import Written

LONGEST = 400
"""Residuals of more operations are not compared."""
MOST = 6
"""More relations of velocities, or speeds, are not solved for this."""


def is_along_path(w: Written, system: System, level: str) -> bool:
    """Do both components of the relation vanish together with the one that is told, whatever the position?"""
    conditions = system.velocity_conditions() if level == "velocity" else system.acceleration_conditions()
    own = next((c for c in conditions if c.kind == "coordinate" and c.place == w.place), None)
    if own is None or not isinstance(own.residual, Vec):
        return False
    x, y = sp.sympify(own.residual.x), sp.sympify(own.residual.y)
    rates = [*system.scene.evaluator.speeds, *system.scene.evaluator.second_rates]
    moving = {*system.tree.velocity_unknowns(), *acceleration_unknowns(system), *rates}
    unknowns = sorted(w.residual.free_symbols & moving, key=lambda s: s.name)
    for letter in unknowns:
        along = Vec(x.diff(letter), y.diff(letter))
        if along.x == 0 and along.y == 0:
            continue
        across = x * along.y - y * along.x
        if longer(across, LONGEST):
            return False
        return identically_zero(across) or (level != "velocity" and identically_zero(_with_speeds(across, system)))
    return False


def on_path(w: Written, edges: Iterable[Edge]) -> str:
    """Along which path: that over the ground, or as a body sees it with which the point goes along."""
    rates = w.residual.free_symbols
    body = next((e.parent for e in edges if e.parent != GROUND and {e.slide, e.slide_rate} & rates), "")
    return f"along the path as seen from {body}" if body else "along the path"


def _with_speeds(across: sp.Expr, system: System) -> sp.Expr:
    """The same with the speeds that the relations of velocities give by others."""
    rows = [sp.sympify(row) for c in system.velocity_conditions() for row in c.rows()]
    rates = system.scene.evaluator.speeds
    speeds = [s for s in (*system.tree.velocity_unknowns(), *rates) if any(s in row.free_symbols for row in rows)]
    if len(rows) > MOST or len(speeds) > MOST:
        return across
    found = sp.solve(rows, speeds, dict=True)
    return across.xreplace(found[0]) if len(found) == 1 else across


def across_path(j: Joining, v: str) -> Line:
    """Why the component across the path of the base is taken. `v`: v of velocities, a of accelerations."""
    assert j.path is not None
    if j.path.curvature == 0:
        return line(f"across {j.base}, where ", Name(f"{v}_rel"), " has no component")
    if v == "v":
        return line("across the path, where ", Name("v_rel"), " has no component")
    return line("across the path, where ", Name("a_rel"), " is its normal part")
