"""The sense in which the force of a guide acts that no equation has: known once all is solved, and drawn so.

block:  m_A g ↓,  N_block →,  A_x ←,  A_y ↓   =   m_A a_A ↓

A guide holds from both sides, so that its joint counts the force in a sense of its own. Where no equation has the
letter, it stands for the size alone.
"""

from __future__ import annotations

from collections.abc import Collection

import sympy as sp

from planar_cli.problem.facts import Push
from planar_cli.report.words import Phrases
from planar_cli.solve.solution import InstantSolution


def acts_backward(
    instant: InstantSolution, push: Push, expr: sp.Expr, used: Collection[sp.Symbol], phrases: Phrases
) -> bool:
    """Does the force of a guide on a body act against the sense in which it counts? `used`: the letters of equations.

    With letters, or in a motion, the sense may change from one place to another.
    """
    trial = instant.trial
    if push.kind != "normal" or not expr.is_Symbol or expr in used or phrases.symbolic or phrases.drawn is not None:
        return False
    if not trial.outcomes or all(j.kind != "guide" or j.name != push.joint for j in trial.system.scene.problem.joints):
        return False
    value = trial.outcomes[0].push(push.name)
    return value is not None and value < 0
