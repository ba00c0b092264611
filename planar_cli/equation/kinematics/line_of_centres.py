"""What rolls on a fixed rim: the angle of the line of centres is its coordinate, not the angle by which it has turned.

The arcs on both rims are the same, ψ ρ = (ψ - θ) ρ_own, so that ψ = -ρ_own θ/(ρ - ρ_own); radii inside one another have
the same sign. (An Introduction to Planar Dynamics, 2.3.)
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import Tree, walk
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND, Circle
from planar_cli.records import record

VERTICAL = " from the vertical"
"""Ends the words of an angle that is counted from a line of centres drawn upright."""


@record
class LineOfCentres:
    """The line from the centre of a fixed rim to that of a body that rolls on it. `drawn`: its angle where the body is
    drawn, rad; `ratio`: by how much it turns for each radian that the body turns; `words`: what the angle is.
    """

    name: str
    drawn: sp.Expr
    ratio: sp.Expr
    words: str


def line_of_centres(scene: Scene, edge: Edge, surface: str, alone: bool) -> LineOfCentres | None:
    """None: it rolls on what is straight or moves, nothing pulls it down, the file places it by a coordinate of its
    own, or it speaks of how far it has turned.
    `surface`: the name of that on which it rolls; `alone`: is it the only body that turns?
    """
    joining = edge.joining
    if joining is None or joining.rolling is None or edge.parent != GROUND or edge.spin is None:
        return None
    if joining.drift is not None or scene.problem.plane != "vertical" or _speaks_of_turning(scene, edge.body):
        return None
    roll = joining.rolling
    own, other = (roll.base, roll.mover) if edge.backward else (roll.mover, roll.base)
    shape = scene.surfaces[surface].shape if surface in scene.surfaces else None
    if own == 0 or other == 0 or not isinstance(shape, Circle):
        return None
    normal = roll.tangent.turned()
    reach: Vec = normal * (1 / own - 1 / other)
    if (reach.x.free_symbols | reach.y.free_symbols) & set(scene.ledger.coordinates):
        return None
    ratio = simplified(-(1 / own) / (1 / other - 1 / own))
    place = scene.own_name(edge.body)
    upright = scene.is_zero(reach.x)
    words = f"angle of {shape.center}{place}{VERTICAL}" if upright else f"angle of {place} on its circle"
    drawn = sp.S.Zero if upright else simplified(sp.atan2(reach.y, reach.x))
    return LineOfCentres("phi" if alone else f"phi_{edge.body}", drawn, ratio, words)


def _speaks_of_turning(scene: Scene, body: str) -> bool:
    """Does a find, a state or a law speak of the angle of the body, or of how often it has turned?"""
    problem = scene.problem
    sides: list[Tree] = [f.found.what for f in problem.find]
    sides += [r for s in problem.states for r in s.relations] + list(problem.instant or ())
    sides += [law.statement for law in problem.motion]
    return any(
        isinstance(q, Quantity) and q.word in ("theta", "count") and (body in q.things or q.word == "count")
        for side in sides
        for q in walk(side)
    )
