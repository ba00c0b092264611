"""The angle of a place vector that counts its turns, from the angle with which the file writes it.

Where the vector is written with an angle that goes on:

(a cos φ - b sin φ, a sin φ + b cos φ)  has the angle  φ + atan2(b, a),   a and b constant, or b = 0 and a > 0
"""

from __future__ import annotations

from collections.abc import Callable, Set
from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.exact import PI
from planar_cli.problem.implied.written_directions import ORIGIN
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND

if TYPE_CHECKING:
    from planar_cli.equation.scene.scene import Scene

LONGEST = 60
"""Longer components are not looked through."""
ROUNDING = Decimal("1e-30")
"""An angle that is nearer to -180 deg than this [rad] is 180 deg."""


def counted_angle(scene: Scene, q: Quantity, v: Vec) -> sp.Expr | None:
    """The angle of the vector r(…) with its turns: where it is drawn as the file writes it, else between -180 and
    180 deg; None: only its components tell it.
    """
    origin = q.things[1] if len(q.things) == 2 and q.things[1] != GROUND else ORIGIN
    drawn = scene.written.angle(origin, q.things[0], Vec(scene.as_drawn(v.x), scene.as_drawn(v.y)))
    varying = {*scene.ledger.coordinates, scene.ledger.symbols["t"]}
    if scene.displacement is not None:
        varying |= {c.symbol for c in scene.displacement.coordinates}
    if scene.displacement is None or not (sp.sympify(v.x).free_symbols | sp.sympify(v.y).free_symbols) & varying:
        return drawn
    found = written_angle(v, varying, lambda along: scene.sign(along) > 0)
    return None if found is None else found + _whole_turns(scene, v, found, drawn)


def written_angle(v: Vec, varying: Set[sp.Symbol], positive: Callable[[sp.Expr], bool]) -> sp.Expr | None:
    """The angle of a vector by the angle with which it is written, up to whole turns; None: it is not written so."""
    if longer(v.x, LONGEST) or longer(v.y, LONGEST):
        return None
    angles = {a.args[0] for e in (v.x, v.y) for a in sp.sympify(e).atoms(sp.sin, sp.cos)}
    for phi in sorted(angles, key=sp.default_sort_key):
        if not phi.free_symbols & varying:
            continue
        c, s = sp.cos(phi), sp.sin(phi)
        along, across = simplified(v.x * c + v.y * s), simplified(v.y * c - v.x * s)
        if across == 0:
            return phi if positive(along) else phi + sp.pi
        if not (along.free_symbols | across.free_symbols) & varying:
            return phi + sp.atan2(across, along)
    return None


def _whole_turns(scene: Scene, v: Vec, angle: sp.Expr, drawn: sp.Expr | None) -> sp.Expr:
    """What is to be added so that the angle is the drawn one in the drawn position; None: that in (-180, 180] deg."""
    assert scene.displacement is not None
    value = scene.valuations[0]
    begun = {c.symbol: value.known(c.drawn) for c in scene.displacement.coordinates if c.drawn is not None}
    value = value.extended({s: number for s, number in begun.items() if number is not None})
    here, there = value.known(angle), value.known(sp.atan2(v.y, v.x) if drawn is None else drawn)
    if here is None or there is None:
        return sp.S.Zero
    if drawn is None and there + PI < ROUNDING:
        there += 2 * PI
    turns = (there - here) / (2 * PI)
    return 2 * sp.pi * int(turns.to_integral_value())
