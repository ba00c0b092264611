"""The force of a guide whose line of action a page does not tell: a body that cannot turn is held by it and by a
couple, and where no equation has that couple, both together are one force beside the named point.

    cart:  M g ↓ at K,  F → at K,  N_cart ↑ (its line not needed),  N_A ↓ at A   =   M a_K → at K

At the point itself the moments of such a diagram would not balance.
"""

from __future__ import annotations

from collections.abc import Collection
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Action, Push
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.instant.instant import Trial

NOT_NEEDED = " (its line not needed)"


@record
class OpenLine:
    """`beside`: how far from the named point of the guide the force acts [m], along its track as the normal turned
    clockwise by a quarter has it; None: the numbers do not tell it, or it is a couple alone.
    """

    beside: Decimal | None

    def place(self, action: Action) -> Vec:
        """Where the force is drawn."""
        if self.beside is None or action.force is None:
            return action.point
        along: Vec = Vec(action.force.y, -action.force.x) * sp.Rational(str(self.beside))
        return Vec(action.point.x + along.x, action.point.y + along.y)


def open_line(trial: Trial, push: Push, body: str, used: Collection[sp.Symbol], value: Valuation) -> OpenLine | None:
    """That of the normal force of a guide on a body; None: it acts at the named point, or the couple is drawn too.
    `used`: the letters of the equations.
    """
    system = trial.system
    guides = any(j.kind == "guide" and j.name == push.joint for j in system.scene.problem.joints)
    couple = next((p for p in system.pushes if p.joint == push.joint and p.kind == "couple"), None)
    if push.kind != "normal" or not guides or couple is None or not trial.outcomes:
        return None
    if system.reactions is None or any(e.free_symbols & set(used) for p, e in system.reactions.pushes if p is couple):
        return None
    turns, presses = trial.outcomes[0].push(couple.name), trial.outcomes[0].push(push.name)
    if turns == 0:
        return None
    own = next((a for a in couple.actions if a.body == body), None)
    if turns is None or not presses or own is None:
        return OpenLine(None)
    return OpenLine(value(sp.sympify(own.couple)) * turns / presses)


def no_couples(trial: Trial) -> set[sp.Expr]:
    """Those with which guides do not hold: their forces act at the named points. Of a blow the page has few of its
    equations, and none that says so.
    """
    system, guides = trial.system, {j.name for j in trial.system.scene.problem.joints if j.kind == "guide"}
    told = system.reactions.pushes if system.reactions is not None and trial.outcomes else ()
    couples = [(p, expr) for p, expr in told if p.kind == "couple" and p.joint in guides]
    return {expr for p, expr in couples if all(outcome.push(p.name) == 0 for outcome in trial.outcomes)}
