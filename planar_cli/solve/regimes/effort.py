"""What a law of motion costs before it is used: the equations of kinetics from which it follows."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.conditions import ACCELERATION, ORDERS
from planar_cli.equation.plain import letters
from planar_cli.problem.expression import Name, Quantity
from planar_cli.problem.scene import Problem
from planar_cli.problem.walk import walk
from planar_cli.solve.regimes.regime import Regime

AT_HAND = -0.3
"""Of a constant acceleration between the only two states, where the equations of kinetics are asked for anyway: a
balance of energies would begin anew.
"""
PER_EQUATION, FOR_ITSELF, OVER_TIME = 0.2, 0.5, 0.3
"""For each equation of kinetics; for each where nothing asks for a force, an acceleration or a time, so that they are
written for the law alone; and where a force grows with time.
"""


def effort(regime: Regime, f: sp.Expr) -> float:
    """The equations of kinetics behind a law, whether they are there anyway, and whether a force grows with time."""
    written = [w for stage in regime.general.stages for b in stage.blocks for w in b.equations]
    kinetic = sum(w.law in ("force", "moment") for w in written)
    problem = regime.general.instant.scene.problem
    alone = not asks_kinetics(problem)
    if kinetic and not alone and len(problem.states) == 2 and not letters(f) & set(regime.letters):
        return AT_HAND
    each = FOR_ITSELF if alone and kinetic > 1 else PER_EQUATION
    return each * kinetic + (OVER_TIME if kinetic and regime.time in letters(f) else 0.0)


def asks_kinetics(problem: Problem) -> bool:
    """Is a force, an acceleration or a time asked, or something else for which the equations of kinetics are needed?"""
    nodes = [n for f in problem.find for n in walk(f.found.what)]
    if any(isinstance(n, Name) and n.name == "t" for n in nodes):
        return True
    return any(isinstance(n, Quantity) and ORDERS.get(n.word, ACCELERATION) >= ACCELERATION for n in nodes)
