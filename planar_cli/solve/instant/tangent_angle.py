"""The angle ψ from the radius to the tangent of a groove r(θ): the force of the groove is across it, so that its
components along and across a rod through the pole are N sin ψ and N cos ψ.

    tan ψ = r/(dr/dθ)                            (An Introduction to Planar Dynamics, 1.3.)
"""

from __future__ import annotations

from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.scene.curves import curve_formula
from planar_cli.equation.system.system import System
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.facts import Joining
from planar_cli.problem.scene.scene import GROUND, Curve

CLOSE = Decimal("1e-40")
LONGEST = 20
GROOVE = "groove: "
"""So begin the titles of what is told with the groove: r and ψ."""
TANGENT = "angle from the radius"
"""So goes on that of ψ."""


def of_groove(coefficient: sp.Expr, system: System, value: Valuation) -> sp.Expr | None:
    """A coefficient that is r of a groove, or the sine or cosine of its ψ, or the opposite; None: it is not."""
    radius = as_radius(coefficient, system, value)
    return by_tangent_angle(coefficient, system, value) if radius is None else radius


def by_tangent_angle(coefficient: sp.Expr, system: System, value: Valuation) -> sp.Expr | None:
    """A coefficient that is the sine or cosine of ψ, or its opposite; None: it is not."""
    size = value.known(coefficient)
    for joining in system.tree.closures if size is not None else ():
        quotient = _quotient(system, joining, value)
        slope = None if quotient is None else value.known(quotient)
        if size is None or quotient is None or not slope:
            continue
        # 0 < ψ < 180°: the sine is positive, the cosine has the sign of the slope.
        sine = abs(slope) / (1 + slope * slope).sqrt()
        for function, part in ((sp.sin, sine), (sp.cos, sine / slope)):
            if abs(abs(size) - abs(part)) <= CLOSE:
                angle = function(_angle(system, joining, quotient, slope))
                return angle if size * part > 0 else -angle
    return None


def as_radius(coefficient: sp.Expr, system: System, value: Valuation) -> sp.Expr | None:
    """A coefficient that is the radius r of the groove, or its opposite; None: it is not."""
    for joining in system.tree.closures if not coefficient.is_number else ():
        if _quotient(system, joining, value) is None:
            continue
        surface = _groove(system, joining)
        assert surface is not None
        radius = curve_formula(system.scene, surface[1])[1]
        for sign in (1, -1):
            if value.is_zero(coefficient - sign * radius):
                return sign * _named(system, "r", radius, "m", f"radius of {joining.place}")
    return None


def radius_told(system: System, value: Valuation) -> sp.Expr | None:
    """The radius as equations have it: its letter, or a short formula; None: no groove is told so."""
    letter = next((s for s, t in system.scene.ledger.titles.items() if t.startswith(f"{GROOVE}radius")), None)
    if letter is not None:
        return letter
    grooves = (_groove(system, j) for j in system.tree.closures if _quotient(system, j, value) is not None)
    return next((curve_formula(system.scene, g[1])[1] for g in grooves if g is not None), None)


def _quotient(system: System, joining: Joining, value: Valuation) -> sp.Expr | None:
    """r/(dr/dθ) of a groove of the ground in which a particle slides; None: it is none that is told so."""
    surface = _groove(system, joining)
    if surface is None:
        return None
    angle, radius = curve_formula(system.scene, surface[1])
    at = joining.point
    if angle not in system.scene.ledger.units or value.known(angle) is None:
        return None
    here = radius * sp.cos(angle) - at.x, radius * sp.sin(angle) - at.y
    quotient = simplified(radius / sp.diff(radius, angle)) if sp.diff(radius, angle) != 0 else sp.S.Zero
    known = all(value.is_zero(p) for p in here)
    return quotient if known and quotient != 0 and not longer(quotient, LONGEST) else None


def _groove(system: System, joining: Joining) -> tuple[str, Curve] | None:
    scene, edges = system.scene, {e.body: e for e in system.tree.edges}
    edge = edges.get(joining.mover)
    rod = edges.get(edge.parent) if edge is not None else None
    if rod is None or rod.joining is None or (rod.joining.point.x, rod.joining.point.y) != (0, 0):
        return None
    joint = next((j for j in scene.problem.joints if j.name == joining.joint), None)
    along = getattr(joint, "along", None)
    surface = scene.surfaces.get(getattr(along, "name", along) or "")
    if surface is None or surface.body is not None or joining.base != GROUND or scene.rigid(joining.mover):
        return None
    shape = surface.shape
    return (surface.name, shape) if isinstance(shape, Curve) and shape.kind == "r" else None


def _angle(system: System, joining: Joining, quotient: sp.Expr, slope: Decimal) -> sp.Symbol:
    """ψ, named once."""
    formula = sp.atan(quotient) if slope > 0 else sp.pi + sp.atan(quotient)
    return _named(system, "psi", formula, "deg", f"{TANGENT} of {joining.place} to the tangent")


def _named(system: System, name: str, formula: sp.Expr, unit: str, words: str) -> sp.Symbol:
    """A letter for the formula, the same each time."""
    ledger, title = system.scene.ledger, f"{GROOVE}{words}"
    known = next((s for s, t in ledger.titles.items() if t == title), None)
    return ledger.define(name, formula, unit, title) if known is None else known
