"""A point that goes round a fixed axis, asked at a state: its speed r ω and its a_t = r α, a_n = r ω² come first, and
its components from these.

    a_Bx = -a_t sin θ - a_n cos θ = -0.1 sin 57.30° - 0.2667 cos 57.30° = -0.2282 m/s²
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from functools import partial
from typing import TYPE_CHECKING

import sympy as sp

from planar_cli.equation.plain import simplified
from planar_cli.problem.expression import Quantity
from planar_cli.problem.geometry import Vec
from planar_cli.problem.scene import GROUND
from planar_cli.report.blocks import Block, Equation, Math, Value
from planar_cli.report.enough_figures import figures_of
from planar_cli.report.numbers import significant
from planar_cli.solve.between.trace import MotionTrace

if TYPE_CHECKING:
    from planar_cli.report.telling import Telling

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
