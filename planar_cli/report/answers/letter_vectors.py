"""A vector in letters read: its size, and where it points.

a_P = [r ω² sin φ, r ω² cos φ], that is r ω² along the unit vector [sin φ, cos φ], from P to G
r_B/A = [1/2 (√3 - 1) r, -1/2 (1 + √3) r], that is √2 r at 75.0° below +x
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, longer, simplified
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Line, Name, Value, line
from planar_cli.report.notation.numbers import vector_words
from planar_cli.report.words.swallowed import swallowed
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import Found
from planar_cli.solve.solved_problem import PartSolution

OF_ANGLES = 3
"""Figures of a direction, as the answer has them."""
SHORT = 8
"""A size, or a component of a unit vector, of more operations says nothing at sight."""


def letter_vector_words(found: Found, part: PartSolution, phrases: Phrases) -> Line:
    """What stands behind the components; empty where the size is no product, or one component is zero."""
    what = found.find.found.what if found.find is not None else None
    if found.kind != "vector" or found.values is not None or len(found.expressions or ()) != 2:
        return ()
    if not isinstance(what, Quantity) or what.parts or not _has_direction(what) or not part.instants:
        return ()
    parts = _size_and_unit(found)
    if parts is None:
        return ()
    size, unit = parts
    head = line(", that is ", swallowed(size, found, phrases.ledger, phrases.figures) or phrases.math(size))
    if unit.x.is_number and unit.y.is_number:
        words = vector_words(phrases.certain(unit.x), phrases.certain(unit.y)) if size.is_positive else ""
        return line(*head, f" {words}") if words else ()
    along = line(" along the unit vector [", phrases.math(unit.x), ", ", phrases.math(unit.y), "]")
    scene = part.instants[-1].instant.scene
    towards = next(_ends(what.things[0], unit, scene), "") if part.motion is None else ""
    return line(*head, *along, f", {towards}" if towards else "")


def _size_and_unit(found: Found) -> tuple[sp.Expr, Vec] | None:
    """The size of a vector in letters and its unit vector; None: the size is no product, or one component is zero."""
    x, y = found.expressions or ()
    if x == 0 or y == 0:
        return None
    size = simplified(sp.sqrt(simplified(x**2 + y**2)))
    if size.has(sp.Abs) or any(p.base.is_Add for p in size.atoms(sp.Pow) if not p.exp.is_Integer):
        return None
    unit = Vec(simplified(x / size), simplified(y / size))
    return None if size.is_number or any(longer(e, SHORT) for e in (size, unit.x, unit.y)) else (size, unit)


def letter_size_and_angle(found: Found, phrases: Phrases) -> Iterator[Block]:
    """√(x² + y²), and arctan(y/x) where that has a number; nothing of a vector along an axis, or of another size."""
    what = found.find.found.what if found.find is not None else None
    plain = found.kind == "vector" and found.values is None and len(found.expressions or ()) == 2
    if not plain or not isinstance(what, Quantity) or what.parts or not _has_direction(what):
        return
    parts = _size_and_unit(found)
    if parts is None or not parts[0].is_positive:
        return
    (x, y), name = found.expressions or (), Name(found.name)
    if not (parts[1].x.is_number and parts[1].y.is_number):
        size = sp.sqrt(sp.Add(x**2, y**2, evaluate=False), evaluate=False)
        pythagoras = line("since sin² + cos² = 1") if size.has(sp.sin) and size.has(sp.cos) else ()
        yield Equation((line("|", name, "|"), phrases.math(size), phrases.math(parts[0])), None, (), pythagoras)
        return
    cosine, sine = (phrases.certain(p) for p in (parts[1].x, parts[1].y))
    root = sp.sqrt(sp.Add(x**2, y**2, evaluate=False), evaluate=False)
    held = swallowed(parts[0], found, phrases.ledger, phrases.figures)
    sides = (held,) if held is not None else (phrases.math(root), phrases.math(parts[0]))
    yield Equation((line("|", name, "|"), *sides))
    angle = Value(Decimal(math.degrees(math.atan(abs(sine) / abs(cosine)))), "deg", OF_ANGLES)
    slope = simplified(abs(y / x))
    where = f"{'above' if sine > 0 else 'below'} {'+x' if cosine > 0 else '-x'}"
    turned = (line("direction of ", name), line("arctan(", phrases.math(slope), ")"), angle)
    yield Equation(turned, None, note=line(where))


def _has_direction(q: Quantity) -> bool:
    """Is it a velocity, an acceleration or a place relative to a point?"""
    return q.word in ("v", "a") or (q.word == "r" and len(q.things) == 2 and q.things[1] != GROUND)


def _ends(point: str, unit: Vec, scene: Scene) -> Iterator[str]:
    """Between which points a vector at one of them lies."""
    if point not in scene.points:
        return
    for other in scene.points:
        if other == point:
            continue
        arm = scene.point(other) - scene.point(point)
        along = simplified(arm.x * unit.x + arm.y * unit.y)
        if identically_zero(arm.x * unit.y - arm.y * unit.x) and (along.is_positive or along.is_negative):
            yield f"from {point} to {other}" if along.is_positive else f"from {other} to {point}"
