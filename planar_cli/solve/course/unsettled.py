"""What a motion in letters leaves without a formula: it is told by name, and never as numbers that were drawn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.exact import Sample, Valuation
from planar_cli.equation.plain import longer
from planar_cli.errors import Undecided
from planar_cli.problem.scene import Find

if TYPE_CHECKING:
    from planar_cli.solve.course.course import Course
    from planar_cli.solve.course.regime import Regime

READABLE = 40
"""An equation of motion with more operations is not written into a message."""


def demand_settled(course: Course, find: Find, closed: Sequence[sp.Expr], value: Valuation) -> None:
    """Undecided: a find holds letters of states that only a motion with numbers that were drawn would tell."""
    if not isinstance(value, Sample):
        return
    told = value.drawn | {s for r in course.distinct_regimes() for s in r.letters}
    if any(s in value.values and s not in told for c in closed for s in c.free_symbols):
        letters = _named(course, value)
        text = f"{_place(find)} no formula in {letters} is found for `{find.name}`, and {letters} have no numbers"
        known = [_equation(r, u) for r in course.running() for u in r.free if not longer(r.accelerations[u], READABLE)]
        known = list(dict.fromkeys(known))
        said = f"; what is known is the motion's own equation, {', '.join(known)}" if known else ""
        raise Undecided(f"{text}{said}; with numbers under `given` it is followed step by step")


def _place(find: Find) -> str:
    return f"{find.mark.file}:{find.mark.line}:"


def _named(course: Course, value: Sample) -> str:
    """The letters without numbers, as the file writes them; g only where it acts."""
    written = {s.name for s in course.problem.symbols}
    gravity = course.scene.gravity
    return ", ".join(s.name for s in course.ledger.letters if s in value.drawn and (s.name in written or s == gravity))


def _equation(regime: Regime, speed: sp.Symbol) -> str:
    """The rate of a free speed as a line of the file's own mathematics."""
    plain = {c.speed: c.symbol.name for c in regime.coordinates if c.factor == 1 and c.extra == 0}
    words = {u: sp.Symbol(f"dot({plain[u]})") for u in regime.free if u in plain}
    left = f"ddot({plain[speed]})" if speed in plain else f"dot({speed.name})"
    return f"{left} = {regime.accelerations[speed].xreplace(words)}".replace("**", "^")
