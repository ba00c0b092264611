"""The title of the step that joins states: by what it joins them, where no time runs between them."""

from __future__ import annotations

from planar_cli.solve.between.trace import BalanceTrace, ImpactEquation, MotionTrace

WORK, MOMENTUM = "work and energy", "impulse and momentum"


def motion_title(found: MotionTrace) -> str:
    """Work and energy, impulse and momentum, or both; of neither plainly the motion."""
    sources = [e.source for leg in found.route.steps for e in leg.relations]
    laws = {b.law.letter for b in sources if isinstance(b, BalanceTrace)}
    blows = any(isinstance(b, ImpactEquation) for b in sources)
    works = laws - {""}
    words = [WORK] * bool(works) + [MOMENTUM] * (blows or bool(laws - works))
    if not words and found.oscillations:
        return "Small oscillations"
    return ", ".join(words).capitalize() if words else "Motion"
