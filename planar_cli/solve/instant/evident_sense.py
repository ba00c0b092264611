"""Accelerations counted the way in which a mass centre is known to go: downward where a rod that is let go swings down.

Which way the one body of a scene begins to turn is told by its loads; its mass centre goes the same way about the point
that holds it. An acceleration that the file asks for counts as it is asked. What goes one way through a whole motion
counts that way all the time.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.geometry import Vec


def in_its_sense(
    system: System, body: str, part: tuple[Vec, sp.Expr], called: Callable[[str, sp.Expr, str], sp.Expr]
) -> tuple[Vec, sp.Expr]:
    """An axis and what the component along it is called, both turned round where the body goes against the axis."""
    axis, component = part
    builder = system.builder
    known = body in builder.going or (body in builder.known_senses and not _is_asked(system, body))
    if known and not component.is_Add and component.could_extract_minus_sign():
        return -axis, called(body, -component, "")
    return axis, called(body, component, "")


def with_the_motion(
    system: System, axis: Vec, bodies: tuple[str, ...], acceleration: Callable[[str], list[tuple[Vec, sp.Expr]]]
) -> Vec:
    """The axis along which the forces on bodies are summed, turned round where the acceleration of all that moves is
    counted against it.
    """
    ways = [way for b in bodies if system.scene.bodies[b].mass != 0 for way, _ in acceleration(b)]
    if system.builder.going or system.builder.oblique:
        ways = [way for way in ways if way.dot(axis) != 0]
    return -axis if ways and all(way == -axis for way in ways) else axis


def as_told(one: sp.Expr, other: sp.Expr) -> tuple[list[sp.Expr], sp.Expr]:
    """Two terms that make nought together, as the sides of an equation: a letter is left of what it is, a_B = R α."""
    one_is_letter = one.is_Symbol or (-one).is_Symbol
    return ([other], -one) if other.is_Symbol and not one_is_letter else ([one], -other)


def apart(residual: sp.Expr, unknowns: set[sp.Symbol]) -> tuple[list[sp.Expr], sp.Expr]:
    """What holds unknowns on the left, the rest on the right, where none of them enters linearly."""
    parts = sp.Add.make_args(residual)
    left = [p for p in parts if p.free_symbols & unknowns]
    sense = -1 if left and all(p.could_extract_minus_sign() for p in left) else 1
    return [sense * p for p in left], -sense * sp.Add(*(p for p in parts if not p.free_symbols & unknowns))


def as_counted(left: list[sp.Expr], right: sp.Expr, known: bool, system: System) -> tuple[list[sp.Expr], sp.Expr]:
    """Both sides, turned round where the left one is a rotation counterclockwise of a body that counts clockwise, or
    what is given with a value `known` against the way in which its letter counts: a_B = 1.2 m/s² downward.
    """
    if len(left) != 1:
        return left, right
    against = known and (-left[0]).is_Symbol and right.could_extract_minus_sign()
    turns = any(e.turn < 0 and -left[0] in (e.spin, e.spin_rate) for e in system.tree.edges)
    return ([-left[0]], -right) if against or turns else (left, right)


def _is_asked(system: System, body: str) -> bool:
    """Is the acceleration of a body, or of its mass centre, asked?"""
    sides = [f.found.what for f in system.scene.problem.find]
    own = {(body,), (system.scene.center_name(body),)}
    return any(
        isinstance(node, Quantity) and node.word == "a" and node.things in own for side in sides for node in walk(side)
    )
