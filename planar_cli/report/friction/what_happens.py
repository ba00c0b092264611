"""What begins where something is as large as it can be, and more than one thing might: it slips, or it tips.

P_low = P = 235.4 N; beyond it the crate slips
"""

from __future__ import annotations

import re

import sympy as sp

from planar_cli.equation.system.on_two_points import on_two_points
from planar_cli.problem.language.expression import Name as Letter
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.friction.decisions import limits_of
from planar_cli.report.friction.offsets import offsets
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution

TIPS_ABOUT = re.compile(r"about to tip( about \S+)?")


def what_happens(symbol: sp.Symbol, part: PartSolution) -> str:
    """The words behind the answer that is an extreme; "": it is none, or there is but one limit that it might reach."""
    if part.motion is not None or len(part.instants) != 1:
        return ""
    (instant,) = part.instants
    extremes = instant.instant.statements.extremes
    own = next((e for e in extremes if isinstance(e.side, Letter) and e.side.name == symbol.name), None)
    if own is None or not instant.trial.outcomes:
        return ""
    words = [w.lead for s in instant.stages for b in s.blocks for w in b.equations if w.source == "limit"]
    slips = any("about to slip" in lead for lead in words)
    tips = next((found for lead in words if (found := TIPS_ABOUT.search(lead))), None)
    bodies = _bodies(instant)
    if slips == (tips is not None) or len(bodies) != 1:
        return ""
    does = "slips" if tips is None else f"tips{tips[1] or _edge(instant)}"
    return f"; {'beyond' if own.sense > 0 else 'below'} it {with_article(bodies[0])} {does}"


def _bodies(instant: InstantSolution) -> list[str]:
    """The bodies whose contact has friction and a face, or two points on which they stand: they may slip or tip."""
    system = instant.trial.system
    kinds: dict[str, set[str]] = {}
    for mode, _ in limits_of(instant.trial):
        for push in mode.facts.pushes:
            kinds.setdefault(push.actions[0].body, set()).add(push.kind)
    stands = {body for body, own in kinds.items() if {"friction", "couple"} <= own}
    stands |= {found[0] for p in system.pushes if p.kind == "normal" and (found := on_two_points(system, p.joint))}
    return [b for b in system.scene.bodies if b in stands]


def _edge(instant: InstantSolution) -> str:
    """About which edge of its face it tips, on level ground."""
    for own in offsets(instant.trial, instant.value):
        x, y = (instant.value.known(sp.sympify(c)) for c in (own.way.x, own.way.y))
        if own.value is not None and x and not y:
            return f" about its {'right' if x > 0 else 'left'} edge"
    return ""
