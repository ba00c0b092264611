"""Which answers of a motion nothing was compared with, and why: they are not told as if something agreed with them."""

from __future__ import annotations

import sympy as sp

from planar_cli.solve.course.asked_finds import AskedFind
from planar_cli.solve.course.solved_motion import SolvedMotion

ALONE = "followed step by step alone, no equation gives it"
NOT_FOLLOWED = "the motion was not followed step by step"
NOT_REACHED = "its state was not reached step by step"


def unconfirmed(found: SolvedMotion) -> dict[str, str]:
    """By the name of a find: why nothing was compared with its answer. Finds whose answers were compared are left out.

    Two roads lead to the letters of a state, its equations and the motion that is followed in numbers; where only one
    of them does, nothing is compared.
    """
    reasons = {}
    for asked in found.finds:
        reason = _reason(found, asked)
        if reason:
            reasons[asked.find.name] = reason
    return reasons


def _reason(found: SolvedMotion, asked: AskedFind) -> str:
    own = {s for stop in found.course.stops.values() for s in stop.letters.values()}
    letters: set[sp.Symbol] = {s for part in asked.parts() for s in part.free_symbols} & own
    if not letters:
        return ""
    if found.followed is None:
        return NOT_FOLLOWED
    if letters & found.guessed:
        return ALONE
    return "" if letters <= {*found.followed.values, *found.followed.tends} else NOT_REACHED
