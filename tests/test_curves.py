"""Curves of moving points: what they are called, their equations, and that every equation is true along the path."""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from typing import Any

import mpmath
import pytest
import sympy as sp

from planar_cli.calculus.curves import curve_numeric, curve_of
from planar_cli.equation.values.exact import Valuation

t, theta, phi = sp.symbols("t theta phi", real=True)
a, b, c, d, h, k, L, r, R, g, v0, omega, beta = sp.symbols("a b c d h k L r R g v0 omega beta", positive=True)
X, Y, VX, VY = sp.symbols("x y vx vy", real=True)
POLAR_R, POLAR_THETA = sp.symbols("r theta", real=True)
sin, cos, Q = sp.sin, sp.cos, sp.Rational
NOTHING = Valuation({})


def same(equation: sp.Eq | None, left: Any, right: Any) -> bool:
    """Do two equations say the same, up to a factor without the axes?"""
    assert equation is not None
    ratio = sp.simplify((equation.lhs - equation.rhs) / (left - right))
    return not ratio.free_symbols & {X, Y, VX, VY, POLAR_R, POLAR_THETA} and ratio != 0


CASES = [
    ("circle about (0, 0)", 15 * cos(sp.pi * t / 4), 15 * sin(sp.pi * t / 4), t, X**2 + Y**2, 225),
    ("circle about (a, h)", a + R * cos(omega * t + beta), h + R * sin(omega * t + beta), t,
     (X - a) ** 2 + (Y - h) ** 2, R**2),
    ("circle about (a/2, 0)", a * cos(theta) ** 2, a * sin(theta) * cos(theta), theta,
     (X - a / 2) ** 2 + Y**2, a**2 / 4),
    ("circle about (0, 0)", R * cos(sp.pi / 2 + sin(t) / 3), R * sin(sp.pi / 2 + sin(t) / 3), t, X**2 + Y**2, R**2),
    ("circle about (0, 0)", t, sp.sqrt(R**2 - t**2), t, X**2 + Y**2, R**2),
    ("circle about (0, 0)", d * t / sp.sqrt(t**2 + d**2), d**2 / sp.sqrt(t**2 + d**2), t, X**2 + Y**2, d**2),
    ("parabola", v0 * cos(beta) * t, v0 * sin(beta) * t - g * t**2 / 2, t,
     Y, X * sp.tan(beta) - g * X**2 / (2 * v0**2 * cos(beta) ** 2)),
    ("parabola", 3 * t, 1 + 4 * t - Q(981, 200) * t**2, t, Y, 1 + Q(4, 3) * X - Q(109, 200) * X**2),
    ("parabola", t**2, t, t, X, Y**2),
    ("parabola", a * sin(omega * t), b * cos(2 * omega * t), t, Y, b - 2 * b * X**2 / a**2),
    ("parabola", t**2 + t, t**2 - 2 * t, t, (X - Y) ** 2, 6 * X + 3 * Y),
    ("straight line", h + 2 * t, 3 - 5 * t, t, 2 * Y, 6 - 5 * X + 5 * h),
    ("straight line", v0 * cos(beta), v0 * sin(beta) - g * t, t, X, v0 * cos(beta)),
    ("straight line", a * cos(omega * t), b * cos(omega * t), t, Y, b * X / a),
    ("straight line", d, d * sp.tan(theta), theta, X, d),
    ("straight line", t, h, t, Y, h),
    ("ellipse", a * cos(omega * t), b * sin(omega * t), t, X**2 / a**2 + Y**2 / b**2, 1),
    ("ellipse", (L - b) * cos(theta), b * sin(theta), theta, X**2 / (L - b) ** 2 + Y**2 / b**2, 1),
    ("ellipse", a * cos(omega * t), b * sin(omega * t + sp.pi / 6), t,
     X**2 / a**2 + Y**2 / b**2 - X * Y / (a * b), Q(3, 4)),
    ("ellipse", 2 * cos(theta) / (2 + cos(theta)), 2 * sin(theta) / (2 + cos(theta)), theta,
     4 * (X**2 + Y**2), (2 - X) ** 2),
    ("hyperbola", a * sp.exp(k * t), b * sp.exp(-k * t), t, X * Y, a * b),
    ("hyperbola", a * sp.cosh(k * t), b * sp.sinh(k * t), t, X**2 / a**2 - Y**2 / b**2, 1),
    ("hyperbola", a * t, b / t, t, X * Y, a * b),
    ("semicubical parabola", t**2, t**3, t, Y**2, X**3),
    ("Lissajous figure", a * sin(omega * t), b * sin(2 * omega * t), t, Y**2, 4 * b**2 * X**2 * (a**2 - X**2) / a**4),
    ("sine curve", v0 * t, a * sin(omega * t), t, Y, a * sin(omega * X / v0)),
    ("hypocycloid", 2 * cos(theta) + cos(2 * theta), 2 * sin(theta) - sin(2 * theta), theta,
     (X**2 + Y**2) ** 2 + 18 * (X**2 + Y**2), 8 * X**3 - 24 * X * Y**2 + 27),
    ("curve", a * (1 - sp.exp(-k * t)), b * (1 - sp.exp(-k * t)) - g * t / k, t,
     Y, b * X / a + g * sp.log(1 - X / a) / k**2),
    ("Archimedean spiral", b * theta * cos(theta), b * theta * sin(theta), theta, POLAR_R, b * POLAR_THETA),
    ("Archimedean spiral", v0 * t * cos(omega * t), v0 * t * sin(omega * t), t, POLAR_R, v0 * POLAR_THETA / omega),
    ("logarithmic spiral", a * sp.exp(b * theta) * cos(theta), a * sp.exp(b * theta) * sin(theta), theta,
     POLAR_R, a * sp.exp(b * POLAR_THETA)),
    ("cardioid", a * (1 + cos(theta)) * cos(theta), a * (1 + cos(theta)) * sin(theta), theta,
     POLAR_R, a * (1 + cos(POLAR_THETA))),
]  # fmt: skip


