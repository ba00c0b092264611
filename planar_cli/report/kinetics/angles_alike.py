"""Bodies whose angles are one coordinate but for the sign: α_BC = -α_AB, as ω_BC = -ω_AB at all times; and why a body
turns the other way than the coordinate: r_C/B = [l cos θ, -l sin θ], so that BC is inclined at θ the other way.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, simplified
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.scene import Rod
from planar_cli.report.document.blocks import Block, Name, Paragraph, line
from planar_cli.report.equations.numeric import DIFFERENTIATED
from planar_cli.report.equations.results import numbered
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.written import Written


def alike_told(
    w: Written, stages: Sequence[Stage], system: System, phrases: Phrases, number: Callable[[Stage, int], int]
) -> list[Block]:
    """Why two angular accelerations are alike, where the angles that the file gives say so of the velocities; empty:
    they do not. `number`: the printed number of an equation of a stage.
    """
    if w.source == DIFFERENTIATED:
        return _the_other_way(w, system, phrases)
    speeds = {a: v for v, a in system.rates().items()}
    pair = by_name(w.residual.free_symbols & speeds.keys())
    if w.source != "closure" or len(pair) != 2:
        return []
    one, other = pair
    slopes = [w.residual.diff(a) for a in pair]
    sign = simplified(-slopes[0] / slopes[1]) if slopes[1] != 0 else sp.S.Zero
    told = [_rate(speeds[a], stages, number) for a in (one, other)]
    if None in told or abs(sign) != 1 or w.residual.xreplace({one: sp.S.Zero, other: sp.S.Zero}) != 0:
        return []
    (first, before), (second, after) = (t for t in told if t is not None)
    if second != sign * first:
        return []
    own, its = (phrases.math(x) for x in (speeds[other], sign * speeds[one]))
    return [Paragraph(line(f"By {numbered(sorted({before, after}))}, ", own, " = ", its, " at all times, so that:"))]


def _the_other_way(w: Written, system: System, phrases: Phrases) -> list[Block]:
    """Why ω of a body is -θ̇, by two points of it whose places the file gives by θ; empty: it is another relation."""
    scene = system.scene
    body = next((b for b in scene.problem.bodies if w.lead == f"angle of {b.name}"), None)
    if body is None or not isinstance(body.shape, Rod) or body.shape.end is None:
        return []
    one, other = body.shape.start, body.shape.end
    if not {one, other} <= scene.formulas.keys():
        return []
    reach = scene.formulas[other] - scene.formulas[one]
    x, y = simplified(reach.x.value), simplified(reach.y.value)
    angles = [f.args[0] for f in sp.sympify(x).atoms(sp.cos)]
    if len(angles) != 1 or not angles[0].is_Symbol or simplified(y * sp.cos(angles[0]) + x * sp.sin(angles[0])) != 0:
        return []
    place = line(Name(f"r_{other}/{one}"), " = [", phrases.math(x), ", ", phrases.math(y), "]")
    turned = line(f", so that {body.name} is inclined at ", phrases.math(angles[0]), " the other way:")
    return [Paragraph(line(*place, *turned))]


def _rate(speed: sp.Symbol, stages: Sequence[Stage], number: Callable[[Stage, int], int]) -> tuple[sp.Expr, int] | None:
    """What an angular velocity is by the coordinate that gives the angle at all times, and the number of that line."""
    for stage in stages:
        written = {w.number: w for b in stage.blocks for w in b.equations}
        for x in (x for b in stage.blocks for x in b.lines if x.symbol == speed):
            own = [written[n] for n in x.equations if n in written]
            if len(own) == 1 and own[0].source == DIFFERENTIATED:
                return x.formula, number(stage, own[0].number)
    return None
