"""A letter that stands inside the integral of a time over a way, and is found by trial."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Math, line
from planar_cli.report.laws.integrals import plain_integral
from planar_cli.report.laws.laws import running
from planar_cli.report.words.origins import letter_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteTrace


def inside_an_integral(
    e: Relation, route: RouteTrace, found: MotionTrace, letters: Collection[sp.Symbol], phrases: Phrases
) -> tuple[Math, Math]:
    """The time of a state, and the integral over the way to it. `letters`: those that run."""
    own = letter_of(e, found.ledger) or found.ledger.symbols["t"]
    law = plain_integral(own - e.residual.xreplace(route.plain), e, route, found.general)
    return phrases.math(own), running(law, letters, phrases, e.law)


def by_trial_values(law: tuple[Math, Math], found: Result, shown: Any, number: int) -> Iterator[Block]:
    """The equation, and the letter inside it with its value."""
    yield Equation(law, number)
    yield Equation((Math(found.unknown), shown), None, line(f"({number}), by trial values:"))
