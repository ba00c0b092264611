"""The title of a step that joins states: by what it joins them, where no time runs between them."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from planar_cli.report.momentum.nil_impulses import in_blow
from planar_cli.solve.between.trace.trace import PAIR, BalanceTrace, ImpactEquation, MotionTrace, RouteStep

WORK, MOMENTUM = "work and energy", "impulse and momentum"
OVER_TIME = "Motion over time"
ABOUT_CENTRE = "Motion about the mass centre"


def title_of(legs: Sequence[RouteStep], found: MotionTrace) -> str:
    """Of these steps of a motion: that time runs; else work and energy, impulse and momentum, or both."""
    if any(e.kind == PAIR for leg in legs for e in leg.relations):
        return ABOUT_CENTRE
    if any(leg.turns or any(e.is_of_motion for e in leg.relations) for leg in legs):
        return OVER_TIME
    sources = [e.source for leg in legs for e in leg.relations]
    laws = {b.law.letter for b in sources if isinstance(b, BalanceTrace)}
    blows = any(isinstance(b, ImpactEquation) for b in sources)
    works = laws - {""}
    words = [WORK] * bool(works) + [MOMENTUM] * (blows or bool(laws - works))
    if not words and found.oscillations:
        return "Small oscillations"
    return ", ".join(words).capitalize() if words else "Motion"


def last_title(found: MotionTrace, early: Collection[RouteStep]) -> str:
    """Of what comes after the forces; empty: all steps were told before them. `early`: the steps that were."""
    rest = [leg for leg in found.route.steps if leg not in early]
    if found.passing or any(not in_blow(s) for s in found.spans):
        return OVER_TIME
    return "" if early and all(leg.is_datum for leg in rest) else title_of(rest, found)
