"""One coordinate q(t), speed v = dq/dt: what a law of motion says of two instants.

The relations are those of An Introduction to Planar Dynamics, 1.3.1: dq = v dt (1.19), dv = a dt (1.20) and
v dv = a dq (1.25), integrated over matching domains from the start (t0, q0, v0) to the end (t, q, v): 1.21 to 1.28.
q may be a length, an angle (circular motion, 1.3.2) or an arc length (1.4.2); v and a are signed along growing q.
SI units or any other consistent ones.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.calculus.antiderivative import definite
from planar_cli.calculus.autonomous import Separated, separated
from planar_cli.calculus.deciding import confirmed, sign, vanishes
from planar_cli.calculus.forcing import particular
from planar_cli.calculus.linear_in_speed import linear_in_speed
from planar_cli.calculus.linear_laws import linear
from planar_cli.calculus.spans import Moment, Span, bound, integral, span
from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.plain import derivative, parts_of, simplified
from planar_cli.equation.values.exact import Valuation

__all__ = ["BY_FACTOR", "Moment", "Span", "relations"]

BY_FACTOR = "v dv = a dq, linear in v², with its integrating factor"
"""The words of a relation for which a law is first multiplied by a factor."""


def relations(
    order: int, f: sp.Expr, start: Moment, end: Moment, valuation: Valuation | None = None, lean: bool = False
) -> tuple[Span, ...]:
    """The relations between start and end that a law gives; none: it must be integrated step by step. `lean`: no time
    by the place where the place is known over time.

    order 0: q = f(t); order 1: v = f(t, q); order 2: a = f(t, q, v), with the letters of `end` in f. The valuation
    tells signs of parameters and the direction of motion (from start.v) where the letters' assumptions do not.
    """
    law = sp.sympify(f)
    if order == 0:
        return _given_place(law, end)
    if order == 1:
        return _given_speed(law, start, end, valuation)
    return _given_acceleration(law, start, end, valuation, lean)


def _given_place(f: sp.Expr, end: Moment) -> tuple[Span, ...]:
    """q = f(t)."""
    rate = derivative(f, end.t)
    if f.has(end.q, end.v) or rate.has(sp.Derivative):
        return ()
    return (
        span("q(t)", "the law itself", end.q - f, None, f),
        span("v(t)", "v = dq/dt", end.v - rate, None, rate),
    )


def _given_speed(f: sp.Expr, start: Moment, end: Moment, value: Valuation | None) -> tuple[Span, ...]:
    """v = f(t, q): dq = v dt, or separated dq/v = dt."""
    if f.has(end.v):
        return ()
    own = span("v(q)" if f.has(end.q) else "v(t)", "the law itself", end.v - f, None, f)
    if not f.has(end.q):
        change = _over_time(f, start, end, value)
        sides = integral(1, start.q, end.q), integral(f, start.t, end.t)
        return own, span("q(t)", "dq = v dt", end.q - start.q - change, sides, start.q + change)
    if not f.has(end.t):
        return own, *_separated_place(f, start, end, value)
    slope = derivative(f, end.q)
    if slope.has(end.t, end.q):
        return ()
    formula = _forced(simplified(slope), expanded(f - slope * end.q), (start.t, start.q), (end.t, end.q), value)
    if formula is None:
        return ()
    return own, span("q(t)", "linear: the root of λ + c = 0 and a particular solution", end.q - formula, None, formula)


def _separated_place(f: sp.Expr, start: Moment, end: Moment, value: Valuation | None) -> tuple[Span, ...]:
    """v = f(q)."""
    tau = bound(end.t)
    known = separated(f, end.q, start.q, tau, value)
    where = _at(known.where, tau, start, end)
    sides = integral(1 / f, start.q, end.q), integral(1, start.t, end.t)
    elapsed = sides[0] if known.elapsed is None else known.elapsed
    found = [span("t(q)", "dq/v = dt", end.t - start.t - elapsed, sides, start.t + elapsed, _of(where, end.q))]
    if known.state is not None:
        formula = known.state.xreplace({tau: end.t - start.t})
        found.append(span("q(t)", "dq/v = dt, solved for q", end.q - formula, sides, formula, where))
    return tuple(found)


def _at(where: tuple[sp.Expr, ...], tau: sp.Symbol, start: Moment, end: Moment) -> tuple[sp.Expr, ...]:
    return tuple(w.xreplace({tau: end.t - start.t}) for w in where)


def _of(where: tuple[sp.Expr, ...], letter: sp.Symbol) -> tuple[sp.Expr, ...]:
    """The bounds that are about one letter alone."""
    return tuple(w for w in where if w.has(letter))


def _forced(
    slope: sp.Expr,
    forcing: sp.Expr,
    start: tuple[sp.Symbol, sp.Symbol],
    end: tuple[sp.Symbol, sp.Symbol],
    value: Valuation | None,
) -> sp.Expr | None:
    """y by x for dy/dx = slope y + forcing(x); start and end are (x, y)."""
    (x0, y0), (x, _) = start, end
    yp = particular((-slope, sp.S.One), forcing, x, value, base=x - x0)
    if yp is None or not confirmed(sp.Add(derivative(yp, x), -slope * yp, -forcing), value, (x0, x)):
        return None
    return yp + (y0 - yp.xreplace({x: x0})) * sp.exp(slope * (x - x0))


def _over_time(f: sp.Expr, start: Moment, end: Moment, value: Valuation | None) -> sp.Expr:
    """∫ f dt from start to end: closed, or as it stands."""
    return _done(integral(f, start.t, end.t), value)


def _given_acceleration(
    f: sp.Expr, start: Moment, end: Moment, value: Valuation | None, lean: bool
) -> tuple[Span, ...]:
    """a = f(t, q, v): the class of the law decides. What nobody would read through is of no class that has a name."""
    if wide(f):
        return ()
    directed = _directed(f, start, end, value)
    if directed is None:
        return () if f.has(end.t) else _at_rest(start, end)
    law, where = directed
    by_time, by_place, by_speed = (law.has(letter) for letter in (end.t, end.q, end.v))
    if not (by_place or by_speed):
        return _by_time(law, start, end, value, where) if by_time else _constant(law, start, end, where)
    if by_speed and not (by_time or by_place):
        return _by_speed(law, start, end, value, where)
    found: tuple[Span, ...] = ()
    stiffness, damping = -derivative(law, end.q), -derivative(law, end.v)
    if not stiffness.has(end.t, end.q, end.v) and not damping.has(end.t, end.q, end.v):
        w2, c = simplified(stiffness), simplified(damping)
        rest = simplified(expanded(law + w2 * end.q + c * end.v))
        found = linear(w2, c, rest, start, end, value, where)
    if by_place and not by_time:
        timed = not lean or not any(s.kind == "q(t)" for s in found)
        found += _by_place(law, start, end, value, where, timed)
    if by_speed and by_time and not by_place and not found:
        found = linear_in_speed(law, start, end, value, where)
    return found or _product(law, start, end, value, where)


def _directed(
    f: sp.Expr, start: Moment, end: Moment, value: Valuation | None
) -> tuple[sp.Expr, tuple[sp.Expr, ...]] | None:
    """|v| and sign v by the direction in which the motion goes or starts; the law then holds while ±v ≥ 0.

    Without a known direction the law stays as it is; None: at rest, and it starts in neither direction.
    """
    v = end.v
    if not any(isinstance(a, sp.Abs | sp.sign) and a.has(v) for a in parts_of([f])):
        return f, ()
    forward = sp.Dummy("v", positive=True)
    ways = {d: f.xreplace({v: d * forward}).xreplace({forward: d * v}) for d in (1, -1)}
    direction = sign(start.v, value)
    if direction == 0:
        signs = {d: sign(way.subs({v: 0, end.q: start.q, end.t: start.t}), value) for d, way in ways.items()}
        if None in signs.values():
            return f, ()
        direction = next((d for d, own in signs.items() if own == d), None)
        if direction is None:
            return None
    if direction is None or any(a.has(v) for a in ways[direction].atoms(sp.Abs, sp.sign)):
        return f, ()
    return ways[direction], (direction * v,)


def _at_rest(start: Moment, end: Moment) -> tuple[Span, ...]:
    """Dry friction holds it, or nothing drives it."""
    words = "at rest: it would start in neither direction"
    return (
        span("v(t)", words, end.v - start.v, None, start.v),
        span("q(t)", words, end.q - start.q, None, start.q),
    )


def _constant(a: sp.Expr, start: Moment, end: Moment, where: tuple[sp.Expr, ...]) -> tuple[Span, ...]:
    """1.23, 1.24 and 1.28; only two of them are independent."""
    tau, v = end.t - start.t, end.v
    speed = start.v + a * tau
    place = start.q + start.v * tau + a * tau**2 / 2
    in_time = integral(1, start.v, v), integral(a, start.t, end.t)
    along = integral(1, start.q, end.q), integral(speed, start.t, end.t)
    energy = integral(v, start.v, v), integral(a, start.q, end.q)
    return (
        span("v(t)", "dv = a dt", v - speed, in_time, speed, where),
        span("q(t)", "dq = v dt", end.q - place, along, place, where),
        span("v(q)", "v dv = a dq", v**2 - start.v**2 - 2 * a * (end.q - start.q), energy, None, where),
    )


def _by_time(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """a = f(t): dv = a dt, dq = v dt. Without a closed form the double integral becomes ∫ (t - t') a(t') dt'."""
    gain = _over_time(a, start, end, value)
    speed = start.v + gain
    x = bound(end.t)
    if gain.has(sp.Integral):
        change = start.v * (end.t - start.t) + sp.Integral((end.t - x) * a.xreplace({end.t: x}), (x, start.t, end.t))
        sides = None
    else:
        still, moving = gain.as_independent(end.t, as_Add=True)
        change = (start.v + still) * (end.t - start.t) + _over_time(moving, start, end, value)
        sides = integral(1, start.q, end.q), integral(speed, start.t, end.t)
    in_time = integral(1, start.v, end.v), integral(a, start.t, end.t)
    return (
        span("v(t)", "dv = a dt", end.v - speed, in_time, speed, where),
        span("q(t)", "dq = v dt", end.q - start.q - change, sides, start.q + change, where),
    )


