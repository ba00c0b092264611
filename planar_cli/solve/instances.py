"""Numbers for the letters of a solved motion: those that were drawn as it was solved, then others.

The motion that formulas describe happens for some numbers of its letters and not for all: a spring must be longer than
it is compressed, a thread must not go slack. Where nothing says for which, several are drawn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.language.expression import Name
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.solve.between.trace.trace import MotionTrace
from planar_cli.solve.solution import Found
from planar_cli.solve.taken import Taken
from planar_cli.units import parse_unit

MORE = 12
"""So many other instances are drawn."""
WIDEST = 8.0
"""A letter is at most so many times what was drawn first, or one part in so many."""
STEP = 0.6180339887498949
"""Multiples of the golden ratio, without their whole parts, fill an interval evenly."""


@record
class Instance:
    """One choice of numbers."""

    taken: Taken
    """What the solved motion tells for these numbers."""
    value: Valuation
    """Numbers of the letters in its formulas, with all that is known."""


def instances(problem: Problem, found: tuple[Found, ...], trace: MotionTrace) -> Iterator[Instance]:
    """The numbers with which the motion was solved; where letters remain, others."""
    yield Instance(trace.taken, trace.value)
    if not problem.symbols:
        return
    sought = {s.name for s in problem.unknowns}
    drawn = {n: v for n, v in trace.taken.letters.items() if n not in sought}
    angles = {s.name for s in problem.symbols if s.unit is not None and parse_unit(s.unit).angle}
    for i in range(1, MORE + 1):
        letters = {n: v * _factor(i, k, n in angles) for k, (n, v) in enumerate(drawn.items())}
        value = Valuation({trace.ledger.symbols[n]: Decimal(repr(v)) for n, v in letters.items()})
        constants = dict(_constants(found, sought, value))
        if constants.keys() == sought:
            yield Instance(Taken({**letters, **constants}, {}, {}, {}), value)


def _factor(i: int, k: int, angle: bool) -> float:
    """Of the letter k in the sample i; angles stay below a right one."""
    part = ((i * (k + 1) * STEP) + k * 0.5) % 1.0
    return float(WIDEST ** (-part)) if angle else float(WIDEST ** (2 * part - 1))


def _constants(found: tuple[Found, ...], sought: set[str], value: Valuation) -> Iterator[tuple[str, float]]:
    """The constants that are answers."""
    known: Mapping[sp.Symbol, Decimal] = value.values
    for f in found:
        what = f.find.found.what if f.find is not None else None
        if isinstance(what, Name) and what.name in sought and f.expressions:
            (expr,) = f.expressions
            if expr.free_symbols <= known.keys():
                yield what.name, float(value(expr))
