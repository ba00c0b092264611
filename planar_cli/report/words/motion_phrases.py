"""The phrases in which a motion speaks."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.values.exact import Sample, Valuation
from planar_cli.report.words.slopes import slopes_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution


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


def constant_phrases(motion: MotionTrace, instant: InstantSolution, phrases: Phrases) -> Phrases:
    """The phrases for what is the same all the time in one regime of a motion: only that has a number in them."""
    regime, ledger = motion.regime(instant), phrases.ledger
    settled = motion.value.without(motion.value.drawn)
    given = {s: n for s in (*ledger.values, *ledger.definitions) if (n := settled.known(s)) is not None}
    numbers = {letter: number for letter, (_, number) in regime.constants.items()}
    formulas = {letter: formula for letter, (formula, _) in regime.constants.items()}
    return replace(phrases, value=Valuation({**given, **numbers}).defining(formulas), symbolic=False)


def _drawn(found: MotionTrace) -> frozenset[sp.Symbol]:
    """Letters of which the values are samples."""
    return found.value.drawn if isinstance(found.value, Sample) else frozenset()
