"""Passages of a solution that are told beside its equations: places as functions, curves and how they were found."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.records import record
from planar_cli.units import PURE, Dimension

PLACES, RATES, ALONG, RADIAL, CURVE, ROLLING = "places", "rates", "along", "radial", "curve", "rolling"
SECOND_RATES = "second rates"
"""Kinds of passages: places, their derivatives and those of these, components along a path and of polar coordinates,
curves, and that a wheel rolls, which has no rows.
"""


@record
class Arm:
    """r_P/G: of both points the names, its components as the file measures them, and worked out."""

    point: str
    origin: str
    measured: tuple[sp.Expr, sp.Expr]
    components: tuple[sp.Expr, sp.Expr]


@record
class Row:
    """Words before a line, and the line: an equation, its sides one after the other, or a formula. `value`: of its last
    side at the instant that is asked for, in base units of `dimension`; an `angle` has none. `sizes`: those of the
    letters in that side. `way`: the terms of a sum that is written after the first side as it stands, nothing in it
    worked out: x_G - r sin φ. `note`: a remark beside it. `arm`: the vector from the point from which the file measures
    that of the row, on a line before it.
    """

    words: str
    line: Any
    value: Decimal | None = None
    dimension: Dimension = PURE
    angle: bool = False
    sizes: Mapping[sp.Symbol, Decimal] = field(default_factory=dict)
    way: tuple[sp.Expr, ...] = ()
    note: str = ""
    arm: Arm | None = None


def sides_of(row: Row) -> tuple[Any, ...]:
    """All sides of the line of a row."""
    if isinstance(row.line, sp.Eq):
        return row.line.lhs, row.line.rhs
    return row.line if isinstance(row.line, tuple) else (row.line,)


@record
class Passage:
    """A sentence, and the lines that it introduces. `kind`: one of those above."""

    heading: str
    rows: tuple[Row, ...]
    kind: str = ""


@record
class Tale:
    """What a part tells by itself. `whole`: its instants need no telling of their own, but for their checks. `valued`:
    nor does its motion, as all values at the instant that is asked for stand in it. `letters`: those of finds, by their
    names.
    """

    passages: tuple[Passage, ...]
    whole: bool = True
    valued: bool = False
    letters: Mapping[str, sp.Symbol] = field(default_factory=dict)


def beside(passages: tuple[Passage, ...], whole: bool) -> tuple[Passage, ...]:
    """The passages of a part; where its instants tell the answers by their equations, the derivatives of places say no
    more.
    """
    return () if not whole and all(p.kind in (PLACES, RATES, SECOND_RATES) for p in passages) else passages


def told_function(function: Any) -> Row:
    """A coordinate as a function, with the words from where it comes."""
    return Row(function.words, sp.Eq(function.symbol, function.expr, evaluate=False))


def squared_radius(equation: Any, radius: sp.Expr | None) -> Any:
    """x² + y² = 225 as x² + y² = 15²: of a circle whose radius is a number, that is seen in its equation."""
    if radius is None or not radius.is_number or radius == 1 or sp.expand(equation.rhs - radius**2) != 0:
        return equation
    return sp.Eq(equation.lhs, sp.Pow(radius, 2, evaluate=False), evaluate=False)
