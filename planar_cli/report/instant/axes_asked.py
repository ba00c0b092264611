"""Which component of a vector is asked, and that beside its line."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Text, Value, line
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.words.counted import as_vector
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.units import ACCELERATION, VELOCITY, Dimension

LONGEST = 40
"""A sum of components of more operations is not written."""


def axis_of(what: Any) -> str:
    """x or y, where one component is asked; else nothing."""
    kind = what.parts[0].kind if isinstance(what, Quantity) and len(what.parts) == 1 else ""
    return kind if kind in ("x", "y") else ""


def dimension_of(q: Quantity) -> Dimension:
    """That of a velocity or an acceleration."""
    return VELOCITY if q.word == "v" else ACCELERATION


def rational(number: Decimal) -> sp.Rational:
    return sp.Rational(str(number))


def without_vector(told: Sequence[Block]) -> list[Block]:
    """The last of some vector equations without its components in letters: the one that is asked follows."""
    last = told[-1] if told else None
    if not isinstance(last, Equation) or len(last.sides) < 3:
        return list(told)
    return [*told[:-1], replace(last, sides=last.sides[:-1])] if is_vector(last.sides[-1]) else list(told)


def is_vector(side: Inline | Line) -> bool:
    """Is it [x, y] in letters?"""
    if not isinstance(side, tuple) or len(side) < 2:
        return False
    return side[0] == Text("[") and not any(isinstance(p, Value) for p in side)


def noted(blocks: Iterable[Block], axis: str, aside: Line = ()) -> Iterator[Block]:
    """Lines of one component, the axis beside them, and what there is to say of it."""
    for block in blocks:
        yield replace(block, note=line(f"along {axis}", *aside)) if axis and isinstance(block, Equation) else block


def without(what: Any, system: System, zero: Collection[sp.Symbol], phrases: Phrases) -> Line:
    """`, where α_arm does not enter`: angular accelerations in the vector equations of a point, on which the component
    that is asked does not rest. `zero`: those that the equations do without.
    """
    axis, motion = axis_of(what), system.motion
    vector = system.quantities().any(replace(what, parts=())) if axis and what.word == "a" else None
    if motion is None or not isinstance(vector, Vec):
        return ()
    parts = {name: sp.sympify(p.value) for name, p in (("x", vector.x), ("y", vector.y))}
    inside = parts["x"].free_symbols | parts["y"].free_symbols
    spins = (as_vector(sp.sympify(twist.angular), system) for twist in motion.accelerations.values())
    turning = dict.fromkeys(s for s in spins if s in inside)
    names = [phrases.math(s) for s in turning if s not in zero and simplified(sp.diff(parts[axis], s)) == 0]
    listed = [piece for i, name in enumerate(names) for piece in ((", " if i < len(names) - 1 else " and ", name))]
    return line(", where ", *listed[1:], " do not enter" if len(names) > 1 else " does not enter") if names else ()


def along_radius(answer: Found, quantities: Quantities, phrases: Phrases) -> Line:
    """The component along the radius to a point or across it, by those along x and y where these are letters:
    a_r = a_x cos θ + a_y sin θ.
    """
    what = answer.find.found.what if answer.find is not None else None
    if not isinstance(what, Quantity) or what.word not in ("v", "a") or not len(what.parts) == len(what.things) == 1:
        return ()
    vector = quantities.any(replace(what, parts=()))
    if what.parts[0].kind not in ("r", "theta") or not isinstance(vector, Vec):
        return ()
    place, parts = quantities.place(what.things[0]), [sp.sympify(p.value) for p in (vector.x, vector.y)]
    radius = Vec(place.x.value, place.y.value)
    size, way = simplified(sp.sqrt(radius.dot(radius))), radius if what.parts[0].kind == "r" else radius.turned()
    told = sp.Add(*(simplified(w / size) * p for w, p in zip((way.x, way.y), parts, strict=True)))
    return line(phrases.math(told)) if all(p.is_Symbol for p in parts) and not longer(told, LONGEST) else ()


def unit_asked(q: Quantity, quantities: Quantities, phrases: Phrases) -> list[Decimal]:
    """The unit vector along which a component is taken; of those by the radius it goes from the point beside, or from
    the origin, and across it counterclockwise.
    """
    part = q.parts[-1]
    if part.kind in ("x", "y"):
        return [Decimal(part.kind == "x"), Decimal(part.kind == "y")]
    if part.kind in ("r", "theta"):
        own, *others = (quantities.place(thing) for thing in q.things)
        reach = own - others[0] if others else own
    else:
        reach = quantities.direction(part)
    axis = Vec(reach.x.value, reach.y.value)
    axis = axis if part.kind in ("r", "along") else axis.turned()
    x, y = (phrases.certain(p) for p in (axis.x, axis.y))
    size = (x * x + y * y).sqrt() or Decimal(1)
    return [x / size, y / size]


def part_along(
    name: str,
    own: Sequence[Line],
    vector: tuple[Value, ...],
    axis: Sequence[Decimal],
    kind: str,
    values: Any,
    p: Phrases,
) -> Iterator[Block]:
    """The component of a vector along an axis, by the numbers of both. `own`: the name of the answer, where that is
    another than the one of the vector.
    """
    counted = [*(v.number for v in vector), *axis]
    figures = figures_of(counted, lambda x: x[0] * x[2] + x[1] * x[3], p.figures)
    symbols = [sp.Symbol(f"{NUMBER}{i}", real=True) for i in ("0", "1", "cos0", "cos1")]
    texts, names = {s: significant(x, figures) for s, x in zip(symbols, counted, strict=True)}, symbols[:2]
    cosines = [s for s in texts if s not in names]
    told = {"x": "along x", "y": "along y"}.get(kind, p.arrow(*map(rational, axis)))
    if not own and 0 in [v.number for v in vector] and any(abs(c) == 1 for c in axis):
        # The vector that stands before has no other part.
        return
    sides: list[Any] = [*own] or [line(Name(name), f" {told}")]
    if all(abs(c) not in (0, 1) for c in axis):
        pairs = zip(cosines, names, vector, strict=True)
        parts = [sp.Mul(c, n, evaluate=False) for c, n, v in pairs if v.number]
        sides.append(Math(parts[0] if len(parts) == 1 else sp.Add(*parts, evaluate=False), texts))
    note = line("the component of ", Name(name), f" {told}") if own else ()
    yield Equation((*sides, *values), None, note=note)
