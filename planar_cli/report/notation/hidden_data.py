"""Does a formula in the letters of the file hold whatever the file gives, or for numbers of it that stand in it unseen?

t_2 = M/q is true for 3 m/s and 1.5 m/s alone, where the file gives these two without letters: of two numbers of one
dimension only their ratio is left in a formula, and of 45° its sine. Of one length among no others nothing can be left
over that has no unit, so that the formula must be without it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy as sp

from planar_cli.problem.language.expression import Name, Number, Relation, Scaled
from planar_cli.problem.scene.scene import At, Particle, Problem
from planar_cli.solve.solution import Found
from planar_cli.units import PURE, Dimension, parse_unit

PLAIN = 4
"""A number without unit and with a denominator up to this one is part of what the file says: half of the speed."""
RIGHT = 90
TELLING = ("surfaces", "bodies", "joints", "loads", "motion", "instant", "states")
"""What a file says of a problem beside its letters. Of its places only directions count, the rest is drawn."""
NAMED = {"mass", "mu", "mu_s", "mu_k", "restitution"}
"""Numbers of bodies and joints that get a letter of their own."""
_Datum = tuple[Fraction, Dimension]


def hides_data(problem: Problem, answer: Found, closed: sp.Expr) -> bool:
    """May numbers that the file gives without a letter stand in a formula of its letters, where no one sees them?"""
    letters = {s.name for s in closed.free_symbols}
    data = {d for name in TELLING for d in _data(getattr(problem, name), letters)}
    data |= set(_data(answer.find.found.what, letters)) if answer.find is not None else set()
    data |= {d for point in problem.points for d in _data(point.place, letters) if d[1] == PURE}
    angles = {size for size, dimension in data if dimension == PURE}
    seen = {a for a in closed.atoms(sp.sin, sp.cos, sp.tan) if not a.free_symbols}
    held = [dimension for _, dimension in data if dimension != PURE]
    return len(angles) > len(seen) or _independent(held) < len(held) or any(_oblique(problem))


def _data(node: Any, letters: set[str]) -> Iterator[_Datum]:
    """Numbers below a node, by size and dimension; none that is zero, a right angle, or what a letter is equal to."""
    if isinstance(node, tuple):
        for entry in node:
            yield from _data(entry, letters)
    elif isinstance(node, Number):
        yield from _datum(node.value, node.unit)
    elif isinstance(node, Scaled):
        yield from _datum(Fraction(1), node.unit)
        yield from _data(node.operand, letters)
    elif is_dataclass(node) and not isinstance(node, type):
        if isinstance(node, Relation) and isinstance(node.left, Name) and node.left.name in letters:
            return
        told = (f.name for f in fields(node) if f.name not in NAMED)
        # A place is drawn, but for its angles.
        found = (d for name in told for d in _data(getattr(node, name), letters))
        yield from ((d for d in found if d[1] == PURE) if isinstance(node, At) else found)


def _datum(value: Fraction, unit: str | None) -> Iterator[_Datum]:
    if value == 0 or (unit is None and value.denominator <= PLAIN):
        return
    if unit is None:
        yield abs(value), PURE
        return
    told = parse_unit(unit)
    if not (unit == "deg" and value % RIGHT == 0):
        yield abs(value) * told.factor, told.dimension


def _independent(dimensions: list[Dimension]) -> int:
    """How many of several dimensions no product of the others makes."""
    rows = [[d.length, d.mass, d.time] for d in dimensions]
    return int(sp.Matrix(rows).rank()) if rows else 0


def _oblique(problem: Problem) -> Iterator[bool]:
    """For two places in numbers that something joins: is the line between them oblique, with a slope in numbers?"""
    places = {p.name: p.place for p in problem.points}
    for body in problem.bodies:
        if isinstance(body.shape, Particle) and body.shape.place is not None:
            own = body.shape.place
            places[body.name] = own if isinstance(own, At) else places[own]
    entries: tuple[Any, ...] = (*problem.joints, *problem.loads, *(b.shape for b in problem.bodies))
    # What runs along a direction that the file tells does not run from place to place.
    for entry in (e for e in entries if getattr(e, "along", None) is None):
        ends = [p for n in _words(entry) if isinstance(p := places.get(n), At)]
        for one, other in combinations(ends, 2):
            sides = [_difference(one.x, other.x), _difference(one.y, other.y)]
            yield all(sides)


def _words(node: Any) -> Iterator[str]:
    if isinstance(node, str):
        yield node
    elif isinstance(node, tuple):
        for entry in node:
            yield from _words(entry)
    elif is_dataclass(node) and not isinstance(node, type):
        for f in fields(node):
            yield from _words(getattr(node, f.name))


def _difference(one: Any, other: Any) -> Fraction | None:
    """Of two numbers in one unit; None: they are none."""
    if isinstance(one, Number) and isinstance(other, Number):
        return one.value - other.value
    return None