def _by_speed(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """a = f(v): dv/a = dt and v dv/a = dq, and the motion in time where v(t) can be had."""
    tau = bound(end.t)
    known = separated(a, end.v, start.v, tau, value)
    limits = (*where, *_at(known.where, tau, start, end))
    own = _of(limits, end.v)
    for_time = integral(1 / a, start.v, end.v), integral(1, start.t, end.t)
    for_place = integral(end.v / a, start.v, end.v), integral(1, start.q, end.q)
    elapsed = for_time[0] if known.elapsed is None else known.elapsed
    travelled = for_place[0] if known.travelled is None else known.travelled
    found = [span("t(v)", "dv/a = dt", end.t - start.t - elapsed, for_time, start.t + elapsed, own)]
    found += _in_time(known, tau, start, end, for_time, limits)
    found.append(span("q(v)", "v dv/a = dq", end.q - start.q - travelled, for_place, start.q + travelled, own))
    return (*found, *_squared(a, start, end, value, own))


def _in_time(
    known: Separated,
    tau: sp.Symbol,
    start: Moment,
    end: Moment,
    sides: tuple[sp.Expr, sp.Expr],
    where: tuple[sp.Expr, ...],
) -> list[Span]:
    """v(t), and q(t) from dq = v dt."""
    if known.state is None:
        return []
    passed = end.t - start.t
    speed = known.state.xreplace({tau: passed})
    found = [span("v(t)", "dv/a = dt, solved for v", end.v - speed, sides, speed, where)]
    if known.summed is not None:
        place = start.q + known.summed.xreplace({tau: passed})
        along = integral(1, start.q, end.q), integral(speed, start.t, end.t)
        found.append(span("q(t)", "dq = v dt", end.q - place, along, place, where))
    return found


def _by_place(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...], timed: bool
) -> tuple[Span, ...]:
    """a = f(q), or f(q) + c v²: v by q, and (if `timed`) the time by quadrature, once for each direction of motion."""
    if a.has(end.v):
        return _squared(a, start, end, value, where)
    sides = integral(end.v, start.v, end.v), integral(a, start.q, end.q)
    work = _done(sides[1], value)
    square = start.v**2 + 2 * work
    found = [span("v(q)", "v dv = a dq", end.v**2 - square, sides, None, where)]
    if timed and not work.has(sp.Integral):
        found += _durations(square, start, end, value)
    return tuple(found)


