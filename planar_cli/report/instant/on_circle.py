"""A point that goes round a fixed axis, asked at a state: its speed r ω and its a_t = r α, a_n = r ω² come first, and
its components from these.

    a_Bx = -a_t sin θ - a_n cos θ = -0.1 sin 57.30° - 0.2667 cos 57.30° = -0.2282 m/s²
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from decimal import Decimal
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, Value, line
from planar_cli.report.notation.enough_figures import MOST, figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.solve.between.trace.trace import MotionTrace

if TYPE_CHECKING:
    from planar_cli.report.instant.telling import Telling

PARTS = {"t", "n"}
SAME = Decimal("1e-9")


def is_told_on_circle(q: Quantity, body: str, telling: Telling, motion: MotionTrace) -> bool:
    """Is it the velocity at a state of a point of a body on a fixed pin, or its acceleration beside a_t and a_n?"""
    edge = next((e for e in telling.system.tree.edges if e.body == body), None)
    if edge is None or edge.joining is None or edge.parent != GROUND or not edge.joining.only_turns:
        return False
    if not isinstance(q.at, str) or q.parts or motion.symbolic:
        return False
    if angle_of(telling.scene.point(q.things[0]) - edge.joining.point) is None:
        return False
    others = [r.find.found.what for r in motion.requests]
    same = [x for x in others if isinstance(x, Quantity) and (x.word, x.things, x.at) == (q.word, q.things, q.at)]
    return q.word == "v" or {x.parts[0].kind for x in same if len(x.parts) == 1} >= PARTS


def with_degrees(blocks: Sequence[Block], angle: sp.Symbol, degrees: Decimal, figures: int) -> list[Block]:
    """Blocks in which the line of an angle goes on to its degrees: θ_2 = ω t_2 = 0.6667 rad = 38.20°."""
    return [
        Equation((*b.sides, Value(degrees, "deg", figures)), b.number, b.lead, b.note)
        if isinstance(b, Equation) and b.sides[0] == Math(angle) and _is_in_radians(b)
        else b
        for b in blocks
    ]


def _is_in_radians(equation: Equation) -> bool:
    last = equation.sides[-1]
    return isinstance(last, Value) and last.unit == "rad"


def in_degrees(block: Block, angle: sp.Symbol, degrees: Decimal, figures: int) -> Block:
    """A line with the number of an angle in it, told in degrees: R cos θ_2 = 0.6 cos 38.20°."""
    if not isinstance(block, Equation):
        return block
    last = block.sides[-1]
    if not isinstance(last, Value):
        return block
    sides = [_turned(s, angle, degrees, last, figures) if isinstance(s, Math) else s for s in block.sides]
    return replace(block, sides=tuple(sides))


def _turned(side: Math, angle: sp.Symbol, degrees: Decimal, last: Value, figures: int) -> Math:
    """The numbers of a line with the angle in degrees, with so many figures that they make its value."""
    turned = next((s for s in side.values or () if s.name == f"{angle.name} turned"), None)
    # Another vector at the same angle may have been told before.
    if turned is None or side.values is None or side.values[turned].endswith("°"):
        return side
    others = {s: sp.Float(text, 20) for s, text in side.values.items() if not text.endswith("rad")}
    for n in range(figures, MOST):
        text = significant(degrees, n)
        got = side.expr.subs({**others, turned: sp.rad(sp.Float(text, 20))})
        if significant(Decimal(str(sp.N(got, 20))), last.figures) == significant(last.number, last.figures):
            return replace(side, values={**side.values, turned: f"{text}°"})
    return side


def by_direction(blocks: Sequence[Block], whole: Sequence[Decimal], figures: int) -> list[Block]:
    """The two components of a vector by its size and direction, which stand before them: 0.2 cos 128.2° = -0.1237 m/s.
    `whole`: the components, as they are shown.
    """
    x, y = whole
    way = Decimal(math.degrees(math.atan2(y, x)))
    numbers = [(x * x + y * y).sqrt(), way]
    size, angle = (sp.Symbol(f"{NUMBER}{k}", real=True) for k in ("size", "way"))
    found: list[Block] = []
    for block, wave, f in zip(blocks, (sp.cos, sp.sin), (math.cos, math.sin), strict=True):
        if not isinstance(block, Equation) or not isinstance(block.sides[-1], Value):
            return list(blocks)

        def worked(n: Sequence[Decimal], f: Callable[[float], float] = f) -> Decimal:
            return n[0] * Decimal(f(math.radians(n[1])))

        own = figures_of(numbers, worked, figures)
        texts = {size: significant(numbers[0], own), angle: f"{significant(way, own)}°"}
        found.append(replace(block, sides=(block.sides[0], Math(size * wave(angle), texts), block.sides[-1])))
    return found


def unit_vectors(angle: sp.Symbol, vector: str, names: Sequence[str], ends: tuple[str, str]) -> Paragraph:
    """Along and across the path, before the components of a vector: e_t = [-sin θ, cos θ] … a = a_t e_t + a_n e_n.
    `names`: of a_t and a_n; `ends`: the centre and the point.
    """
    sin, cos = Math(sp.sin(angle)), Math(sp.cos(angle))
    (center, point), (t, n) = ends, map(Name, names)
    return Paragraph(
        line(
            Name("e_t"), " = [-", sin, ", ", cos, f"] perpendicular to {center}{point} and ", Name("e_n"), " = [-", cos
        )
        + line(", -", sin, f"] from {point} to {center}: ", Name(vector), " = ", t, " ", Name("e_t"), " + ", n, " ")
        + line(Name("e_n"), ":")
    )


def components(
    names: Sequence[str],
    sizes: Sequence[Decimal],
    angle: sp.Symbol,
    theta: Decimal,
    whole: Sequence[Decimal],
    figures: int,
) -> list[tuple[Math, Math]] | None:
    """Formula and numbers of a_x and a_y, by a_t and a_n. `names`, `sizes`: of these; `theta`: the angle of the radius,
    in radians; `whole`: a_x and a_y; None: the point goes round clockwise, or they are others.
    """
    t, n = (sp.Symbol(name, positive=True) for name in names)
    sin, cos = sp.sin(angle), sp.cos(angle)
    formulas = [sp.Add(-t * sin, -n * cos, evaluate=False), sp.Add(t * cos, -n * sin, evaluate=False)]
    numbers = [*sizes, Decimal(math.degrees(theta))]

    def of(axis: int, x: Sequence[Decimal]) -> Decimal:
        s, c = (Decimal(f(math.radians(float(x[2])))) for f in (math.sin, math.cos))
        return -x[0] * s - x[1] * c if axis == 0 else x[0] * c - x[1] * s

    found = []
    for axis, formula in enumerate(formulas):
        if abs(of(axis, numbers) - whole[axis]) > SAME * max(map(abs, sizes)):
            return None
        own = figures_of(numbers, partial(of, axis), figures)
        texts = [significant(x, own) for x in numbers]
        values = {t: texts[0], n: texts[1], angle: f"{texts[2]}°"}
        found.append((Math(formula), Math(formula, values)))
    return found


def angle_of(arm: Vec) -> sp.Symbol | None:
    """θ of an arm R cos θ, R sin θ."""
    found = sp.sympify(arm.x).atoms(sp.cos)
    if len(found) != 1:
        return None
    (wave,) = found
    angle = wave.args[0]
    same = simplified(arm.x * sp.sin(angle) - arm.y * sp.cos(angle)) == 0
    # An arm of -R cos θ, -R sin θ points the other way.
    outward = simplified(arm.x * sp.cos(angle) + arm.y * sp.sin(angle))
    return angle if angle.is_Symbol and same and not outward.could_extract_minus_sign() else None
