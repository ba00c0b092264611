"""A scene in numbers, as it is drawn: places in metres, angles in radians."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.scene import Scene
from planar_cli.problem.expression import Negate, Number, Side
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND
from planar_cli.records import record
from planar_cli.report.blocks import Line, Value
from planar_cli.report.marks import Spot
from planar_cli.report.sides import said
from planar_cli.solve.between.trace import MotionTrace
from planar_cli.solve.solution import InstantSolution

FIGURES = 4


@record
class Drawn:
    """A scene in one position. `value`: the numbers of its letters; `here`: what stands for its coordinates there."""

    scene: Scene
    value: Valuation
    here: Mapping[sp.Symbol, sp.Expr]

    @classmethod
    def as_in_the_file(cls, instant: InstantSolution) -> Drawn:
        """The position in which the file draws an instant, or in which it was found."""
        scene = instant.instant.scene
        moves = scene.displacement.coordinates if scene.displacement is not None else ()
        return cls(scene, instant.value, {c.symbol: c.drawn for c in moves if c.drawn is not None})

    @classmethod
    def in_state(cls, scene: Scene, motion: MotionTrace, state: str) -> Drawn:
        """The position of a motion in one of its states."""
        here = {general: x for x, general in motion.general.items() if motion.ledger.roles[x].at == state}
        return cls(scene, motion.value, here)

    def number(self, expr: Any) -> float | None:
        """An expression as a number; None: nothing tells it."""
        placed = sp.sympify(expr).xreplace(dict(self.here))
        number = self.value.known(placed)
        if number is None:
            number = self.scene.valuations[0].known(placed)
        return None if number is None or not math.isfinite(float(number)) else float(number)

    def spot(self, place: Vec) -> Spot | None:
        """A place; None: nothing tells it."""
        x, y = self.number(place.x), self.number(place.y)
        return None if x is None or y is None else (x, y)

    def angle(self, direction: Vec) -> float | None:
        """The angle of a direction; None: nothing tells it, or it has none."""
        way = self.spot(direction)
        return None if way is None or math.hypot(*way) < TINY else math.atan2(way[1], way[0])

    def length(self, side: Side) -> float | None:
        """A length of the file."""
        return self.number(self.scene.value(side))

    def carried(self, body: str | None, point: str) -> Spot | None:
        """A named point that goes with a body, or stays with the ground."""
        return self.spot(self.scene.carried(body or GROUND, point))


TINY = 1e-12
"""A direction that is shorter is none."""


def size_of(side: Side) -> Line:
    """The same without the minus sign that the file writes before it: on which side it lies, or which way, is seen."""
    words = words_of(side)
    if isinstance(side, Negate):
        return words_of(side.operand) or words
    if isinstance(side, Number) and words and isinstance(value := words[0], Value) and value.number < 0:
        return (Value(-value.number, value.unit, value.figures), *words[1:])
    return words


def words_of(side: Side) -> Line:
    """A quantity as the file writes it; nothing where only a sentence could tell it."""
    return said(side, FIGURES) or ()
