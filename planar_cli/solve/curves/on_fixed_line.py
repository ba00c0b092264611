"""Polar components of a point that moves along a fixed line: the acceleration across the line is zero, which tells a_r
from a_θ, so that r need not be differentiated twice.

v_r = ṙ,  v_θ = r θ̇
a_θ = r θ̈ + 2 v_r θ̇        a_y = a_r sin θ + a_θ cos θ = 0          a_r = -a_θ/tan θ   of a point that keeps its y
(An Introduction to Planar Dynamics, 1.4.3)
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.jets import Jet
from planar_cli.greek import GREEK
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.passages import RADIAL, Passage, Row
from planar_cli.units import LENGTH, TIME

Angle = tuple[sp.Symbol, sp.Symbol, sp.Symbol]
"""The letters of an angle and its rates."""


@record
class Guided:
    """A point that keeps x or y, as its polar coordinates tell it: the letters of the angle and its rates, the length
    and its rates, and `value`, of a formula in the coordinates.
    """

    point: str
    keeps: str
    size: Jet
    angle: Angle
    value: Callable[[sp.Expr], Decimal | None]

    def letter(self, name: str) -> sp.Symbol:
        """v_P_r and the like, and r_P."""
        kind, _, part = name.partition("_")
        return sp.Symbol(f"{kind}_{self.point}{'_' + part if part else ''}", real=True)


def guided(
    point: str, reach: Vec, size: Jet, angle: Angle, value: Callable[[sp.Expr], Decimal | None]
) -> Guided | None:
    """None: the point keeps neither x nor y. `angle`: the coordinate that it is, with the letters of its rates."""
    if value(size.value) is None:
        return None
    kept = [axis for axis, jet in (("x", reach.x), ("y", reach.y)) if jet.rate == 0 and jet.value != 0]
    return Guided(point, kept[0], size, angle, value) if len(kept) == 1 else None


def components(g: Guided, level: int, length: tuple[sp.Expr, ...]) -> Iterator[Passage]:
    """v_r and v_θ, and at level 2 a_θ and a_r. `length`: r by the coordinate that the point keeps, if it is told."""
    r, speed = g.letter("r"), g.letter("v_r")
    theta, omega, alpha = g.angle
    size = g.size
    assert size.rate is not None
    across, dimension = g.letter("v_theta"), LENGTH / TIME
    kept = sp.Symbol(f"{g.keeps}_{g.point}", real=True)
    turned = -r * omega / sp.tan(theta) if g.keeps == "y" else r * omega * sp.tan(theta)
    rate = sp.diff(length[0], theta) * omega if length else turned
    place = size.value * (sp.sin(theta) if g.keeps == "y" else sp.cos(theta))
    own = _numbers(
        g, {s: e for s, e in ((theta, theta), (omega, omega), (r, size.value), (kept, place)) if rate.has(s)}
    )
    letters = (speed, sp.Symbol(f"r_{g.point}_dot", real=True), rate)
    velocities = (
        Row("", letters, g.value(size.rate), dimension, False, own),
        Row(
            "",
            (across, r * omega),
            g.value(size.value * omega),
            dimension,
            False,
            _numbers(g, {r: size.value, omega: omega}),
        ),
    )
    yield Passage("Its velocity along r and across it:", velocities, RADIAL)
    if level == 2:
        assert size.second is not None
        told = {r: size.value, omega: omega, alpha: alpha, speed: size.rate}
        whole = size.value * alpha + 2 * size.rate * omega
        along = size.second - size.value * omega**2
        way = {"x": "vertically", "y": "horizontally"}[g.keeps]
        theta = GREEK.get(g.angle[0].name, g.angle[0].name)
        yield Passage(
            f"Along r is [cos {theta}, sin {theta}], across it [-sin {theta}, cos {theta}]; {g.point} moves {way}, so "
            f"that its acceleration has no {g.keeps} component, and r̈ need not be found:",
            tuple(_pair(g, "a", r * alpha + 2 * speed * omega, whole, along, told)),
            RADIAL,
        )


def _pair(
    g: Guided, kind: str, formula: sp.Expr, across: sp.Expr, along: sp.Expr, inside: dict[sp.Symbol, sp.Expr]
) -> Iterator[Row]:
    """The component across r by its formula, then that along r; `across`, `along`: both in the coordinates, `inside`:
    what the letters of `formula` are.
    """
    theta = g.angle[0]
    one, other = g.letter(f"{kind}_r"), g.letter(f"{kind}_theta")
    dimension = LENGTH / TIME ** (1 if kind == "v" else 2)
    yield Row("", (other, formula), g.value(across), dimension, False, _numbers(g, inside))
    if g.keeps == "y":
        kept, told = one * sp.sin(theta) + other * sp.cos(theta), -other / sp.tan(theta)
    else:
        kept, told = one * sp.cos(theta) - other * sp.sin(theta), other * sp.tan(theta)
    yield Row("", sp.Eq(kept, 0, evaluate=False), Decimal(0))
    yield Row("so that", (one, told), g.value(along), dimension, False, _numbers(g, {other: across, theta: theta}))


def _numbers(g: Guided, inside: dict[sp.Symbol, sp.Expr]) -> dict[sp.Symbol, Decimal]:
    found = {s: g.value(e) for s, e in inside.items()}
    return {s: number for s, number in found.items() if number is not None}
