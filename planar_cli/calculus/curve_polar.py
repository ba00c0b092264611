"""Curves that a rolling disk or a turning arm draws: cycloids, spirals, and others in polar coordinates r, θ.

θ counterclockwise from +x in radians; r may be negative where a formula makes it so.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.calculus.curve_conics import Plane, root_of
from planar_cli.calculus.curve_plain import plainer
from planar_cli.calculus.curve_waves import Waves, linear, without_tan
from planar_cli.calculus.curve_words import CURVE, Curve, Step
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import MANY, longer

HALF_ARCH = (0.02, 3.12)
"""Where the equation of a cycloid is tried: the angle from the lowest place, within half a turn."""


def _equal(left: Any, right: Any) -> sp.Eq:
    return sp.Eq(left, right, evaluate=False)


def trochoid(plane: Plane, waves: Waves, given_by: str) -> Curve | None:
    """A circle of radius b about a centre that advances by a per radian: cycloid (a = b), curtate (b < a), prolate.

    With the advance along an axis, y = y_0 - b cos v is solved for v and put into x = x_0 + a v - b sin v; that holds
    for half an arch, on which cos v has one inverse.
    """
    p, trial = plane.trial.parameter, plane.trial
    one, two = linear(waves.x), linear(waves.y)
    if one is None or two is None or any(e.has(p) for e in (*one[1:], *two[1:])):
        return None
    (k, a, b), (m, c, d) = one, two
    along = [_advance(e, waves.angle, p) for e in (k, m)]
    if along[0] is None or along[1] is None or not trial.zero(a * c + b * d):
        return None
    square = plainer(a**2 + b**2)
    if not trial.zero(square - c**2 - d**2) or trial.zero(square):
        return None
    radius = root_of(square)
    (start, east), (base, north) = along[0], along[1]
    steps: tuple[Step, ...] = (("", _equal(plane.x, plane.path[0])), ("", _equal(plane.y, plane.path[1])))
    kind = _kind(plane, plainer(east**2 + north**2), square)
    found: tuple[sp.Eq, tuple[Step, ...]] | None = None
    if trial.zero(north):
        found = _half_arch(plane, plane.x, plane.y, (start, east, a, b), (base, c, d), waves.angle)
    elif trial.zero(east):
        found = _half_arch(plane, plane.y, plane.x, (base, north, c, d), (start, a, b), waves.angle)
    if found is None:
        return Curve(kind, None, steps, radius=radius, given_by=given_by)
    return Curve(kind, found[0], steps + found[1], radius=radius, holds="on half an arch", given_by=given_by)


def involute(plane: Plane, waves: Waves, given_by: str) -> Curve | None:
    """The end of a cord that unwinds from a circle: dr/du is u + δ times a turning vector of constant length."""
    p, trial = plane.trial.parameter, plane.trial
    one, two = linear(waves.x), linear(waves.y)
    if one is None or two is None or one[0].has(p) or two[0].has(p):
        return None
    rows = [_advance(e, waves.angle, p) for e in (*one[1:], *two[1:])]
    if any(row is None for row in rows):
        return None
    (a, da), (b, db), (c, dc), (d, dd) = (row for row in rows if row is not None)
    # The velocity is (A' + B) cos u + (B' - A) sin u with A = (a, c) and B = (b, d), each linear in u.
    constants, rates = (da + b, dc + d, db - a, dd - c), (db, dd, -da, -dc)
    if all(trial.zero(e) for e in rates):
        return None
    parallel = all(trial.zero(constants[i] * rates[j] - constants[j] * rates[i]) for i in range(4) for j in range(i))
    turning = trial.zero(da**2 + dc**2 - db**2 - dd**2) and trial.zero(da * db + dc * dd)
    if not parallel or not turning:
        return None
    steps: tuple[Step, ...] = (("", _equal(plane.x, plane.path[0])), ("", _equal(plane.y, plane.path[1])))
    return Curve("involute of a circle", None, steps, given_by=given_by)


def wheel_on_wheel(plane: Plane) -> str | None:
    """The name of a sum of two turning vectors of constant length: a point of a wheel that rolls on or in another one.

    It is an epi- or hypocycloid, a point of the rim, if both vectors have the same speed at their tips, else an epi- or
    hypotrochoid; epi- if both turn the same way.
    """
    p, trial = plane.trial.parameter, plane.trial
    x, y = (expanded(e) for e in plane.path)
    angles = sorted({f.args[0] for f in (x + y).atoms(sp.sin, sp.cos) if f.has(p)}, key=str)
    if len(angles) != 2:
        return None
    turns: list[tuple[int, sp.Expr]] = []
    for u in angles:
        (a, b), (c, d) = ((e.coeff(sp.cos(u)), e.coeff(sp.sin(u))) for e in (x, y))
        x, y = (expanded(e - m * sp.cos(u) - n * sp.sin(u)) for e, m, n in ((x, a, b), (y, c, d)))
        rate = sp.diff(u, p)
        sense = trial.sign((a * d - b * c) * rate) if not any(e.has(p) for e in (a, b, c, d, rate)) else None
        if not sense or not trial.zero(a**2 + b**2 - c**2 - d**2) or not trial.zero(a * b + c * d):
            return None
        turns.append((sense, (a**2 + c**2) * rate**2))
    if x.has(p) or y.has(p):
        return None
    shape = "cycloid" if trial.zero(turns[0][1] - turns[1][1]) else "trochoid"
    return ("epi" if turns[0][0] == turns[1][0] else "hypo") + shape


def lissajous(plane: Plane) -> str | None:
    """The name of two oscillations along the axes, each of one frequency."""
    p = plane.trial.parameter
    for e in plane.path:
        whole = expanded(e)
        angles = {f.args[0] for f in whole.atoms(sp.sin, sp.cos) if f.has(p)}
        if len(angles) != 1 or sp.diff(next(iter(angles)), p).has(p):
            return None
        u = next(iter(angles))
        sizes = whole.coeff(sp.cos(u)), whole.coeff(sp.sin(u))
        rest = expanded(whole - sizes[0] * sp.cos(u) - sizes[1] * sp.sin(u))
        if any(part.has(p) for part in (*sizes, rest)):
            return None
    return "Lissajous figure"


def _advance(expr: sp.Expr, angle: sp.Expr, p: sp.Symbol) -> tuple[sp.Expr, sp.Expr] | None:
    """(k, a) of k + a u; None where it does not advance with the angle u."""
    if not expr.has(p):
        return expr, sp.S.Zero
    rate = plainer(sp.diff(expr, p) / sp.diff(angle, p))
    if rate.has(p):
        return None
    rest = plainer(expanded(expr - rate * angle))
    return None if rest.has(p) else (rest, rate)


def _kind(plane: Plane, advance: sp.Expr, radius: sp.Expr) -> str:
    """By the squares of the advance per radian and of the radius."""
    sign = plane.trial.sign(radius - advance)
    return "trochoid" if sign is None else {0: "cycloid", 1: "prolate cycloid", -1: "curtate cycloid"}[sign]


def _half_arch(
    plane: Plane, x: sp.Symbol, y: sp.Symbol, along: tuple[sp.Expr, ...], across: tuple[sp.Expr, ...], angle: sp.Expr
) -> tuple[sp.Eq, tuple[Step, ...]] | None:
    """The equation on half an arch, and how it was found; x is the axis of the advance."""
    start, rate, a, b = along
    base, c, d = across
    if c == 0:
        swing, turned = d, -sp.pi / 2
        sine, shown = -a, sp.sin(angle)
    elif d == 0:
        swing, turned = c, sp.S.Zero
        sine, shown = b, sp.cos(angle)
    else:
        return None
    # y = base + swing cos v and x = start + rate (v - turned) + sine sin v, with v = angle + turned.
    v = sp.Dummy("v", positive=True)
    cosine = plainer((y - base) / swing)
    size = sp.sqrt(plainer(sine**2))
    root = sp.sqrt(expanded(plainer(size**2) - plainer(sine**2 / swing**2) * expanded((y - base) ** 2)))
    direction = plane.trial.sign(sine)
    if direction is None:
        return None
    equation = _equal(x, plainer(start - rate * turned) + rate * sp.acos(cosine) + direction * root)
    places = {x: start + rate * (v - turned) + sine * sp.sin(v), y: base + swing * sp.cos(v)}
    if not plane.trial.true(equation.lhs - equation.rhs, places, v, HALF_ARCH):
        return None
    return equation, ((f"from {y}", _equal(shown, cosine)), (f"in {x}, on half an arch", equation))


def polar(plane: Plane, names: tuple[str, str]) -> Curve | None:
    """x = r cos θ and y = r sin θ with r and θ known along the path: the polar equation r = f(θ), and its name."""
    p, (x, y) = plane.trial.parameter, plane.path
    inside = {f.args[0] for f in without_tan(x + y, p).atoms(sp.sin, sp.cos) if f.has(p)}
    arguments = sorted(inside, key=lambda a: (sp.count_ops(a), sp.default_sort_key(a)))
    turned = [sense * angle + quarter * sp.pi / 2 for angle in arguments for sense in (1, -1) for quarter in range(4)]
    for angle in (*arguments, *turned):
        ahead = angle in arguments or plane.trial.sign(x * sp.cos(angle) + y * sp.sin(angle)) == 1
        if ahead and plane.trial.true(x * sp.sin(angle) - y * sp.cos(angle), {}):
            found = _around(plane, angle, names)
            if found is not None:
                return found
    return None


def _around(plane: Plane, angle: sp.Expr, names: tuple[str, str]) -> Curve | None:
    p, (x, y) = plane.trial.parameter, plane.path
    distance = plainer(x / sp.cos(angle))
    if distance.has(sp.cos(angle)) or longer(distance, MANY):
        other = plainer(expanded(x * sp.cos(angle)) + expanded(y * sp.sin(angle)))
        distance = min(distance, other, key=operations)
    used = {s.name for s in plane.trial.free}
    r, theta = (_free(name, used) for name in names)
    unnamed = sp.Dummy("theta", real=True)
    inverse = inverted(angle, p, unnamed)
    if inverse is None:
        return None
    right = sp.powdenest(sp.expand_power_base(plainer(distance.xreplace({p: inverse[0]}))))
    if right.has(p):
        return None
    if not plane.trial.true(r - right, {r: distance, unnamed: angle}, p, inverse[1]):
        return None
    named = {unnamed: theta}
    equation = _equal(r, right.xreplace(named))
    steps: tuple[Step, ...] = (("direction", _equal(theta, angle)), ("distance from the origin", _equal(r, distance)))
    if p == angle:
        steps = (("distance from the origin", equation),)
    else:
        steps += (("", _equal(p, inverse[0].xreplace(named))), (f"without {p}", equation))
    return Curve(_spiral(right, unnamed), equation, steps, holds=inverse[2])


def _free(name: str, used: set[str]) -> sp.Symbol:
    """The symbol of a polar coordinate, with another name where the file's own letters have taken it."""
    others = {"r": ("r", "R", "varrho"), "theta": ("theta", "phi", "vartheta")}.get(name, (name,))
    return sp.Symbol(next((n for n in others if n not in used), f"{name}_P"), real=True)


