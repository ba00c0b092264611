"""The phrases in which a motion speaks."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.equation.exact import Sample
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace


def motion_phrases(found: MotionTrace, figures: int) -> Phrases:
    """The phrases in which a motion speaks: with numbers unless letters of the file remain."""
    return Phrases(found.ledger, found.value, figures, found.symbolic)


def settled_phrases(found: MotionTrace, phrases: Phrases) -> Phrases:
    """For what rests on no letter without a number, though letters stand in the equations: a mass that cancels."""
    drawn = found.value.drawn if isinstance(found.value, Sample) else frozenset()
    return replace(phrases, symbolic=False, lettered=drawn | (found.unknowns - found.route.settled))
