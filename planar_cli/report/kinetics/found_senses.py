"""The sense in which a force acts that no equation has: known once all is solved, and drawn so.

block:  m_A g ↓,  N_block →,  A_x ←,  A_y ↓   =   m_A a_A ↓

A guide holds from both sides, so that its joint counts the force in a sense of its own, and so does friction. Where no
equation has the letter, it stands for the size alone.
"""

from __future__ import annotations

from collections.abc import Collection
from decimal import Decimal

import sympy as sp

from planar_cli.problem.scene.facts import Push
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import FORCE


def acts_backward(
    instant: InstantSolution, push: Push, expr: sp.Expr, used: Collection[sp.Symbol], phrases: Phrases
) -> bool:
    """Does a force of which no equation speaks, of a guide or by friction, act on a body against the sense in which it
    counts? `used`: the letters of equations.
    """
    value = _found(instant, push, expr, used, phrases)
    return value is not None and value < 0


def is_drawn_as_found(
    instant: InstantSolution, push: Push, expr: sp.Expr, used: Collection[sp.Symbol], phrases: Phrases
) -> bool:
    """Is a force of which no equation speaks drawn in the sense that it has?"""
    return bool(_found(instant, push, expr, used, phrases))


def _found(
    instant: InstantSolution, push: Push, expr: sp.Expr, used: Collection[sp.Symbol], phrases: Phrases
) -> Decimal | None:
    """The value of such a force. With letters, or in a motion, the sense may change from one place to another."""
    trial = instant.trial
    if push.kind not in ("normal", "friction") or not expr.is_Symbol or expr in used or not trial.outcomes:
        return None
    if phrases.ledger.units[expr].dimension != FORCE:
        # The numbers of a blow are told by its own equations.
        return None
    guided = any(j.kind == "guide" and j.name == push.joint for j in trial.system.scene.problem.joints)
    if phrases.symbolic or phrases.lettered or phrases.drawn is not None or (push.kind == "normal" and not guided):
        return None
    return trial.outcomes[0].push(push.name)