@pytest.mark.parametrize(("words", "x", "y", "parameter", "left", "right"), CASES)
def test_paths(words: str, x: sp.Expr, y: sp.Expr, parameter: sp.Symbol, left: Any, right: Any) -> None:
    curve = curve_of(x, y, parameter, NOTHING)
    assert curve.words == words
    assert same(curve.equation, left, right), curve.equation
    assert curve.steps[-1][1] == curve.equation
    assert curve.holds == ""


def test_example_1_12() -> None:
    x, y = 15 * cos(sp.pi * t / 4), 15 * sin(sp.pi * t / 4)
    path = curve_of(x, y, t, NOTHING)
    assert (path.equation, path.radius, path.centre) == (sp.Eq(X**2 + Y**2, 225), 15, (0, 0))
    assert [words for words, _ in path.steps] == ["", "", "squared and added, since cos² + sin² = 1"]
    hodograph = curve_of(sp.diff(x, t), sp.diff(y, t), t, NOTHING, ("vx", "vy"))
    assert hodograph.equation == sp.Eq(VX**2 + VY**2, 225 * sp.pi**2 / 16)
    assert hodograph.radius == 15 * sp.pi / 4


def test_the_path_of_a_projectile_is_written_as_in_the_book() -> None:
    curve = curve_of(v0 * cos(beta) * t, h + v0 * sin(beta) * t - g * t**2 / 2, t, NOTHING)
    solved, put_in = curve.steps
    assert solved == ("from x", sp.Eq(t, X / (v0 * cos(beta))))
    right = h + X * sp.tan(beta) - g * X**2 / (2 * v0**2 * cos(beta) ** 2)
    assert put_in == ("in y", sp.Eq(Y, right))


