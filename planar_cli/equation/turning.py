"""The angle of a place vector that counts its turns, where the vector is written with an angle that goes on.

(a cos φ - b sin φ, a sin φ + b cos φ)  has the angle  φ + atan2(b, a),   a and b constant, or b = 0 and a > 0
"""

from __future__ import annotations

from collections.abc import Callable, Set
from decimal import Decimal
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.exact import PI
from planar_cli.equation.plain import longer, simplified
from planar_cli.problem.geometry import Vec

if TYPE_CHECKING:
    from planar_cli.equation.scene import Scene

LONGEST = 60
"""Longer components are not looked through."""
ROUNDING = Decimal("1e-30")
"""An angle that is nearer to -180 deg than this [rad] is 180 deg."""


def counted_angle(scene: Scene, v: Vec) -> sp.Expr | None:
    """The angle of a vector with its turns, between -180 and 180 deg where it is drawn; None: it is not written so."""
    if scene.displacement is None:
        return None
    ledger = scene.ledger
    varying = {c.symbol for c in scene.displacement.coordinates} | {*ledger.coordinates, ledger.symbols["t"]}
    found = written_angle(v, varying, lambda along: scene.sign(along) > 0)
    return None if found is None else found + _whole_turns(scene, v, found)


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


def _whole_turns(scene: Scene, v: Vec, angle: sp.Expr) -> sp.Expr:
    """What is to be added so that the angle lies in (-180, 180] deg in the drawn position."""
    assert scene.displacement is not None
    value = scene.valuations[0]
    begun = {c.symbol: value.known(c.drawn) for c in scene.displacement.coordinates if c.drawn is not None}
    value = value.extended({s: number for s, number in begun.items() if number is not None})
    here, there = value.known(angle), value.known(sp.atan2(v.y, v.x))
    if here is None or there is None:
        return sp.S.Zero
    if there + PI < ROUNDING:
        there += 2 * PI
    turns = (there - here) / (2 * PI)
    return 2 * sp.pi * int(turns.to_integral_value())
