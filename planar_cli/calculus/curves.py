"""The curve of a moving point: its path in the plane, or its hodograph in the plane of velocities.

A path is given by x(p), y(p); the parameter p (time, an angle, any coordinate) is eliminated and the curve named (An
Introduction to Planar Dynamics, section 1.4.1, example 1-12). Every equation has been tried at places of the path to
sixty digits before it is returned; where none is found there is none. Units: those of the coordinates; angles in
radians.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_algebra import by_powers, by_resultant, by_solving, in_exponential, straight
from planar_cli.calculus.curve_conics import Plane
from planar_cli.calculus.curve_numeric import numeric
from planar_cli.calculus.curve_plain import plainer
from planar_cli.calculus.curve_polar import involute, lissajous, polar, trochoid, wheel_on_wheel
from planar_cli.calculus.curve_trial import Trial
from planar_cli.calculus.curve_waves import Waves, ellipse, halved, one_wave, rational, resultant, waves_of
from planar_cli.calculus.curve_words import CONIC, CURVE, POINT, Curve, Step
from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Valuation

PATH_AXES = ("x", "y")
POLAR = ("r", "theta")
LONGEST = 400
"""Nothing is eliminated from longer coordinates."""
_NONE = frozenset[sp.Symbol]()


def curve_of(
    x: Any,
    y: Any,
    parameter: sp.Symbol,
    valuation: Valuation,
    axes: tuple[str, str] = PATH_AXES,
    polar_axes: tuple[str, str] = POLAR,
    letters: frozenset[sp.Symbol] = _NONE,
) -> Curve:
    """The curve x(p), y(p).

    `valuation`: numbers of the symbols; those that it does not know, and `letters`, are letters that stay (a name like
    "ellipse" is then given only if it fits for all values). `axes`: names of the coordinates in the equation;
    `polar_axes`: of distance and angle, where a polar equation says it better.
    """
    path = (_exact(x), _exact(y))
    given_by = f"{axes[0]}({parameter}) and {axes[1]}({parameter})"
    trial = Trial(path, parameter, valuation, letters)
    across, up = (sp.Symbol(name, real=True) for name in axes)
    plane = Plane(across, up, path, trial)
    if not any(e.has(parameter) for e in path) or all(trial.zero(sp.diff(e, parameter)) for e in path):
        centre = tuple(e.subs(parameter, 0) if e.has(parameter) else e for e in path)
        steps: tuple[Step, ...] = (("it does not move", sp.Eq(across, centre[0])), ("", sp.Eq(up, centre[1])))
        return Curve(POINT, None, steps, centre=(centre[0], centre[1]))
    if any(longer(e, LONGEST) for e in path):
        return Curve(CURVE, given_by=given_by)
    found = _searched(plane, polar_axes, given_by) or Curve(CURVE, given_by=given_by)
    if found.kind == CURVE:
        return replace(found, kind=wheel_on_wheel(plane) or lissajous(plane) or CURVE)
    return found


def curve_numeric(points: Sequence[tuple[Decimal, Decimal]], axes: tuple[str, str] = PATH_AXES) -> Curve:
    """The curve through twelve or more points, each exact to far more than twenty digits: line, conic, or a curve."""
    return numeric(points, axes)


def _exact(expr: Any) -> sp.Expr:
    """Machine floats as the fractions that they were written as."""
    expr = sp.sympify(expr)
    return sp.nsimplify(expr, rational=True) if expr.has(sp.Float) else expr


def _searched(plane: Plane, polar_axes: tuple[str, str], given_by: str) -> Curve | None:
    """Every way in turn, plain ones first."""
    single, power = _single_power(plane)
    with_waves = _with_waves(single, polar_axes, given_by)
    ways: tuple[Callable[[], Curve | None], ...] = (
        lambda: straight(plane),
        lambda: with_waves(False),
        lambda: by_powers(plane),
        lambda: by_solving(plane, simple=True),
        lambda: polar(plane, polar_axes),
        lambda: by_resultant(single),
        lambda: _exponential(plane),
        lambda: with_waves(True),
        lambda: by_solving(plane, simple=False),
    )
    for way in ways:
        found = way()
        if found is not None:
            return _spoken(found, power)
    return None


def _spoken(curve: Curve, power: dict[Any, Any]) -> Curve:
    """The curve with its steps in the parameter of the file."""
    if not power:
        return curve
    ((q, meaning),) = power.items()
    return replace(curve, steps=tuple((w.replace(str(q), str(meaning)), e.xreplace(power)) for w, e in curve.steps))


def _single_power(plane: Plane) -> tuple[Plane, dict[Any, Any]]:
    """The path in q = p^n, if p occurs only in powers of that: an angle α t²/2 and a way α r t²/2 go with q = t²."""
    p = plane.trial.parameter
    powers = {q.exp for e in plane.path for q in e.atoms(sp.Pow) if q.base == p}
    if not powers or not all(n.is_Integer and n > 1 for n in powers):
        return plane, {}
    n = sp.gcd_list(list(powers))
    q = sp.Dummy("q", positive=True)
    path = [e.xreplace({p**k: q ** (k / n) for k in powers}) for e in plane.path]
    if n == 1 or any(e.has(p) for e in path):
        return plane, {}
    return Plane(plane.x, plane.y, (path[0], path[1]), plane.trial.over(q)), {q: p**n}


def _with_waves(plane: Plane, polar_axes: tuple[str, str], given_by: str) -> Callable[[bool], Curve | None]:
    """Ways for paths in cos u and sin u; the first ones, or (`late`) those that give long equations."""
    waves = waves_of(*plane.path, plane.trial.parameter)
    short = _short(waves, plane)

    def way(late: bool) -> Curve | None:
        if waves is None or short is None:
            return None
        if late:
            return resultant(plane, short)
        ways = (
            ellipse(plane, short)
            or _quotient(plane, short, polar_axes)
            or trochoid(plane, waves, given_by)
            or involute(plane, waves, given_by)
            or polar(plane, polar_axes)
            or one_wave(plane, short)
        )
        return ways if ways is None or ways.equation is None or ways.holds or _true(plane, ways) else None

    return way


def _quotient(plane: Plane, waves: Waves, polar_axes: tuple[str, str]) -> Curve | None:
    """A conic as seen from its focus; in polar coordinates, if letters leave open which one it is."""
    found = rational(plane, waves)
    if found is not None and found.kind == CONIC:
        around = polar(plane, polar_axes)
        return found if around is None else replace(around, kind=CONIC)
    return found


def _short(waves: Waves | None, plane: Plane) -> Waves | None:
    return None if waves is None else halved(waves, plane.trial)


def _true(plane: Plane, curve: Curve) -> bool:
    if curve.equation is None or not curve.equation.has(plane.x, plane.y):
        return True
    return plane.true(curve.equation)


def _exponential(plane: Plane) -> Curve | None:
    """Paths in E = exp(k p): hyperbolas of cosh and sinh, and powers of one exponential."""
    found = in_exponential(plane)
    if found is None:
        return None
    inner, meaning = found
    e = inner.trial.parameter
    curve = by_powers(inner) or by_solving(inner, simple=True) or by_resultant(inner)
    if curve is None or curve.equation is None or not plane.true(curve.equation):
        return None
    steps: list[Step] = [(w.replace(str(e), str(meaning)), s.xreplace({e: plainer(meaning)})) for w, s in curve.steps]
    return replace(curve, steps=tuple(steps))
