"""What stands under a diagram with forces whose direction is assumed: how they are drawn, and which act the other way.

dashed: direction assumed; found: F_C to the left
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from decimal import Decimal

from sympy import Symbol

from planar_cli.report.blocks import Forces, Line, Math, line
from planar_cli.report.marks import Arrow, Panel
from planar_cli.solve.between.trace import ImpactEquation
from planar_cli.solve.solved_problem import PartSolution, Solution

EIGHTH = math.pi / 4
OPPOSITE = (
    "to the left",
    "down to the left",
    "downward",
    "down to the right",
    "to the right",
    "up to the right",
    "upward",
    "up to the left",
)
"""Of arrows by eighths of a turn, counterclockwise from the x axis."""
LEGEND = "dashed: direction assumed"


def note_of(panels: Sequence[Panel], row: Forces, solution: Solution) -> Line:
    """Nothing where no direction is assumed. `row`: the list of forces of these diagrams."""
    assumed = [m for p in panels for m in p.marks if isinstance(m, Arrow) and m.assumed]
    if not assumed:
        return ()
    against = [m for m in assumed if _is_against(m.words, row, solution)]
    found = dict.fromkeys((m.words, OPPOSITE[round(m.angle / EIGHTH) % len(OPPOSITE)]) for m in against)
    told = [piece for words, way in found for piece in (", ", *words, f" {way}")][1:]
    return line(LEGEND, *(("; found: ", *told) if told else ()))


def _is_against(words: Line, row: Forces, solution: Solution) -> bool:
    """Does a force come out against the direction in which its letter counts, whenever its diagram holds?"""
    letters = [p.expr for p in words if isinstance(p, Math) and p.expr.is_Symbol]
    found = [n for letter in letters for part in solution.parts for n in _numbers(letter, row, part)]
    return bool(found) and all(n is not None and n < 0 for n in found)


def _numbers(letter: Symbol, row: Forces, part: PartSolution) -> Iterator[Decimal | None]:
    """What was found for it where the scene is that of the diagram; None: it changes in a motion, or nothing tells."""
    if part.motion is None:
        yield from (i.value.known(letter) for i in part.instants if i.instant.scene is row.scene)
        return
    for regime in part.motion.regimes:
        if regime.solution.instant.scene is row.scene:
            yield regime.constants[letter][1] if letter in regime.constants else None
    for leg in part.motion.route.steps:
        blows = [e.source.impact.solution for e in leg.relations if isinstance(e.source, ImpactEquation)]
        if any(b is not None and b.instant.scene is row.scene for b in blows):
            # An impulse has a shorter name on the page.
            own = (r.unknown for r in leg.results if f"{r.unknown.name}_".startswith(f"{letter.name}_"))
            yield from map(part.motion.value.known, own)
