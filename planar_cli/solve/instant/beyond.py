"""Whether what is to be largest is bounded where an assumption reaches its limit: a little beyond the assumption fails.

A block that friction wedges in reaches its limit at the smallest push, and at no largest one: the formula of the limit
is the same, and only what lies beyond tells them apart.
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.implied.not_negative import not_negative
from planar_cli.problem.language.expression import Extreme
from planar_cli.solve.instant.seeker import Seeker, Sought
from planar_cli.solve.instant.study import solve_velocities
from planar_cli.solve.instant.worked import unknowns_of

STEP = Decimal("1e-12")
"""So much a constant is changed, as a part of it: far more than the rounding of sixty digits."""
STILL = " still"
"""How the objection ends that X may go beyond."""


def not_bounded(seeker: Seeker, sought: Sought, side: sp.Expr, extreme: Extreme) -> str:
    """What speaks against a limit at which X = `side` is to be extreme: X may go beyond. "": nothing does, or that is
    not told, as more than one constant is sought.
    """
    constants = seeker.ledger.sought
    solved = sought.branch.algebra.value.values
    if sought.objective is None or len(constants) != 1 or constants[0] not in solved:
        return ""
    found = solved[constants[0]]
    step = STEP * max(abs(found), Decimal(1))
    sized = constants[0].name in not_negative(seeker.scene.problem)
    for near in (found + step, found - step):
        if sized and near < 0:
            continue
        there = _objective(seeker, near, side)
        if there is not None and extreme.sense * (there - sought.objective) > step * STEP:
            return f"{extreme.text.split(' is ')[0]} may be {'larger' if extreme.sense > 0 else 'smaller'}{STILL}"
    return ""


def _objective(seeker: Seeker, constant: Decimal, side: sp.Expr) -> Decimal | None:
    """X with this number of the constant that is sought; None where an assumption fails, or speeds are open."""
    instant, symbol = seeker.instant, seeker.ledger.sought[0]
    value: Valuation = seeker.scene.valuations[0].knowing({symbol: constant})
    speeds = solve_velocities(seeker.system, value, instant.at_rest, seek=False)
    if speeds.free or speeds.nonlinear or speeds.conflict:
        return None
    trial = instant.try_choice(seeker.choice, (value,), given={**speeds.values, symbol: constant})
    if trial.objection or not trial.outcomes:
        return None
    outcome = trial.outcomes[0]
    return outcome.value.extended({**unknowns_of(trial.system, outcome), symbol: constant})(side)
