"""The line along which an unknown acts on a group of bodies: a reaction, or m a of known direction."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.solve.instant.numbers import Numbers


def line_of(system: System, numbers: Numbers, bodies: tuple[str, ...], symbol: sp.Symbol) -> tuple[Vec, Vec]:
    """Point and direction of the resultant of one unknown on a group: from its wrench about the origin."""
    fx = fy = m = sp.S.Zero
    simple: tuple[Vec, Vec] | None = None
    count = 0
    for push, expr in system.reactions.pushes if system.reactions else ():
        factor = numbers.form(expr).terms.get(symbol)
        if factor is None:
            continue
        for action in push.actions:
            if action.body in bodies and action.force is not None:
                force = action.force * factor
                fx, fy, m = fx + force.x, fy + force.y, m + action.point.cross(force) + factor * action.couple
                simple, count = (action.point, action.force), count + 1
    if count == 0:
        return _inertia_line(system, bodies, symbol, numbers)
    if count == 1 and simple is not None:
        return simple
    square = fx**2 + fy**2
    return Vec(fy * m / square, -fx * m / square), Vec(fx, fy)


def _inertia_line(system: System, bodies: tuple[str, ...], symbol: sp.Symbol, numbers: Numbers) -> tuple[Vec, Vec]:
    assert system.motion is not None
    for body in bodies:
        center = system.scene.center(body)
        a = system.motion.acceleration(center, body)
        direction = Vec(*(numbers.form(e).terms.get(symbol, sp.S.Zero) for e in (a.x, a.y)))
        if direction.x != 0 or direction.y != 0:
            return center, direction
    raise LookupError(symbol.name)
