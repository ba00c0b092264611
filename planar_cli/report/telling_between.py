"""What tells the balances and blows of a motion, with what they need to know of all of it."""

from __future__ import annotations

from planar_cli.report.between import BetweenTelling
from planar_cli.report.idle_zeros import idle_zeros
from planar_cli.report.negligible import FiniteForces
from planar_cli.report.nil_impulses import said_nil
from planar_cli.report.origins import inertias_of_blows, letters_of_blows
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace


def telling_between(found: MotionTrace, phrases: Phrases, numeric: Phrases) -> BetweenTelling:
    """`numeric`: for what rests on no letter without a number."""
    return BetweenTelling(
        phrases,
        {},
        numeric,
        used=letters_of_blows(found) - idle_zeros(found),
        axes=inertias_of_blows(found),
        nil={(symbol, since) for symbol, since, _ in said_nil(found)},
        finite=FiniteForces(found.problem, found.states),
    )
