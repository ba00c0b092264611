"""What comes back under a constant acceleration has the speed with which it left that place, in one line:

From 2 to 4 the ball comes back to the same height, with the same speed:   v_4 = -v_2
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Equation, Paragraph, line
from planar_cli.report.words.origins import is_steady
from planar_cli.solve.between.trace.trace import MotionTrace, Result, RouteStep

BY_SQUARES = "v(q)"
"""The kind of v² = v_0² + 2 a (q - q_0)."""
SAME = Decimal("1e-20")
"""Speeds are the same that differ by less, in relation to them."""


def back_blocks(
    leg: RouteStep, found: MotionTrace, number: int, chain: Callable[[Result, bool], tuple[Any, ...]]
) -> list[Block]:
    """The blocks of such a step; empty of another one, and of one that comes back with another speed across."""
    e, r = leg.relations[0], leg.results[0]
    if len(leg.relations) > 1 or e.kind != BY_SQUARES or e.law is None or not is_steady(e) or r.formula is None:
        return []
    what, of, thing = e.law.coordinate.words.partition(" of ")
    left = -r.formula.replace(sp.Abs, lambda x: x)
    if left not in found.general or not of or what not in ("x", "y"):
        return []
    before, after = (_speed(e.law.coordinate.body, e.since, state, found) for state in (e.since, e.stop))
    turned = abs(found.value(left) + r.value) <= SAME * abs(r.value)
    if not turned or before is None or after is None or abs(before - after) > SAME * before:
        return []
    place = "height" if what == "y" and found.problem.plane == "vertical" else "place"
    head = f"From {e.since} to {e.stop}, {with_article(thing)} comes back to the same {place}"
    return [Paragraph(line(f"{head}, with the same speed:")), Equation(chain(r, True), number)]


def _speed(body: str, since: str, state: str, found: MotionTrace) -> Decimal | None:
    """The square of the speed of the mass centre of a body at a state; None: it is not known. `since`: where its
    motion begins.
    """
    regime = next((r for r in found.regimes if any(start == since for start, _ in r.stretches)), None)
    motion = None if regime is None else regime.solution.trial.system.motion
    if regime is None or motion is None:
        return None
    there = {general: x for x, general in found.general.items() if found.ledger.roles[x].at == state}
    v = motion.velocity(regime.solution.instant.scene.bodies[body].center, body)
    return found.value.known(sp.sympify(v.dot(v)).xreplace(there))
