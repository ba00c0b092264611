"""The kinetic energy of a body that turns about a fixed point at once, by the parallel axes, where a balance has
several bodies: T of crank = 1/2 (I_crank + m_c (r_c/2)²) ω².
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.principles.base import Moving
from planar_cli.report.energy.energy_pieces import EnergyPieces
from planar_cli.report.kinetics.inertias import inertia_of
from planar_cli.units import LENGTH

TURNS = " turns about "
"""Says of a body why its mass centre has its velocity."""


def by_parallel_axes(
    pieces: EnergyPieces, made: Moving, speeds: Sequence[tuple[str, sp.Symbol, sp.Expr]]
) -> sp.Expr | None:
    """(I + m d²) ω²/2, d from the fixed point to the mass centre; None: the body has no such point, letters alone do
    not tell it, or an equal body, that is told alike, may have none [J]. `speeds`: of the mass centre, and of turning.
    """
    (_, _, v), *more = speeds
    if len(more) != 1 or TURNS not in made.why or made.resting is not None or not more[0][2].is_Symbol:
        return None
    others = pieces.balance.parts.moving if pieces.balance.parts is not None else ()
    inertia = inertia_of(made.body, made.inertia, pieces.phrases)
    if not inertia.is_Symbol or any(m.body != made.body and m.mass == made.mass for m in others):
        return None
    _, own, omega = more[0]
    arm = simplified(v / omega)
    if arm.has(sp.Abs, sp.sign) or arm.free_symbols & set(pieces.unknowns) or not pieces.is_short(arm, LENGTH):
        return None
    whole = sp.Add(inertia, made.mass * arm**2, evaluate=False)
    return sp.Mul(sp.Rational(1, 2), whole, own**2, evaluate=False)
