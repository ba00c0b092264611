"""Curves known by points only: line, circle or other conic through them, to twenty digits; else just a curve.

Five points determine the coefficients of A x² + B x y + C y² + D x + E y + F = 0; all further points must agree.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.calculus.curve_conics import Plane, conic
from planar_cli.calculus.curve_trial import Trial
from planar_cli.calculus.curve_words import CURVE, LINE, POINT, Curve
from planar_cli.equation.values.exact import ONE, PI, ZERO, Valuation

CLOSE = Decimal("1e-20")
LEAST = 12
DISTINCT = 8
"""Fewer different places than this decide nothing."""
SIMPLE = 10**6
"""Denominators up to this are taken for a fraction as somebody wrote it."""
KEPT = 25
"""Significant digits of a coefficient that is no simple number."""

Point = tuple[Decimal, Decimal]


def numeric(points: Sequence[Point], axes: tuple[str, str]) -> Curve:
    """The curve through points that are exact to far more than twenty digits."""
    if len(points) < LEAST:
        raise ValueError(f"a curve is told from {LEAST} points or more, not from {len(points)}")
    middle = (sum((p[0] for p in points), ZERO) / len(points), sum((p[1] for p in points), ZERO) / len(points))
    size = max(max(abs(p[0] - middle[0]), abs(p[1] - middle[1])) for p in points)
    whole = max(size, abs(middle[0]), abs(middle[1]))
    if size <= CLOSE * whole or size == 0:
        return Curve(POINT, centre=(written(points[0][0]), written(points[0][1])))
    scaled = [((p[0] - middle[0]) / size, (p[1] - middle[1]) / size) for p in points]
    if len(_distinct(scaled)) < DISTINCT:
        return Curve(CURVE)
    found = _null([[x, y, ONE] for x, y in scaled]) or _null([[x * x, x * y, y * y, x, y, ONE] for x, y in scaled])
    if found is None:
        return Curve(CURVE)
    terms = [ZERO, ZERO, ZERO, *found] if len(found) == 3 else found
    return _curve(_unscaled(terms, middle, size), axes, points)


def _distinct(points: list[Point]) -> list[Point]:
    found: list[Point] = []
    for p in points:
        if all(max(abs(p[0] - q[0]), abs(p[1] - q[1])) > CLOSE for q in found):
            found.append(p)
    return found


def _null(rows: list[list[Decimal]]) -> list[Decimal] | None:
    """The one vector that all rows are perpendicular to, by elimination with full pivoting; None if none or several."""
    rows = [list(r) for r in rows]
    columns = list(range(len(rows[0])))
    for k in range(len(columns)):
        i, j = max(
            ((i, j) for i in range(k, len(rows)) for j in range(k, len(columns))),
            key=lambda ij: abs(rows[ij[0]][ij[1]]),
        )
        if abs(rows[i][j]) <= CLOSE:
            return _back(rows, columns) if k == len(columns) - 1 else None
        rows[k], rows[i] = rows[i], rows[k]
        columns[k], columns[j] = columns[j], columns[k]
        for row in rows:
            row[k], row[j] = row[j], row[k]
        for row in rows[k + 1 :]:
            factor = row[k] / rows[k][k]
            for c in range(k, len(columns)):
                row[c] -= factor * rows[k][c]
    return None


def _back(rows: list[list[Decimal]], columns: list[int]) -> list[Decimal]:
    """The null vector of an upper triangle that lacks its last pivot."""
    last = len(columns) - 1
    solution = [ZERO] * last + [ONE]
    for k in range(last - 1, -1, -1):
        solution[k] = -sum((rows[k][c] * solution[c] for c in range(k + 1, last + 1)), ZERO) / rows[k][k]
    by_column = dict(zip(columns, solution, strict=True))
    return [by_column[c] for c in range(last + 1)]


def _unscaled(terms: list[Decimal], middle: Point, size: Decimal) -> list[Decimal]:
    """Coefficients for the points as they were, put about the middle and measured by the size before."""
    a, b, c, d, e, f = terms
    x, y = middle
    d, e, f = d * size, e * size, f * size**2
    return [
        a, b, c,
        d - 2 * a * x - b * y,
        e - 2 * c * y - b * x,
        f + a * x * x + b * x * y + c * y * y - d * x - e * y,
    ]  # fmt: skip


def _curve(terms: list[Decimal], axes: tuple[str, str], points: Sequence[Point]) -> Curve:
    """The equation with its coefficients written plainly, and its kind."""
    x, y = (sp.Symbol(name, real=True) for name in axes)
    reach = max(max(abs(p[0]), abs(p[1])) for p in points)
    sizes = [abs(t) * reach**n for t, n in zip(terms, (2, 2, 2, 1, 1, 0), strict=True)]
    kept = [ZERO if s <= CLOSE * max(sizes) else t for t, s in zip(terms, sizes, strict=True)]
    lead = _lead(kept)
    letters = [written(t / lead) for t in kept]
    plane = Plane(x, y, (sp.S.Zero, sp.S.Zero), Trial([], sp.Dummy("p"), Valuation({})))
    powers = (x**2, x * y, y**2, x, y, sp.S.One)
    found = conic(plane, sp.Add(*(k * m for k, m in zip(letters, powers, strict=True))))
    if found is None or found.equation is None:
        return Curve(CURVE)
    residual = found.equation.lhs - found.equation.rhs
    if not all(_near(residual, {x: p[0], y: p[1]}) for p in points):
        return Curve(CURVE)
    words = "straight line" if found.kind == LINE else "conic"
    return Curve(
        found.kind,
        found.equation,
        ((f"all {len(points)} points lie on one {words}", found.equation),),
        found.centre,
        found.radius,
    )


def _lead(terms: list[Decimal]) -> Decimal:
    """What the coefficients are measured by: the square of larger weight, or the slope of a line."""
    squares = max((terms[0], terms[2]), key=abs)
    if squares:
        return terms[0] if terms[0] == terms[2] else squares
    return terms[1] or terms[4] or terms[3]


def _near(residual: sp.Expr, place: dict[sp.Symbol, Decimal]) -> bool:
    value = Valuation(place)
    return abs(value(residual)) <= CLOSE * max(value.size(residual), ONE * CLOSE)


def written(value: Decimal) -> sp.Expr:
    """A number as a fraction, a root of one, or a fraction of π if it is so simple; else rounded to 25 digits."""
    for power, factor in ((1, sp.S.One), (2, sp.S.One), (1, sp.pi), (1, sp.pi**2)):
        target = value / (PI if factor == sp.pi else PI**2 if factor == sp.pi**2 else ONE)
        fraction = _fraction(target**power, SIMPLE if factor == 1 and power == 1 else 1000)
        if fraction is not None:
            root: Any = fraction if power == 1 else sp.sqrt(fraction) * (1 if value > 0 else -1)
            return root * factor
    return sp.Rational(f"{value:.{KEPT - 1}e}")


def _fraction(value: Decimal, most: int) -> sp.Rational | None:
    """The continued fraction of a number, if it ends early."""
    if not value:
        return sp.S.Zero
    exact = sp.Rational(str(value))
    near = exact.limit_denominator(most)
    return near if abs(exact - near) <= sp.Rational(str(CLOSE)) * abs(exact) else None
