"""Nonlinear relations between accelerations and forces as linear ones, where a branch of a search has found these."""

from __future__ import annotations

from collections.abc import Container
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import letters
from planar_cli.equation.kinematics.motion import Motion
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.tangent import Tangent, tangent


def tangent_in(
    expr: sp.Expr,
    keys: Container[sp.Symbol],
    system: System,
    free: Motion,
    value: Valuation,
    known: dict[sp.Symbol, Decimal],
) -> Tangent | None:
    """A relation over the accelerations of a free motion and over other unknowns (all are `keys`), to first order where
    the unknowns of the system are `known`; None where these do not tell them all.
    """
    assert system.motion is not None
    own: dict[sp.Symbol | None, sp.Expr] = {}
    for edge in free.tree.edges:
        a = system.motion.acceleration(system.scene.bodies[edge.body].center, edge.body)
        turning = system.motion.accelerations[edge.body].angular
        own |= {edge.slide_rate: a.x, edge.rise_rate: a.y, edge.spin_rate: turning}
    numbers = value.extended(known)
    there: dict[sp.Symbol, Decimal] = {}
    for x in sorted((x for x in letters(expr) if x in keys), key=lambda x: x.name):
        found = numbers.known(own.get(x, x))
        if found is None:
            return None
        there[x] = found
    return tangent(expr, there, value)
