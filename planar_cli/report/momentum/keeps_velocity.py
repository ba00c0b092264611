"""A body on which no resultant force acts keeps its velocity, in one line for a balance of momenta:

From 2 to 3, no resultant force acts on A along x:   v_A,3 = v_A,2
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Equation, Paragraph, line
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace, Result, RouteStep

AXES = {"→": "x", "←": "x", "↑": "y", "↓": "y"}
STATE = "__"
"""Stands before the state in the name of a letter."""


def kept_blocks(
    leg: RouteStep, found: MotionTrace, number: int, chain: Callable[[Result, bool], tuple[Any, ...]]
) -> list[Block]:
    """The blocks of such a step; empty of another one."""
    b, r = leg.relations[0].source, leg.results[0]
    if len(leg.relations) > 1 or not isinstance(b, BalanceTrace) or b.law.letter or b.law.name or b.gain != 0:
        return []
    axis = AXES.get(b.law.lead.strip(), "")
    if len(b.law.bodies) != 1 or not axis or r.formula is None or not r.formula.is_Symbol:
        return []
    if r.unknown.name.partition(STATE)[0] != r.formula.name.partition(STATE)[0]:
        return []
    (body,) = b.law.bodies
    along = "" if _is_free(body, b, found) else f" along {axis}"
    head = f"From {b.since} to {b.stop}, no resultant force acts on {with_article(body)}{along}:"
    return [Paragraph(line(head)), Equation(chain(r, True), number)]


def _is_free(body: str, b: BalanceTrace, found: MotionTrace) -> bool:
    """Has it no acceleration along either axis?"""
    laws = [x for since, stop, laws in found.stretches if (since, stop) == (b.since, b.stop) for x in laws]
    own = [x for x in laws if x.coordinate.body == body and x.coordinate.unit == "m"]
    return len(own) > 1 and all(x.f == 0 for x in own)
