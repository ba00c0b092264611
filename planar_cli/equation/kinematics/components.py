"""Particles whose place the file gives by coordinates: their velocity and acceleration by components.

    along the axes            v = x' i + y' j              a = x" i + y" j
    polar coordinates         v = r' e_r + r φ' e_φ        a = (r" - r φ'²) e_r + (r φ" + 2 r' φ') e_φ

(An Introduction to Planar Dynamics, 1.2, 1.3.)
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.scene.line_names import line_name
from planar_cli.equation.values.jets import Jet
from planar_cli.equation.values.parts_of_accelerations import CORIOLIS, NORMAL, TANGENTIAL, with_mark
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, At, Particle, Place, Polar
from planar_cli.records import record

if TYPE_CHECKING:
    from planar_cli.equation.scene.scene import Scene

Pair = tuple[sp.Expr, sp.Expr]

SHORT_NAME = 2
"""Names with more letters are set off from the axis of a component."""


@record
class Components:
    """Velocity [m/s] and acceleration [m/s²] along an axis, and across it (turned by 90° counterclockwise)."""

    axis: Vec
    """A unit vector: e_r, or i."""
    velocities: Pair
    accelerations: Pair
    origin: str = ""
    """The name of the fixed point from which e_r points; "" along the axes."""
    turns: str = ""
    """The coordinate with which e_r turns; "": it keeps its direction."""

    def ways(self, particle: str) -> list[tuple[Vec, str]]:
        """Along the line from the fixed point and across it, in words; along it in the sense of the acceleration."""
        if not self.origin:
            return []
        line = line_name(self.origin, particle)
        way = -self.axis if self.accelerations[0].could_extract_minus_sign() else self.axis
        return [(way, f"along {line}"), (self.axis.turned(), f"along the perpendicular to {line}")]

    def vector(self, parts: Pair) -> Vec:
        """Along x and y, of what has these components."""
        found: Vec = self.axis * parts[0] + self.axis.turned() * parts[1]
        return found


def components_of(scene: Scene) -> dict[str, Components]:
    """Of the particles that are placed with a coordinate of the file, by name."""
    found: dict[str, Components] = {}
    points = {p.name: p.place for p in scene.problem.points}
    for body in scene.problem.bodies:
        where = body.shape.place if isinstance(body.shape, Particle) else None
        place = points.get(where) if isinstance(where, str) else where
        own = _polar(scene, place) if isinstance(place, Polar) else _straight(scene, place)
        if own is not None:
            found[body.name] = own
    return found


def _polar(scene: Scene, place: Polar) -> Components | None:
    """About a point of the ground that stays where it is."""
    coordinates = set(scene.ledger.coordinates)
    about = scene.formulas.get(place.origin) if scene.owner(place.origin) == GROUND else None
    if about is None or coordinates & (about.x.value.free_symbols | about.y.value.free_symbols):
        return None
    jets = scene.evaluator.jet(place.distance), scene.evaluator.jet(place.angle)
    known = _known(scene, *jets)
    if known is None:
        return None
    (r, rate, second), (phi, turn, bend) = known
    axis = Vec(sp.cos(phi), sp.sin(phi))
    turns = next((s.name for s in scene.ledger.coordinates if s in phi.free_symbols), "")
    inward, ahead = with_mark(r * turn**2, NORMAL), with_mark(r * bend, TANGENTIAL)
    across = ahead + with_mark(2 * rate * turn, CORIOLIS)
    return Components(axis, (rate, r * turn), (second - inward, across), place.origin, turns)


def _straight(scene: Scene, place: Place | None) -> Components | None:
    """Of coordinates x and y that grow in proportion to those of the file: others are differentiated step by step."""
    if not isinstance(place, At):
        return None
    known = _known(scene, scene.evaluator.jet(place.x), scene.evaluator.jet(place.y))
    if known is None:
        return None
    (_, v_x, a_x), (_, v_y, a_y) = known
    if set(scene.ledger.coordinates) & (v_x.free_symbols | v_y.free_symbols):
        return None
    return Components(Vec(sp.S.One, sp.S.Zero), (v_x, v_y), (a_x, a_y))


def _known(scene: Scene, *jets: Jet) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]] | None:
    """Lengths or angles with their rates, where they hold a coordinate and one instant tells them."""
    found = [(j.value, j.rate, j.second) for j in jets if j.rate is not None and j.second is not None]
    varies = any(set(scene.ledger.coordinates) & j.value.free_symbols for j in jets)
    return found if varies and len(found) == len(jets) else None


def component(name: str, axis: str) -> str:
    """The index of a component: Gx of a point G, ball_x of what has a word for a name."""
    return f"{name}{axis}" if len(name) <= SHORT_NAME else f"{name}_{axis}"