def inverted(expr: sp.Expr, p: sp.Symbol, to: sp.Expr) -> tuple[sp.Expr, tuple[float, float], str] | None:
    """p from expr = to, where expr is k + a p^n or k + a exp(b p); for which values of p, in numbers and in words."""
    constant, moving = expanded(expr).as_independent(p, as_Add=True)
    size, shape = moving.as_independent(p, as_Add=False)
    everywhere = (-2.7, 2.7)
    left = plainer((to - constant) / size)
    if shape == p:
        return left, everywhere, ""
    if shape.is_Pow and shape.base == p and not shape.exp.has(p):
        return left ** (1 / shape.exp), (0.0, 2.7), f"for {p} ≥ 0"
    if isinstance(shape, sp.exp):
        start, rate = expanded(shape.args[0]).as_independent(p, as_Add=True)
        rate = rate / p
        if not rate.has(p):
            return plainer((sp.log(left) - start) / rate), everywhere, ""
    return None


def _spiral(right: sp.Expr, theta: sp.Symbol) -> str:
    """The name of r = f(θ)."""
    constant, moving = expanded(right).as_independent(theta, as_Add=True)
    shape = moving.as_independent(theta, as_Add=False)[1]
    if shape == theta:
        return "Archimedean spiral"
    if isinstance(shape, sp.exp) and constant == 0:
        return "logarithmic spiral"
    if constant == 0 and shape == 1 / theta:
        return "hyperbolic spiral"
    if constant == 0 and shape == sp.sqrt(theta):
        return "Fermat's spiral"
    if isinstance(shape, sp.sin | sp.cos) and constant == 0:
        return "rose" if shape.args[0].diff(theta).is_number else CURVE
    if isinstance(shape, sp.sin | sp.cos) and shape.args[0].diff(theta) == 1:
        ratio = plainer(sp.Abs(constant / moving.as_independent(theta, as_Add=False)[0]))
        return "cardioid" if ratio == 1 else "limaçon"
    return CURVE
