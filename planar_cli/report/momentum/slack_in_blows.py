"""Why a rope takes no part in a blow: the velocities after it bring its ends nearer along it."""

from __future__ import annotations

from collections.abc import Iterator

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.report.document.blocks import Block, Equation, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import VELOCITY

SLACK = "slack"
SHORT = 16
"""A speed of more operations is told by its number alone."""


def slackened(blow: InstantSolution, phrases: Phrases) -> Iterator[Block]:
    """How fast each slack rope of a blow would shorten if it stayed straight, m/s, positive: b ω_2 = 0.19 m/s > 0."""
    system, explicit = blow.trial.system, {x.symbol: x.expression for x in blow.lines}
    for mode in system.modes.values() if system.motion is not None else ():
        rows = [t.row for t in mode.tests if t.row is not None and t.row.segments] if mode.name == SLACK else []
        for row in rows[:1]:
            assert system.motion is not None
            expr = -system.motion.row_acceleration(row)
            for _ in explicit:
                expr = expr.xreplace(explicit)
            expr = simplified(expr)
            speed = phrases.value.known(expr)
            if speed is None or speed <= 0 or not phrases.has_numbers(expr):
                continue
            shown = phrases.of_dimension(speed, VELOCITY)
            formula = [] if longer(expr, SHORT) else [phrases.math(expr), *phrases.substituted(expr, shown)]
            called = mode.words.removesuffix(" is slack")
            # Over a pulley the parts between them are what becomes shorter.
            along = " along it" if len(row.segments) > 1 else ""
            lead = line(f"After the blow the ends of {called} approach each other{along}, so that it stays slack, at:")
            yield Equation((*formula, shown), None, lead)
