"""The part of an acceleration that is one which has its name already: a rod pinned to the centre O of a wheel that
rolls has m a_O for its first part, not m R α of the wheel.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import tidy
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.instant.written import Explicit

Part = tuple[Vec, sp.Expr]


def by_named(parts: Sequence[Part], lines: Sequence[Explicit]) -> list[Part]:
    """The parts, vector and size, with the names of `lines` for those that are as large: vectors of length 1 then."""
    return [_named(part, lines) for part in parts]


def _named(part: Part, lines: Sequence[Explicit]) -> Part:
    arm, unknown = part
    for x in lines if unknown.is_Symbol else ():
        rate = x.expression / unknown
        if unknown in rate.free_symbols:
            continue
        way = Vec(tidy(arm.x / rate), tidy(arm.y / rate))
        if tidy(way.x**2 + way.y**2) == 1:
            return way, x.symbol
    return part
