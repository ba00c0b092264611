"""A drawn angle that a state gives as another number of turns: the direction is the drawn one, the angle is not."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.values.exact import PI
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.regimes.equations import Equation

CLOSE = 1e-6
"""Turns that are nearer to a whole number than this are whole."""


def turns_off(course: MotionEquations, stated: Equation, equations: Iterable[Equation]) -> int:
    """By how many whole turns a statement about drawn angles misses them; 0: by none, or it is about something else."""
    units, here = course.ledger.units, dict[sp.Symbol, sp.Expr]()
    for e in equations:
        if e.kind == "drawn":
            here |= {s: s - e.residual for s in e.residual.free_symbols & set(course.first.letters.values())}
    inside = stated.residual.free_symbols & here.keys()
    if not inside or not all(s in units and units[s].angle for s in inside):
        return 0
    off = course.base().known(stated.residual.xreplace(here))
    turns = 0.0 if off is None else float(off / (2 * PI))
    return round(turns) if abs(turns - round(turns)) < CLOSE else 0
