"""Bodies that the places of a state hold apart do not strike each other in it.

A motion that led there fixes the places, and so does what the state says of them, or a drawing of two bodies that have
a size. Only a particle stands for a body of any size: drawn alone, it may be drawn beside what it strikes.
"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import derivative
from planar_cli.equation.scene.meeting import partner_of
from planar_cli.equation.scene.nearness import distance
from planar_cli.equation.values.exact import Valuation
from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.joints.base import Joint
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.diagnosis.words import in_unit
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.units import LENGTH, default_unit

TOUCHES = 1e-4
"""A gap is one beyond this part of the largest length in sight: places of a file have some four digits."""
STEP = Decimal("1e-12")
ACROSS = 1e-6
"""What the places that are stated leave of the direction in which a gap grows, if they fix it."""


def demand_together(course: StatedMotion, i: int, here: Valuation, near: float) -> None:
    """NoSolution: bodies that are to strike each other between states i and i + 1 are apart in state i, and it is more
    than a way of drawing. `here`: numbers of that state; `near`: a smaller gap is none, in m.
    """
    blow = course.blows[i]
    gaps = _gaps(blow, here, near)
    if not gaps or (len(gaps) < len(_impacts(blow)) and all(j.during is None for j, _ in gaps)):
        return
    us = course.ledger.us
    apart = default_unit(LENGTH, us=us)
    for joint, gap in gaps:
        if (joint.during is not None or not blow.otherwise) and _fixed(course, i, _between(joint), here):
            a, b = _between(joint)
            text = f"{a} and {b} do not touch in state {blow.since.name}: they are {in_unit(gap, apart, us)} apart"
            hint = "let a state before it lead there, or give the places in which they touch"
            if all(partner_of(blow.scene, name).particle for name in (a, b)):
                hint = f"particles have no size: let {a} and {b} meet at one place, or write `sphere:` with a radius"
            raise NoSolution([Diagnostic(blow.stop.mark, "PL529", text, hint)])


def _impacts(blow: Blow) -> list[Joint]:
    return [j for j in blow.struck.joints if j.strikes]


def _between(joint: Joint) -> tuple[str, ...]:
    found: tuple[str, ...] = getattr(joint, "between", ())
    return found


def _gaps(blow: Blow, here: Valuation, near: float) -> list[tuple[Joint, Decimal]]:
    """The impacts of a blow whose bodies are apart, and how far."""
    pairs = [(j, blow.scene.distance(j, here)) for j in _impacts(blow)]
    return [(j, gap) for j, gap in pairs if gap is not None and float(gap) > near]


def _fixed(course: StatedMotion, i: int, between: tuple[str, ...], here: Valuation) -> bool:
    """Do a motion, the state or the sizes of bodies tell how far apart these are in state i?"""
    blow = course.blows[i]
    if any(s.blow is None for s in course.modes.stretches[:i]):
        return True
    if not any(partner_of(blow.scene, name).particle for name in between):
        return True
    stop, scene = blow.since, blow.before.general.instant.scene
    names = {stop.letters[c.symbol]: c.symbol for c in blow.before.coordinates}
    now = here.extended({letter: here(own) for own, letter in names.items()})

    def gap(value: Valuation) -> Decimal:
        return distance(scene, between, value) or Decimal(0)

    natural = course.natural(names)
    rate = [(gap(now.extended({x: now(x) + STEP * natural[o]})) - gap(now)) / STEP for o, x in names.items()]
    stated = [d.residual for d in course.demands[stop.name] if d.kind == "equation"]
    stated = [r for r in stated if _of_places(r, names, here)]
    rows = [[float(here(derivative(r, own)) * natural[own]) for own in names] for r in stated]
    return _spans(rows, [float(r) for r in rate])


def _of_places(residual: sp.Expr, names: dict[sp.Symbol, sp.Symbol], here: Valuation) -> bool:
    """Does a relation speak of places, and is everything in it known?"""
    return here.known(residual) is not None and bool(residual.free_symbols & set(names))


def _spans(rows: Sequence[Sequence[float]], direction: Sequence[float]) -> bool:
    """Is a direction a combination of rows? (None of no rows, and a vanishing one of nothing.)"""
    size = sum(x * x for x in direction) ** 0.5
    basis: list[list[float]] = []
    for row in (*rows, direction):
        left, length = list(row), sum(x * x for x in row) ** 0.5
        for b in basis:
            part = sum(x * y for x, y in zip(left, b, strict=True))
            left = [x - part * y for x, y in zip(left, b, strict=True)]
        rest = sum(x * x for x in left) ** 0.5
        if row is direction:
            return bool(size > 0 and rest <= ACROSS * size)
        if rest > ACROSS * length:
            basis.append([x / rest for x in left])
    return False
