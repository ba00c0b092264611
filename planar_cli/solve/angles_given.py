"""Angles of which the file gives the number, put into answers in letters: at θ = 90° it is -b w², not a formula in θ.

What vanishes at that angle is left out on the way, so that the formula in θ would hold nowhere else.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import Ledger
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution
from planar_cli.units import PURE

MOST_OPS = 4000
"""A longer formula stays as it is."""


def with_angles_put_in(part: PartSolution) -> PartSolution:
    """A part whose answers in letters have the numbers of the angles that are given."""
    if not part.instants or all(f.values is not None or not f.expressions for f in part.found):
        return part
    ledger = part.motion.ledger if part.motion is not None else part.instants[-1].instant.scene.ledger
    return replace(part, found=tuple(_put_in(f, ledger) for f in part.found))


def _put_in(found: Found, ledger: Ledger) -> Found:
    """One answer."""
    if found.values is not None or found.curve is not None or found.word or not found.expressions:
        return found
    numbers = {s: n for e in found.expressions for s in e.free_symbols if (n := _number(s, ledger)) is not None}
    if not numbers or any(longer(e, MOST_OPS) for e in found.expressions):
        return found
    return replace(found, expressions=tuple(simplified(e.subs(numbers)) for e in found.expressions))


def _number(symbol: sp.Symbol, ledger: Ledger) -> sp.Expr | None:
    """The number of an angle that is given by one."""
    value, unit = ledger.values.get(symbol), ledger.units.get(symbol)
    given = value is not None and not value.free_symbols and unit is not None
    return value if given and unit is not None and unit.angle and unit.dimension == PURE else None
