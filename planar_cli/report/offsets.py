"""How far beside the middle of a face its normal force acts: M = N x, by the moments of the loads about that point.

x = P y/N_C = 235.4 · 0.5/588.6 = 0.2 m < b/2 = 0.3 m      it slips before it tips
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.plain import longer, simplified
from planar_cli.equation.system import System
from planar_cli.problem.facts import Push
from planar_cli.problem.scene import GROUND
from planar_cli.report.blocks import Line, Math, Name, line
from planar_cli.solve.instant.instant import Trial

LONGEST, NEAR = 12, Decimal("1e-20")


def offset_letter(system: System) -> sp.Symbol:
    """x, or x_N where the file has an x."""
    names = {*system.scene.ledger.symbols, *system.scene.points}
    return sp.Symbol("x_N" if "x" in names else "x", positive=True)


def normal_of(system: System, push: Push) -> Push | None:
    """The normal force that a couple on a face belongs to; None: it is no such couple."""
    if push.kind != "couple":
        return None
    return next((p for p in system.pushes if p.joint == push.joint and p.kind == "normal"), None)


def moment_of_loads(trial: Trial, push: Push, size: Decimal) -> sp.Expr | None:
    """The couple of a face by the moments of the loads about the middle of the face, of a body in equilibrium on which
    nothing else presses. None: it is not, or that is long. `size`: the number that it has to be.
    """
    system = trial.system
    normal = normal_of(system, push)
    action = next((a for a in normal.actions if a.body != GROUND), None) if normal is not None else None
    if action is None or not system.balanced(action.body):
        return None
    if any(a.body == action.body for p in system.pushes if p.joint != push.joint for a in p.actions):
        return None
    loads = [w for w in system.wrenches if w.body == action.body]
    turning = [w.couple + ((w.point - action.point).cross(w.force) if w.force is not None else 0) for w in loads]
    whole = simplified(sp.Add(*turning))
    number = trial.outcomes[0].value.known(whole) if not longer(whole, LONGEST) and whole.free_symbols else None
    if number is None or abs(abs(number) - size) > NEAR * size:
        return None
    return whole if number > 0 else -whole


def beside_the_middle(system: System, push: Push, expr: sp.Expr) -> Line:
    """What the couple of a normal force stands for in a diagram: ` (of N_C, which acts x beside C_1)`."""
    normal = normal_of(system, push)
    if normal is None or not expr.is_Symbol:
        return ()
    force, letter, place = Math(system.symbols[normal.name]), Math(offset_letter(system)), Name(normal.place)
    return line(" (of ", force, ", which acts ", letter, " beside ", place, ")")
