"""What comes back under a constant acceleration has the speed with which it left that place, in one line:

From 2 to 4 the ball comes back to the same height, with the same speed:   v_4 = -v_2
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from planar_cli.problem.scene import with_article
from planar_cli.report.blocks import Block, Equation, Paragraph, line
from planar_cli.report.origins import is_steady
from planar_cli.solve.between.trace import MotionTrace, Result, RouteStep

BY_SQUARES = "v(q)"
"""The kind of v² = v_0² + 2 a (q - q_0)."""
PLACES = {"x": "place", "y": "height"}


def back_blocks(
    leg: RouteStep, found: MotionTrace, number: int, chain: Callable[[Result, bool], tuple[Any, ...]]
) -> list[Block]:
    """The blocks of such a step; empty of another one."""
    e, r = leg.relations[0], leg.results[0]
    if len(leg.relations) > 1 or e.kind != BY_SQUARES or e.law is None or not is_steady(e) or r.formula is None:
        return []
    what, of, thing = e.law.coordinate.words.partition(" of ")
    left = -r.formula.replace(sp.Abs, lambda x: x)
    if left not in found.general or found.value(left) != -r.value or not of or what not in PLACES:
        return []
    head = f"From {e.since} to {e.stop}, {with_article(thing)} comes back to the same {PLACES[what]}"
    return [Paragraph(line(f"{head}, with the same speed:")), Equation(chain(r, True), number)]
