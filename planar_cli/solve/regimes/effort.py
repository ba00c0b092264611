"""What a law of motion costs before it is used: the equations of kinetics from which it follows."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import letters
from planar_cli.solve.regimes.asked_kinetics import asks_kinetics
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.works_of_parts import works_of_parts

AT_HAND = -0.3
"""Of a constant acceleration between the only two states, where the equations of kinetics are asked for anyway: a
balance of energies would begin anew. So would it where these equations tell of bodies that move together that nothing
accelerates them.
"""
PER_EQUATION, FOR_ITSELF, OVER_TIME = 0.2, 0.5, 0.3
"""For each equation of kinetics; for each where nothing asks for a force, an acceleration or a time, or for no more
than a tension that the work on a part tells, so that they are written for the law alone; and where a force grows with
time.
"""


def effort(regime: Regime, f: sp.Expr) -> float:
    """The equations of kinetics behind a law, whether they are there anyway, and whether a force grows with time."""
    written = [w for stage in regime.general.stages for b in stage.blocks for w in b.equations]
    kinetic = sum(w.law in ("force", "moment") for w in written)
    problem = regime.general.instant.scene.problem
    alone = not asks_kinetics(problem.find) or bool(works_of_parts(regime))
    if kinetic and not alone and len(problem.states) == 2 and not letters(f) & set(regime.letters):
        return AT_HAND
    if kinetic > 1 and not alone and f == 0 and len(regime.free) == 1:
        return AT_HAND
    each = FOR_ITSELF if alone and kinetic > 1 else PER_EQUATION
    return each * kinetic + (OVER_TIME if kinetic and regime.time in letters(f) else 0.0)