def _durations(square: sp.Expr, start: Moment, end: Moment, value: Valuation | None) -> list[Span]:
    """t(q) for v > 0 and for v < 0: t - t0 = ∫ dq/v with v = ±sqrt(v²(q)); closed if v² is of second degree in q."""
    found = []
    closed = _arc(square, start, end, value)
    for direction, name in ((1, "v > 0"), (-1, "v < 0")):
        pace = integral(direction / sp.sqrt(square), start.q, end.q)
        sides = integral(1, start.t, end.t), pace
        passed = pace if closed is None else direction * closed
        residual = end.t - start.t - passed
        found.append(span("t(q)", f"dt = dq/v, {name}", residual, sides, start.t + passed, (direction * end.v,)))
    return found


def _arc(square: sp.Expr, start: Moment, end: Moment, value: Valuation | None) -> sp.Expr | None:
    """∫ dq/sqrt(v²(q)) for a v² of second degree: an arcsine or a logarithm."""
    x = bound(end.q)
    own = expanded(square)
    if not own.is_polynomial(end.q) or sp.degree(own, end.q) != 2:
        return None
    first = sp.Dummy("first", positive=True)
    constant = own.subs(end.q, 0)
    inside = (own - constant).xreplace({end.q: x}) + first
    closed = definite(1 / sp.sqrt(inside), x, start.q, end.q, value)
    return None if closed is None else closed.xreplace({first: constant})


