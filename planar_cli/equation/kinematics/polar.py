"""Statements about the size or the direction of a vector as equations between its components."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.values.jets import Jet, magnitude
from planar_cli.problem.language.expression import Part, Side
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.polar import VectorStatement, vector_behind

Read = Callable[[Side], Any]


def vector_equations(statement: VectorStatement, read: Read) -> tuple[Jet | Vec, sp.Expr | None]:
    """A Jet, or a Vec of jets, that vanishes; and an expression that must not be negative. `read`: a side as a Jet
    or a Vec of jets.
    """
    v: Vec = read(statement.vector)
    size, angle = statement.size, statement.angle
    other = vector_behind(angle, "angle") if angle is not None else None
    if size is not None and angle is not None:
        m, u = read(size), _unit(read(angle)) if other is None else _along(read(other))
        return v - u * m, _told(m.value)
    if size is not None:
        m = read(size)
        if m.value == 0 and m.rate == 0:
            return v, None
        return v.dot(v) - m * m, _told(m.value)
    assert angle is not None
    u = read(other) if other is not None else _unit(read(angle))
    return v.x * u.y - v.y * u.x, v.x.value * u.x.value + v.y.value * u.y.value


def tells_turns(statement: VectorStatement, read: Read) -> bool:
    """Does a statement about the direction of a place alone tell its turns as well, as it is written with an angle?"""
    v = read(statement.vector)
    if statement.vector.word != "r" or statement.size is not None or (v.x.value == 0 and v.y.value == 0):
        return False
    parts = (*statement.vector.parts, Part("angle", None, statement.vector.mark))
    return not read(replace(statement.vector, parts=parts)).value.has(sp.atan2)


def _unit(angle: Jet) -> Vec:
    return Vec(angle.through(sp.cos), angle.through(sp.sin))


def _along(w: Vec) -> Vec:
    """The unit vector of another one: no arctangent, which jumps where it turns about."""
    return w * magnitude(w).power(sp.Integer(-1))


def _told(size: sp.Expr) -> sp.Expr | None:
    """A size that a number already tells needs no test, unless it is negative."""
    return None if size.is_nonnegative and not size.free_symbols else size


def dotted(residual: Jet, times: int) -> sp.Expr:
    """A residual differentiated. ValueError: one instant does not tell that rate."""
    for _ in range(times):
        residual = residual.dotted()
    return residual.value
