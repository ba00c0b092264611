"""How far apart two partners of an impact are: rims, particles, edges, corners; do they meet as the file says?"""

from __future__ import annotations

import math
from decimal import Decimal
from itertools import product

from planar_cli.equation.scene.meeting import Partner, is_threaded, partner_of, partners_of
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.scene.geometry import Vec

ALIGNED = Decimal("1e-6")
"""Two directions are the same within this angle, in rad."""


def distance(scene: Scene, between: tuple[str, ...], value: Valuation, at: str = "") -> Decimal | None:
    """The distance in m with these numbers, as centres, radii, straight edges and corners tell it; None: unknown. `at`:
    the point with which the file says that they meet.
    """
    a, b = partners_of(scene, between, at)
    for one, other in ((a, b), (b, a)):
        if is_threaded(scene, one, other):
            return _from_ends(one, other, value)
    found = [d for one, other in ((a, b), (b, a)) for d in _from_edge(one, other, value)]
    if a.center is not None and b.center is not None:
        found.append(_between_rims(a, b, value))
    elif not found:
        found = [_long(p - q, value) for p, q in product(_corners(a), _corners(b))]
    return min(found, default=None)


def doubtful_corner(
    scene: Scene, between: tuple[str, ...], struck: Vec, value: Valuation, near: Decimal, at: str = ""
) -> str:
    """What is wrong with the corner that is taken to strike an edge: two come at once, or another does; "" if nothing.
    `near`: a smaller difference is none, in m. `at`: the corner that the file names.
    """
    a, b = partners_of(scene, between, at)
    for one, other in ((a, b), (b, a)):
        if one.center is not None or other.line is None or len(one.corners) < 2 or other.corners:
            continue
        found = sorted(_from_edge(one, other, value))
        start, along = other.line
        if found[1] - found[0] <= near:
            return f"two corners of {one.name} meet {other.name} at once"
        if abs(value((struck - start).cross(along))) - found[0] > near:
            return f"another corner of {one.name} meets {other.name} than in the drawing"
    return ""


def doubtful_place(struck: Vec, said: Vec, value: Valuation, near: Decimal) -> bool:
    """Is the point at which the file says that two bodies touch another than that where they do?"""
    return _long(said - struck, value) > near


def doubtful_normal(
    scene: Scene, between: tuple[str, ...], struck: Vec, said: Vec, value: Valuation, near: Decimal
) -> Decimal | None:
    """The common normal as the shapes tell it, in degrees from 0 to 180; None where the file says the same."""
    a, b = (partner_of(scene, name) for name in between)
    out = _radius_or_edge(a, b, struck, value, near)
    if out is None:
        return None
    length = _long(out, value)
    if length <= near or abs(value(out.cross(said))) <= ALIGNED * length:
        return None
    return Decimal(math.degrees(math.atan2(value(out.y), value(out.x)))) % 180


def _radius_or_edge(a: Partner, b: Partner, struck: Vec, value: Valuation, near: Decimal) -> Vec | None:
    """Along the normal: the radius of a rim, or across an edge that is not met at its end; None where it is open."""
    for one in (a, b):
        if one.center is not None and not one.particle:
            return struck - one.center
    for one in (a, b):
        if one.line is None:
            continue
        along = one.line[1]
        ends = [value((p - struck).dot(along)) for p in one.corners]
        if not ends or min(ends) < -near < near < max(ends):
            across: Vec = along.turned()
            return across
    return None


def _from_edge(one: Partner, other: Partner, value: Valuation) -> list[Decimal]:
    """Of a rim or of corners from a straight edge."""
    if other.line is None:
        return []
    start, along = other.line
    radius = value(one.radius) if one.radius is not None else Decimal(0)
    return [abs(abs(value((p - start).cross(along))) - radius) for p in _corners(one)]


def _from_ends(threaded: Partner, rod: Partner, value: Valuation) -> Decimal:
    """Of the rim of a body whose centre is on the line of a rod from the nearest of its ends, m."""
    assert threaded.center is not None
    radius = Decimal(0) if threaded.radius is None else value(threaded.radius)
    return min(abs(_long(p - threaded.center, value) - radius) for p in rod.corners)


def _corners(partner: Partner) -> tuple[Vec, ...]:
    return (partner.center,) if partner.center is not None else partner.corners


def _between_rims(a: Partner, b: Partner, value: Valuation) -> Decimal:
    """Of two rims, also of one inside the other."""
    assert a.center is not None
    assert b.center is not None
    far = _long(b.center - a.center, value)
    radii = [value(p.radius) if p.radius is not None else Decimal(0) for p in (a, b)]
    within = abs(far - abs(radii[0] - radii[1])) if all(radii) else abs(far - sum(radii))
    return min(abs(far - sum(radii)), within)


def _long(v: Vec, value: Valuation) -> Decimal:
    return value(v.dot(v)).sqrt()
