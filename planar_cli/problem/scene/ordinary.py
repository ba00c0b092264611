"""Ordinary sizes of a scene: length L, mass M and time T in which all numbers of the file are as near to 1 as can be,

    Σ (log|c| - a log L - b log M - d log T)² → min        over all numbers c of dimension L^a M^b T^d,

so that a file in other units, or of a world of another size, has them changed by its own factors.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from decimal import Decimal
from fractions import Fraction
from typing import Any

from planar_cli.base_units import in_base
from planar_cli.problem.language.expression import Number, Scaled
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.units import ACCELERATION, PURE, Dimension, parse_unit

GRAVITY = Fraction(981, 100)
"""Of the Earth, where the file says nothing else [m/s²]."""


@record
class Scales:
    """What counts as an ordinary size in a scene."""

    length: float = 1.0
    """In m or ft."""
    mass: float = 1.0
    """In kg or slug."""
    time: float = 1.0
    """In s."""

    def of(self, dimension: Dimension) -> float:
        """The ordinary size of a quantity, in the base units of the file."""
        return float(
            self.length ** float(dimension.length)
            * self.mass ** float(dimension.mass)
            * self.time ** float(dimension.time)
        )

    def exact(self, dimension: Dimension) -> Decimal:
        """The next power of ten: a decimal number that gives no product more digits."""
        return Decimal(10) ** round(math.log10(self.of(dimension)))


def scales_of(problem: Problem) -> Scales:
    """The ordinary sizes of a scene. A kind of quantity that no number tells keeps its base unit."""
    rows = [(d, math.log(abs(n))) for n, d in _numbers(problem, problem.us) if n and d != PURE]
    if problem.plane == "vertical" and not any(s.name == "g" for s in (*problem.given, *problem.symbols)):
        rows.append((ACCELERATION, math.log(float(GRAVITY) * in_base(parse_unit("m/s^2"), problem.us))))
    rows += [(parse_unit(s.unit).dimension, 0.0) for s in problem.symbols if s.unit is not None]
    powers = [(d.length, d.mass, d.time) for d, _ in rows]
    square = [[sum((p[i] * p[j] for p in powers), Fraction(0)) for j in range(3)] for i in range(3)]
    right = [sum(float(p[i]) * log for p, (_, log) in zip(powers, rows, strict=True)) for i in range(3)]
    return Scales(*(math.exp(x) for x in _solved(square, right)))


def _numbers(node: Any, us: bool) -> Iterator[tuple[float, Dimension]]:
    """All numbers with a unit in a file, in its base units."""
    for number in with_units(node):
        unit = parse_unit(number.unit or "1")
        plain = [number] if isinstance(number, Number) else [n for n in _plain(number.operand) if n.value]
        yield math.prod(float(n.value) for n in plain) * in_base(unit, us), unit.dimension


def with_units(node: Any) -> Iterator[Number | Scaled]:
    """All numbers with a unit in a file, or in a part of it; what it asks and answers is left out."""
    if isinstance(node, tuple):
        for inner in node:
            yield from with_units(inner)
    elif isinstance(node, Scaled) or (isinstance(node, Number) and node.unit is not None):
        yield node
    elif is_dataclass(node) and not isinstance(node, type):
        for f in fields(node):
            if f.name not in ("find", "answers", "cases", "mark", "tolerance"):
                yield from with_units(getattr(node, f.name))


def _plain(node: Any) -> Iterator[Number]:
    if isinstance(node, Number):
        yield node
    elif is_dataclass(node) and not isinstance(node, type):
        for f in fields(node):
            yield from _plain(getattr(node, f.name))


def _solved(square: list[list[Fraction]], right: list[float]) -> list[float]:
    """Least squares; what the rows leave open is zero."""
    rows = [([*row], b) for row, b in zip(square, right, strict=True)]
    pivots: dict[int, int] = {}
    for column in range(len(rows)):
        free = [i for i in range(len(rows)) if i not in pivots.values() and rows[i][0][column]]
        if not free:
            continue
        pivots[column] = pivot = free[0]
        top, b = rows[pivot]
        for i, (row, c) in enumerate(rows):
            if i != pivot and row[column]:
                factor = row[column] / top[column]
                rows[i] = ([x - factor * y for x, y in zip(row, top, strict=True)], c - float(factor) * b)
    return [rows[pivots[k]][1] / float(rows[pivots[k]][0][k]) if k in pivots else 0.0 for k in range(len(rows))]
