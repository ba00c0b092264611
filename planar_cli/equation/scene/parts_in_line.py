"""The mass centres of the parts of a body on one straight line through the pin about which it turns.

Distances along that line say all: OG = Σ m_i d_i/m, I_O = Σ (I_i + m_i d_i²), and I about the mass centre is
I_O - m OG².
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Problem
from planar_cli.records import record


@record
class PartsInLine:
    """`pin`: the point about which the body turns, at `origin`; `along`: the unit vector of the line; `distances`: from
    the pin to the mass centre of each part, none of them on the other side of it.
    """

    pin: str
    origin: Vec
    along: Vec
    distances: tuple[sp.Expr, ...]

    def at(self, distance: sp.Expr) -> Vec:
        """The point of the line at a distance from the pin."""
        away: Vec = self.along * distance
        return Vec(self.origin.x + away.x, self.origin.y + away.y)


def pin_of(body: str, problem: Problem) -> str:
    """The named point at which the ground holds a body with a pin; empty: none does, or two do."""
    pins = [j for j in problem.joints if j.kind == "pin" and {GROUND, body} <= set(map(str, getattr(j, "between", ())))]
    names = [at for j in pins if isinstance(at := getattr(j, "at", None), str)]
    return names[0] if len(names) == len(pins) == 1 else ""


def parts_in_line(
    pin: str, origin: Vec, centres: Sequence[Vec], vanishes: Callable[[sp.Expr], bool]
) -> PartsInLine | None:
    """None: the parts do not lie so. `vanishes`: is an expression zero with all that is known of its letters?"""
    reaches = [centre - origin for centre in centres]
    along = next((way for r in reaches if (way := _unit(r, vanishes)) is not None), None)
    if along is None or any(not vanishes(r.cross(along)) for r in reaches):
        return None
    distances = tuple(simplified(r.dot(along)) for r in reaches)
    return PartsInLine(pin, origin, along, distances) if all(d.is_nonnegative for d in distances) else None


def _unit(reach: Vec, vanishes: Callable[[sp.Expr], bool]) -> Vec | None:
    """The direction of an arm in plain terms; None: it has no length, or that is a root."""
    if vanishes(reach.x) and vanishes(reach.y):
        return None
    length = sp.sqrt(simplified(reach.dot(reach)))
    if any(p.is_Pow and p.exp.is_Rational and p.exp.q == 2 for p in sp.Mul.make_args(length)):
        return None
    return Vec(simplified(reach.x / length), simplified(reach.y / length))
