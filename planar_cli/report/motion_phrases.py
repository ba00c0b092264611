"""The phrases in which a motion speaks."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.exact import Sample
from planar_cli.report.slopes import slopes_of
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace


def motion_phrases(found: MotionTrace, figures: int) -> Phrases:
    """The phrases in which a motion speaks: with numbers unless letters of the file remain, and none that was drawn."""
    return Phrases(
        found.ledger, found.value, figures, found.symbolic, lettered=_drawn(found), slopes=slopes_of(found.problem)
    )


def settled_phrases(found: MotionTrace, phrases: Phrases) -> Phrases:
    """For what rests on no letter without a number, though letters stand in the equations: a mass that cancels."""
    drawn, left = _drawn(found), found.unknowns - found.route.settled
    data = {s: e for s, e in found.route.plain.items() if s in left}
    known = {s for s, e in data.items() if not sp.sympify(e).free_symbols & (drawn | left)}
    return replace(phrases, symbolic=False, lettered=drawn | (left - known))


def _drawn(found: MotionTrace) -> frozenset[sp.Symbol]:
    """Letters of which the values are samples."""
    return found.value.drawn if isinstance(found.value, Sample) else frozenset()
