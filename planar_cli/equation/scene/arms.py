"""The arm from the centre of a wheel to a point of its rim is the radius, and right across a wheel it is twice the
radius, whatever lengths the drawing tells besides.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any, Protocol

import sympy as sp

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.equation.values.exact import Unvalued
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.facts import Outline
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Circle, Surface
from planar_cli.problem.scene.shapes import rim_of


class Wheels(Protocol):
    """A scene in which there may be wheels."""

    @property
    def bodies(self) -> Mapping[str, BodyModel]: ...
    @property
    def ledger(self) -> Ledger: ...
    @property
    def surfaces(self) -> Mapping[str, Surface]: ...

    def value(self, side: Side) -> sp.Expr: ...
    def carried(self, body: str, point: str) -> Vec: ...
    def length(self, v: Vec) -> sp.Expr: ...
    def vanishes(self, expr: Any) -> bool: ...


class Arms:
    """Vectors from one place to another [m], each looked for once, and tangents of rims."""

    def __init__(self, scene: Wheels) -> None:
        self.scene = scene
        self._known: dict[tuple[Vec, Vec], Vec] = {}

    def between(self, start: Vec, end: Vec) -> Vec:
        """`end` - `start`, written with the radius where both are on one wheel.

        In a train of gears the drawing tells the rim of a planet by R - r_1 - r_S, say, which is its radius r_2.
        """
        found = self._known.get((start, end))
        if found is None:
            found = self._known[start, end] = self._found(start, end)
        return found

    def centre(self, place: Vec) -> Vec:
        """The centre of the wheel that a place is, as the file gives it; the place itself where it is none."""
        return next((c for c, _ in self._rims() if self._same(c, place)), place)

    def outlined(self, outline: Outline, point: Vec) -> Outline:
        """An arc whose tangent at a point of it is written with the radius alone."""
        if outline.kind != "arc" or outline.center is None:
            return outline
        arm = self.between(outline.center, point)
        return replace(outline, tangent=(arm / self.scene.length(arm)).turned())

    def _found(self, start: Vec, end: Vec) -> Vec:
        arm: Vec = end - start
        whole = Vec(self._in_full(arm.x), self._in_full(arm.y))
        if not any(part.has(sp.Add) for part in (whole.x, whole.y)):
            return arm
        for length in self._lengths(start, end):
            for way in _ways(whole):
                rim: Vec = way * length
                if self._same(rim, arm):
                    return rim
        return arm

    def _in_full(self, part: sp.Expr) -> sp.Expr:
        """With what the names of long coordinates stand for."""
        named = self.scene.ledger.definitions
        return sp.sympify(part).xreplace({s: named[s] for s in sp.sympify(part).free_symbols if s in named})

    def _lengths(self, start: Vec, end: Vec) -> Iterator[sp.Expr]:
        """The radii of wheels about one of two places, twice those of wheels about the middle between them."""
        middle: Vec = (start + end) / 2
        for center, radius in self._rims():
            if any(self._same(center, place) for place in (start, end)):
                yield radius
            elif self._same(center, middle):
                yield 2 * radius

    def _rims(self) -> Iterator[tuple[Vec, sp.Expr]]:
        """Centre and radius of all wheels and circular tracks."""
        scene = self.scene
        for body in scene.bodies.values():
            rim = rim_of(body.shape)
            if rim is not None:
                yield scene.carried(body.name, rim.center), scene.value(rim.radius)
        for surface in scene.surfaces.values():
            if isinstance(surface.shape, Circle):
                yield scene.carried(surface.body or GROUND, surface.shape.center), scene.value(surface.shape.radius)

    def _same(self, one: Vec, other: Vec) -> bool:
        gap: Vec = one - other
        try:
            return all(part == 0 or self.scene.vanishes(part) for part in (gap.x, gap.y))
        except Unvalued:
            # Places of another general position, with letters that this scene does not have.
            return False


def _ways(arm: Vec) -> Iterable[Vec]:
    """Unit vectors along which an arm may point: the axes, and along and across the angles with which it is written."""
    if arm.x == 0 or arm.y == 0:
        along = [Vec(sp.S.One, sp.S.Zero) if arm.y == 0 else Vec(sp.S.Zero, sp.S.One)]
    else:
        angles = {a.args[0] for part in (arm.x, arm.y) for a in part.atoms(sp.sin, sp.cos)}
        units = [Vec(sp.cos(phi), sp.sin(phi)) for phi in sorted(angles, key=sp.default_sort_key)]
        along = [way for unit in units for way in (unit, unit.turned())]
    return [way for unit in along for way in (unit, -unit)]
