"""Particles whose place the file gives in polar coordinates about a fixed point.

    v = r' e_r + r φ' e_φ                     a = (r" - r φ'²) e_r + (r φ" + 2 r' φ') e_φ

(An Introduction to Planar Dynamics, 1.3: polar coordinates.)
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.jets import Jet
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND, Particle, Polar
from planar_cli.records import record

if TYPE_CHECKING:
    from planar_cli.equation.scene import Scene


@record
class Spoke:
    """A place at a distance r [m] from a fixed point, at an angle φ from the x axis."""

    center: Vec
    origin: str
    """The name of the fixed point."""
    distance: Jet
    angle: Jet

    @property
    def outward(self) -> Vec:
        """e_r."""
        return Vec(sp.cos(self.angle.value), sp.sin(self.angle.value))

    @property
    def velocities(self) -> tuple[sp.Expr, sp.Expr]:
        """v_r and v_φ."""
        assert self.distance.rate is not None
        assert self.angle.rate is not None
        return self.distance.rate, self.distance.value * self.angle.rate

    @property
    def accelerations(self) -> tuple[sp.Expr, sp.Expr]:
        """a_r and a_φ."""
        r, turn = self.distance, self.angle
        assert r.second is not None
        assert turn.second is not None
        assert r.rate is not None
        assert turn.rate is not None
        return r.second - r.value * turn.rate**2, r.value * turn.second + 2 * r.rate * turn.rate

    def ways(self, particle: str) -> list[tuple[Vec, str]]:
        """Along the line and across it, in words; along it in the sense of the particle's acceleration."""
        line = f"{self.origin}{particle}"
        way = -self.outward if self.accelerations[0].could_extract_minus_sign() else self.outward
        return [(way, f"along {line}"), (self.outward.turned(), f"along the perpendicular to {line}")]

    def vector(self, parts: tuple[sp.Expr, sp.Expr]) -> Vec:
        """Along x and y, of what has these components along e_r and e_φ."""
        out = self.outward
        found: Vec = out * parts[0] + out.turned() * parts[1]
        return found


def spokes_of(scene: Scene) -> dict[str, Spoke]:
    """The particles that are placed so with a coordinate of the file, by name."""
    coordinates = set(scene.ledger.coordinates)
    found: dict[str, Spoke] = {}
    points = {p.name: p.place for p in scene.problem.points}
    for body in scene.problem.bodies:
        where = body.shape.place if isinstance(body.shape, Particle) else None
        place = points.get(where) if isinstance(where, str) else None
        if not isinstance(place, Polar) or scene.owner(place.origin) != GROUND:
            continue
        about = scene.formulas.get(place.origin)
        if about is None or coordinates & (about.x.value.free_symbols | about.y.value.free_symbols):
            continue
        distance, angle = scene.evaluator.jet(place.distance), scene.evaluator.jet(place.angle)
        known = None not in (distance.rate, distance.second, angle.rate, angle.second)
        if known and coordinates & (distance.value.free_symbols | angle.value.free_symbols):
            found[body.name] = Spoke(Vec(about.x.value, about.y.value), place.origin, distance, angle)
    return found
