"""Directions told by the angle of a body, `theta(rod) + 90 deg`: they turn with it."""

from __future__ import annotations

from planar_cli.problem.language.expression import Binary, Negate, Quantity, Side
from planar_cli.problem.language.outermost import quantities_in
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.setting import Setting


def heading(scene: Setting, angle: Side) -> Vec:
    """The unit vector in a direction that may be told so."""
    found = off_body(angle)
    if found is None:
        return scene.unit(angle)
    body, rest = found
    along = scene.direction(body)
    if rest is None:
        return along
    turn = scene.unit(rest)
    turned: Vec = along * turn.x + along.turned() * turn.y
    return turned


def off_body(angle: Side) -> tuple[str, Side | None] | None:
    """The body whose angle is counted from, and what is added to it (None: nothing); None: it is told otherwise."""
    added: tuple[tuple[Side, Side], ...]
    match angle:
        case Quantity(word="theta", things=(str(body),), at=None):
            return body, None
        case Binary("+", left, right, _):
            added = ((left, right), (right, left))
        case Binary("-", left, right, mark):
            added = ((left, Negate(right, mark)),)
        case _:
            return None
    for own, rest in added:
        found = off_body(own)
        if found is not None and found[1] is None and not quantities_in(rest):
            return found[0], rest
    return None