def _squared(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """a = g(q) + c(q) v²: v dv = a dq is linear in v², d(v²)/dq = 2 g + 2 c v²."""
    square = sp.Dummy("v2")
    flat = expanded(a).xreplace({end.v**2: square})
    c = derivative(flat, square)
    if flat.has(end.v, end.t) or c.has(square) or vanishes(c):
        return ()
    rest = expanded(flat - c * square)
    if c.has(end.q):
        return _with_factor(c, rest, start, end, value, where)
    formula = _forced(2 * c, 2 * rest, (start.q, start.v**2), (end.q, square), value)
    if formula is None:
        return ()
    if rest.has(end.q):
        return (span("v(q)", "v dv = a dq, linear in v²", end.v**2 - formula, None, None, where),)
    sides = integral(end.v / a, start.v, end.v), integral(1, start.q, end.q)
    return (span("v(q)", "v dv/a = dq, solved for v²", end.v**2 - formula, sides, None, where),)


def _with_factor(
    c: sp.Expr, rest: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """v by q with the integrating factor μ = exp(-∫ 2 c dq), for which d(μ v²)/dq = 2 μ g."""
    x = bound(end.q)
    power = definite(2 * c.xreplace({end.q: x}), x, start.q, end.q, value)
    if power is None:
        return ()
    factor = simplified(sp.exp(-power))
    gained = _done(integral(2 * simplified(factor * rest), start.q, end.q), value)
    square = (start.v**2 + gained) / factor
    return (span("v(q)", BY_FACTOR, end.v**2 - square, None, None, where),)


def _product(
    a: sp.Expr, start: Moment, end: Moment, value: Valuation | None, where: tuple[sp.Expr, ...]
) -> tuple[Span, ...]:
    """a = g(q) h(v) or g(t) h(v): separated, v dv/h = g dq or dv/h = g dt."""
    other, speed = factor_terms(a).as_independent(end.v, as_Add=False)
    letters = [(y0, y) for y0, y in ((start.q, end.q), (start.t, end.t)) if other.has(y)]
    if len(letters) != 1 or speed.has(end.q, end.t) or speed == 1:
        return ()
    y0, y = letters[0]
    by_place = y == end.q
    left = simplified(end.v / speed) if by_place else 1 / speed
    sides = integral(left, start.v, end.v), integral(other, y0, y)
    residual = sp.Add(*(s * _done(i, value) for s, i in zip((1, -1), sides, strict=True)))
    kind, words = ("v(q)", "v dv/a = dq, separated") if by_place else ("v(t)", "dv/a = dt, separated")
    return (span(kind, words, residual, sides, None, where),)


def _done(own: sp.Integral, value: Valuation | None) -> sp.Expr:
    """An integral closed where that can be done."""
    x, a, b = own.limits[0]
    closed = definite(own.function, x, a, b, value)
    return own if closed is None else closed