ROLLING = [
    ("cycloid", r * (phi - sin(phi)), r * (1 - cos(phi)), phi),
    ("cycloid", r * (omega * t - sin(omega * t)), r * (1 - cos(omega * t)), t),
    ("cycloid", r * (omega * t**2 / 2 - sin(omega * t**2 / 2)), r * (1 - cos(omega * t**2 / 2)), t),
    ("curtate cycloid", Q(3, 10) * phi - Q(1, 5) * sin(phi), Q(3, 10) - Q(1, 5) * cos(phi), phi),
    ("prolate cycloid", Q(3, 10) * phi - Q(2, 5) * sin(phi), Q(3, 10) - Q(2, 5) * cos(phi), phi),
    ("trochoid", a * phi - b * sin(phi), a - b * cos(phi), phi),
]


@pytest.mark.parametrize(("kind", "x", "y", "parameter"), ROLLING)
def test_a_point_of_a_rolling_disk(kind: str, x: sp.Expr, y: sp.Expr, parameter: sp.Symbol) -> None:
    curve = curve_of(x, y, parameter, NOTHING)
    assert (curve.words, curve.holds) == (kind, "on half an arch")
    assert curve.equation is not None


def test_a_cycloid_on_half_an_arch() -> None:
    curve = curve_of(r * (phi - sin(phi)), r * (1 - cos(phi)), phi, NOTHING)
    assert curve.equation == sp.Eq(X, r * sp.acos(1 - Y / r) - sp.sqrt(2 * r * Y - Y**2))


def test_the_hodograph_of_a_rim_point_is_a_circle() -> None:
    curve = curve_of(r * omega * (1 - cos(omega * t)), r * omega * sin(omega * t), t, NOTHING, ("vx", "vy"))
    assert curve.words == "circle about (omega*r, 0)"
    assert same(curve.equation, (VX - r * omega) ** 2 + VY**2, (r * omega) ** 2)


def test_numbers_of_letters_decide_the_name() -> None:
    equal = Valuation({a: Decimal(3), b: Decimal(3)})
    curve = curve_of(a * cos(t), b * sin(t), t, equal)
    assert curve.kind == "circle"
    wheel = Valuation({a: Decimal("0.3"), b: Decimal("0.4")})
    assert curve_of(a * phi - b * sin(phi), a - b * cos(phi), phi, wheel).kind == "prolate cycloid"
    draws = frozenset({a, b})
    assert curve_of(a * phi - b * sin(phi), a - b * cos(phi), phi, wheel, letters=draws).kind == "trochoid"


def test_a_point_at_rest() -> None:
    curve = curve_of(a, h, t, NOTHING)
    assert (curve.words, curve.equation, curve.centre) == ("point: it stays at (a, h)", None, (a, h))


def test_a_letter_of_the_file_keeps_its_name_in_polar_equations() -> None:
    curve = curve_of(r * t * cos(omega * t), r * t * sin(omega * t), t, NOTHING)
    assert str(curve.equation) == "Eq(R, r*theta/omega)"


GIVEN_ONLY = [
    ("a curve given by x(t) and y(t)", (a * cos(t) + b * sin(sp.sqrt(2) * t), c * t * sin(3 * t))),
    ("Lissajous figure, given by x(t) and y(t)", (a * cos(t), b * cos(sp.sqrt(2) * t))),
    ("involute of a circle, given by x(t) and y(t)", (a * (cos(t) + t * sin(t)), a * (sin(t) - t * cos(t)))),
    ("epicycloid, given by x(t) and y(t)",
     (5 * cos(t) - 2 * cos(Q(5, 2) * t) + a, 5 * sin(t) - 2 * sin(Q(5, 2) * t))),
]  # fmt: skip


@pytest.mark.parametrize(("words", "path"), GIVEN_ONLY)
def test_without_an_equation(words: str, path: tuple[sp.Expr, sp.Expr]) -> None:
    curve = curve_of(*path, t, NOTHING)
    assert (curve.words, curve.equation) == (words, None)


def test_a_coupler_point_is_given_up_soon() -> None:
    diagonal = d**2 + r**2 - 2 * d * r * cos(theta)
    height = sp.sqrt(1 - (L**2 + diagonal - b**2) ** 2 / (4 * L**2 * diagonal))
    x = r * cos(theta) + L * (d - r * cos(theta)) / sp.sqrt(diagonal) * height
    assert curve_of(x, r * sin(theta) + L * height, theta, NOTHING).equation is None


