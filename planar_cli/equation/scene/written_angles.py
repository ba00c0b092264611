"""Angles with which the file writes the direction from one point to another, as expressions."""

from __future__ import annotations

from typing import Protocol

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.implied.written_directions import WrittenDirections
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import Problem


class Valued(Protocol):
    """The part of a scene that is asked."""

    problem: Problem

    @property
    def valuations(self) -> tuple[Valuation, ...]: ...
    def value(self, side: Side) -> sp.Expr: ...


class WrittenAngles:
    """The written directions of a file as expressions of a scene."""

    def __init__(self, scene: Valued) -> None:
        self._scene, self._directions = scene, WrittenDirections(scene.problem)

    def angle(self, origin: str, to: str, reach: Vec) -> sp.Expr | None:
        """The angle with which the file writes the direction of the reach from one point (ORIGIN: of the axes) to
        another; None: it writes none.
        """
        for written in self._directions.between(origin, to):
            angle = self._scene.value(written.angle)
            if written.sense:
                return angle
            along = self._scene.valuations[0].known(reach.x * sp.cos(angle) + reach.y * sp.sin(angle))
            if along is None or along > 0:
                return angle
        return None
