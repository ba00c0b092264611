"""Curvature of a plane curve and its radius of curvature.

κ = dφ/ds, φ the direction of the tangent and s the length along the curve (An Introduction to Planar Dynamics,
section 1.4.2, equations 1.56 and 1.57): positive where the curve turns counterclockwise as it is run through. Units: κ
in 1/m for lengths in metres; angles in radians.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.calculus.curve_plain import plainer, rationally
from planar_cli.equation.expansion import expanded
from planar_cli.equation.plain import MANY, longer


def _ratio(above: sp.Expr, square: sp.Expr) -> sp.Expr:
    """above/square^(3/2), tidied; a square that is a perfect one gives its root."""
    above, square = plainer(expanded(above)), plainer(square)
    root = sp.sqrt(square if longer(square, MANY) else rationally(sp.factor, square))
    return plainer(plainer(above / square) / root)


def curvature_explicit(y: Any, x: sp.Symbol) -> sp.Expr:
    """Of y(x), run through towards larger x: κ = y''/(1 + y'²)^(3/2), with ' = d/dx (example 1-13, formula 13)."""
    first = sp.diff(y, x)
    return _ratio(sp.diff(first, x), 1 + first**2)


def curvature_parametric(x: Any, y: Any, parameter: sp.Symbol) -> sp.Expr:
    """Of x(p), y(p), run through towards larger p: κ = (x' y'' - y' x'')/(x'² + y'²)^(3/2), with ' = d/dp."""
    dx, dy = sp.diff(x, parameter), sp.diff(y, parameter)
    return _ratio(dx * sp.diff(dy, parameter) - dy * sp.diff(dx, parameter), dx**2 + dy**2)


def curvature_polar(r: Any, theta: sp.Symbol) -> sp.Expr:
    """Of r(θ), run through towards larger θ: κ = (r² + 2 r'² - r r'')/(r² + r'²)^(3/2), with ' = d/dθ."""
    r = sp.sympify(r)
    first = sp.diff(r, theta)
    return _ratio(r**2 + 2 * first**2 - r * sp.diff(first, theta), r**2 + first**2)


def radius_of_curvature(curvature: Any) -> sp.Expr:
    """ρ = 1/|κ| (equation 1.57), never negative; infinite (`oo`) on a straight line and at a point of inflexion."""
    curvature = sp.sympify(curvature)
    return sp.oo if curvature == 0 else 1 / sp.Abs(curvature)
