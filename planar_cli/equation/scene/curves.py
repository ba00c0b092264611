"""Curves y(x) and r(theta) as drawn in the axes of the body that carries them, wherever that body is now."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.equation.scene.displacement import Displacement
from planar_cli.equation.scene.pose import HERE, Pose
from planar_cli.equation.values.ledger import Ledger
from planar_cli.errors import refuse
from planar_cli.problem.language.expression import Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.outlines import Bend
from planar_cli.problem.scene.scene import GROUND, Curve, Surface

ZERO = sp.S.Zero
Sign = Callable[[sp.Expr], int]


class CurveSetting(Protocol):
    """What a curve asks of the scene in which it is drawn."""

    ledger: Ledger
    displacement: Displacement | None

    def value(self, side: Side) -> sp.Expr: ...
    def length(self, v: Vec) -> sp.Expr: ...
    def sign(self, expr: sp.Expr) -> int: ...


def curve_place(scene: CurveSetting, curve: Curve) -> tuple[sp.Symbol, Vec]:
    """The variable of a curve (x in m, or theta in rad), and the place that goes with it, in the axes as drawn."""
    x, formula = curve_formula(scene, curve)
    return x, Vec(x, formula) if curve.kind == "y" else Vec(formula * sp.cos(x), formula * sp.sin(x))


def curve_formula(scene: CurveSetting, curve: Curve) -> tuple[sp.Symbol, sp.Expr]:
    """The variable of a curve and its formula."""
    name = "x" if curve.kind == "y" else "theta"
    x = sp.Symbol(name, real=True)
    symbols = scene.ledger.symbols
    saved = symbols.get(name)
    symbols[name] = x
    formula = scene.value(curve.formula)
    if saved is None:
        del symbols[name]
    else:
        symbols[name] = saved
    return x, formula


def carrier_pose(scene: CurveSetting, surface: Surface) -> Pose:
    """Where the body of a surface is now."""
    poses = scene.displacement.poses if scene.displacement is not None else {}
    return poses.get(surface.body or GROUND, HERE)


def parameter(curve: Curve, pose: Pose, point: Vec, sign: Sign) -> sp.Expr:
    """The x or theta of a place as the carrier of the curve sees it; theta counts the turns of the carrier. `sign`: of
    an expression as drawn.
    """
    seen = point - pose.point(Vec(ZERO, ZERO))
    if curve.kind == "y":
        return simplified(sp.cos(pose.turn) * seen.x + sp.sin(pose.turn) * seen.y)
    return direction_of(seen, sign) - pose.turn


def bend_at(scene: CurveSetting, surface: Surface, curve: Curve, pose: Pose, point: Vec) -> Bend:
    """A curve where a point of it is now: what is drawn, carried along by its body. Refused at a cusp."""
    x, formula = curve_formula(scene, curve)
    at = parameter(curve, pose, point, scene.sign)
    f, first, second, third = (sp.diff(formula, x, n).subs(x, at) for n in range(4))
    if curve.kind == "y":
        # y'' / (1 + y'²)^(3/2)
        along, out, cross, more = Vec(sp.S.One, first), Vec(at, f), second, third
        gain = first * second
        speed, tangent, place = scene.length(along), pose.vector(along), pose.point(out)
    else:
        # (r² + 2 r'² - r r'') / (r² + r'²)^(3/2), in parts along and across r, which stands still where its end does.
        angle = at + pose.turn
        radial = Vec(sp.cos(angle), sp.sin(angle))
        speed, cross = scene.length(Vec(first, f)), f**2 + 2 * first**2 - f * second
        more, gain = 2 * f * first + 3 * first * second - f * third, first * (f + second)
        tangent, place = radial * first + radial.turned() * f, pose.point(Vec(ZERO, ZERO)) + radial * f
    if speed == 0:
        text = f"{surface.name} comes to a point where something touches it, and has no direction there"
        raise refuse(surface.mark, "PL521", text, "let it touch beside the cusp")
    # With s' = speed, s'' = gain/s', cross' = more: d(cross/s'³)/ds.
    sharpening = more / speed**4 - 3 * cross * gain / speed**6
    return Bend(place, tangent / speed, simplified(cross / speed**3), sharpening)


def direction_of(seen: Vec, sign: Sign) -> sp.Expr:
    """The angle of a vector: one of its own letters where it is written with that angle, so that turns are counted."""
    if seen.x == 0:
        return sign(seen.y) * sp.pi / 2
    if seen.y == 0:
        return ZERO if sign(seen.x) >= 0 else sp.pi
    for s in sorted(seen.x.free_symbols & seen.y.free_symbols, key=lambda s: s.name):
        if identically_zero(seen.x * sp.sin(s) - seen.y * sp.cos(s)):
            return s if sign(seen.x * sp.cos(s) + seen.y * sp.sin(s)) >= 0 else s + sp.pi
    return simplified(sp.atan2(seen.y, seen.x))


def off_curve(scene: CurveSetting, curve: Curve, pose: Pose, point: Vec, sign: Sign) -> sp.Expr:
    """What vanishes where a place is on the curve: y - y(x), or r - r(theta)."""
    variable, formula = curve_formula(scene, curve)
    at = parameter(curve, pose, point, sign)
    seen = point - pose.point(Vec(ZERO, ZERO))
    if curve.kind == "y":
        height = sp.cos(pose.turn) * seen.y - sp.sin(pose.turn) * seen.x
        return simplified(height - formula.subs(variable, at))
    square = simplified(seen.dot(seen))
    length = sp.sqrt(square)
    if length.has(sp.Abs):
        length = length.replace(sp.Abs, lambda a: sign(a) * a)
    if length.atoms(sp.Pow) - square.atoms(sp.Pow):
        return simplified(square - formula.subs(variable, at) ** 2)
    return simplified(length - formula.subs(variable, at))
