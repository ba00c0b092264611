"""What a motion in letters leaves without a formula: it is told by name, and never as numbers that were drawn."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Sample, Valuation
from planar_cli.errors import Undecided
from planar_cli.problem.scene.scene import Find
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.told.independence import rests_on
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.regimes.regime import Regime

READABLE = 40
"""An equation of motion with more operations is not written into a message."""


def settled_by(
    course: StatedMotion, find: Find, closed: Sequence[sp.Expr], value: Valuation, spans: Iterable[SpanIntegral]
) -> Valuation:
    """The numbers that may tell a find. Undecided: its formulas hold letters of states that rest on numbers that were
    drawn.
    """
    if not isinstance(value, Sample):
        return value
    inside = {s for c in closed for s in c.free_symbols}
    told = value.drawn | {s for r in course.distinct_regimes() for s in r.letters}
    if not any(s in value.values and s not in told for s in inside):
        return value
    asked = [p.integrand for s in spans if s.symbol in inside for p in s.pieces]
    letters = rests_on(course, value, asked) | (value.drawn & inside)
    if not letters:
        return value.without(value.drawn)
    named = ", ".join(s.name for s in course.ledger.letters if s in letters)
    text = f"{_place(find)} no formula in {named} is found for `{find.name}`, and {named} have no numbers"
    known = [_equation(r, u) for r in course.running() for u in r.free if not longer(r.accelerations[u], READABLE)]
    said = f"; what is known is the motion's own equation, {', '.join(dict.fromkeys(known))}" if known else ""
    raise Undecided(f"{text}{said}; with numbers under `given` it is followed step by step")


def _place(find: Find) -> str:
    return f"{find.mark.file}:{find.mark.line}:"


def _equation(regime: Regime, speed: sp.Symbol) -> str:
    """The rate of a free speed as a line of the file's own mathematics."""
    plain = {c.speed: c.symbol.name for c in regime.coordinates if c.factor == 1 and c.extra == 0}
    words = {u: sp.Symbol(f"dot({plain[u]})") for u in regime.free if u in plain}
    left = f"ddot({plain[speed]})" if speed in plain else f"dot({speed.name})"
    return f"{left} = {regime.accelerations[speed].xreplace(words)}".replace("**", "^")