def test_the_middle_of_a_connecting_rod() -> None:
    x = r * cos(theta) + sp.sqrt(L**2 - r**2 * sin(theta) ** 2) / 2
    curve = curve_of(x, r * sin(theta) / 2, theta, NOTHING)
    assert curve.equation == sp.Eq((X - sp.sqrt(L**2 - 4 * Y**2) / 2) ** 2, r**2 - 4 * Y**2)


Shape = Callable[[Any], Any]
SAMPLED: list[tuple[str, Shape, Shape, Any, Any]] = [
    ("circle about (3, -1)", lambda u: 3 + 2 * mpmath.cos(u), lambda u: 2 * mpmath.sin(u) - 1,
     (X - 3) ** 2 + (Y + 1) ** 2, 4),
    ("circle about (1000, 0)", lambda u: 1000 + mpmath.cos(u) / 1000, lambda u: mpmath.sin(u) / 1000,
     (X - 1000) ** 2 + Y**2, Q(1, 10**6)),
    ("circle about (0, 0)", lambda u: 15 * mpmath.pi / 4 * mpmath.cos(u), lambda u: 15 * mpmath.pi / 4 * mpmath.sin(u),
     X**2 + Y**2, 225 * sp.pi**2 / 16),
    ("ellipse", lambda u: 3 * mpmath.cos(u), mpmath.sin, X**2 / 9 + Y**2, 1),
    ("ellipse", lambda u: 3 * mpmath.cos(u) + mpmath.sin(u), mpmath.sin, (X - Y) ** 2 + 9 * Y**2, 9),
    ("parabola", lambda u: u, lambda u: u**2 / 3 - u + 2, Y, X**2 / 3 - X + 2),
    ("hyperbola", lambda u: u, lambda u: 5 / u, X * Y, 5),
    ("hyperbola", lambda u: 3 * mpmath.cosh(u), lambda u: 2 * mpmath.sinh(u), X**2 / 9 - Y**2 / 4, 1),
    ("straight line", lambda u: u**2, lambda u: 2 * u**2 / 7 - 1, Y, 2 * X / 7 - 1),
    ("straight line", lambda u: mpmath.mpf(2), lambda u: u, X, 2),
]  # fmt: skip


def sampled(x: Shape, y: Shape, count: int = 14) -> list[tuple[Decimal, Decimal]]:
    with mpmath.workdps(75):
        places = [mpmath.mpf(1 + 4 * i) / 10 for i in range(count)]
        return [(Decimal(mpmath.nstr(x(u), 62)), Decimal(mpmath.nstr(y(u), 62))) for u in places]


@pytest.mark.parametrize(("words", "x", "y", "left", "right"), SAMPLED)
def test_curves_through_points(words: str, x: Shape, y: Shape, left: Any, right: Any) -> None:
    curve = curve_numeric(sampled(x, y))
    assert curve.words == words
    assert same(curve.equation, left, right), curve.equation


def test_points_of_no_conic() -> None:
    cycloid = curve_numeric(sampled(lambda u: u - mpmath.sin(u), lambda u: 1 - mpmath.cos(u)))
    assert (cycloid.words, cycloid.equation) == ("curve", None)
    still = curve_numeric(sampled(lambda u: mpmath.mpf(2), lambda u: mpmath.mpf(1)))
    assert still.words == "point: it stays at (2, 1)"
    with pytest.raises(ValueError, match="12 points or more"):
        curve_numeric(sampled(mpmath.cos, mpmath.sin, 11))


def test_too_few_different_points_decide_nothing() -> None:
    points = sampled(mpmath.cos, mpmath.sin, 5)
    assert curve_numeric([*points, *points, *points]).words == "curve"


def test_nearly_a_circle_is_none() -> None:
    curve = curve_numeric(sampled(mpmath.cos, lambda u: mpmath.sin(u) + mpmath.mpf("1e-15") * mpmath.sin(3 * u)))
    assert curve.words == "curve"
