"""Natural components in letters: a_t = (ẋ ẍ + ẏ ÿ)/v, a_n = |ẋ ÿ - ẏ ẍ|/v, ρ = v²/a_n, each with what it comes to."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.curves.by_coordinates import DOTS
from planar_cli.solve.passages import Row
from planar_cli.units import LENGTH, TIME

LONGEST = 40
"""Longer ones are told by their formula alone, where the answer stands."""


def natural_rows(
    point: str, rates: tuple[Vec, Vec], wanted: Collection[str], clean: Callable[[sp.Expr], sp.Expr]
) -> Iterator[Row]:
    """`rates`: velocity and acceleration in letters; `wanted`: t, n, rho, and v where the speed is told here; `clean`:
    writes a formula as an answer does.
    """
    dx, dy, ddx, ddy = (sp.Symbol(f"{axis}_{point}{d}", real=True) for d in DOTS[1:] for axis in "xy")
    v, a_t, a_n, rho = (
        sp.Symbol(name, real=True) for name in (f"v_{point}", f"a_{point}_t", f"a_{point}_n", f"rho_{point}")
    )
    velocity, acceleration = rates
    speed = clean(sp.sqrt(simplified(velocity.dot(velocity))))
    if speed == 0:
        return
    across = clean(sp.Abs(simplified(velocity.cross(acceleration))) / speed)
    told = [("v", v, sp.sqrt(dx**2 + dy**2), speed, 1)]
    told += [("t", a_t, (dx * ddx + dy * ddy) / v, clean(velocity.dot(acceleration) / speed), 2)]
    told += [("n", a_n, sp.Abs(dx * ddy - dy * ddx) / v, across, 2)]
    told += [("rho", rho, v**2 / a_n, clean(speed**2 / across), 0)] if across != 0 else []
    needed = {*wanted, *(("n",) if "rho" in wanted else ())}
    for kind, symbol, formula, value, n in told:
        if kind in needed and not longer(value, LONGEST):
            yield Row("", (symbol, formula, value), Valuation({}).known(value), LENGTH / TIME**n)
