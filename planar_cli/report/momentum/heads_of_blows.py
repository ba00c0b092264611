"""What stands over an equation of a blow: of which bodies it is, what it balances, and why it has no other impulses.

A, B: conservation of momentum along x (no external impulse)
AB: angular momentum about A, through which J passes
No rebound (e = 0): A and B have one velocity along the common normal
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from typing import Any

import sympy as sp

from planar_cli.problem.scene.facts import Action
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, Math, Name, line
from planar_cli.report.momentum.nil_impulses import nil_beside
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, Relation, Result

RESTITUTION = re.compile(r"restitution between (.+), along the common normal")
STATE = "__"
"""Stands before the state in the name of a letter."""
MOST = 2
"""Of more impulses through one point the diagrams speak."""


def no_rebound(e: ImpactEquation) -> str:
    """What a restitution that is zero says; "" of any other."""
    found = RESTITUTION.fullmatch(e.lead or e.words)
    if found is None or any(s.name.endswith(f"__{e.impact.since}") for s in (e.left - e.right).free_symbols):
        return ""
    return f"No rebound (e = 0): {found[1]} have one velocity along the common normal"


def together(bodies: str, velocity: sp.Symbol, whole: bool) -> Line:
    """The velocity of what does not rebound. `whole`: it has no part across the common normal."""
    along = "" if whole else " along the common normal"
    return line(f"No rebound (e = 0): after the blow {bodies} have the same velocity ", Math(velocity), f"{along}.")


def keeps(e: Relation, r: Result) -> bool:
    """Does a balance of moments of a blow, or one of the momentum of one body along an axis, say that a velocity stays
    what it was?
    """
    if not isinstance(e.source, ImpactEquation) or not (e.source.law == "moment" or _is_of_one(e.source)):
        return False
    if r.formula is None or not r.formula.is_Symbol:
        return False
    own, since, before = r.formula.name.partition(STATE)
    return bool(since) and before == e.source.impact.since and own == r.unknown.name.partition(STATE)[0]


def _is_of_one(e: ImpactEquation) -> bool:
    return e.law == "force" and bool(e.lead) and len(e.bodies) == 1


def told_alone(found: MotionTrace) -> set[str]:
    """The states before blows of which one equation is told, by which a velocity stays what it was."""
    sources = [e.source for leg in found.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation)]
    once = {since for since, n in Counter(s.impact.since for s in sources).items() if n == 1}
    legs = [leg for leg in found.route.steps if len(leg.relations) == 1]
    kept = (leg.relations[0] for leg in legs if keeps(leg.relations[0], leg.results[0]))
    return once & {e.since for e in kept if isinstance(e.source, ImpactEquation) and e.source.law == "moment"}


def unchanged(e: ImpactEquation, passing_by: Sequence[Any]) -> Line:
    """Why bodies turn on together as they did, or a body goes on as it did; (): the equation says it. `passing_by`:
    `, through which J passes`.
    """
    if _is_of_one(e):
        return line(f"{e.bodies[0]}, no impulse along {e.lead}")
    if e.law != "moment" or e.centre is not None or len(e.bodies) < 2:
        return ()
    words = f"Just after {e.impact.since}, {', '.join(e.bodies)}: "
    inner = "the impulses between them are internal"
    others = line(", and those from outside pass through ", Name(e.lead)) if passing_by else ()
    kept = line(", so that ", Name(f"H_{e.lead}"), " and ", Name(f"I_{e.lead}"), " stay what they are")
    return line(words, inner, *others, *kept)


def is_conserved(e: ImpactEquation) -> bool:
    """Has a group of bodies no impulse from outside along the direction of an equation?"""
    solution = e.impact.solution
    if e.law != "force" or len(e.bodies) < 2 or not e.along or solution is None:
        return False
    system = solution.trial.system
    along, value = Vec(*map(sp.sympify, e.along)), solution.value
    given = [w.force for w in system.wrenches if w.kind == "impulse" and w.body in e.bodies and w.force is not None]
    if any(not value.is_zero(sp.sympify(f.dot(along))) for f in given):
        return False
    return not (e.left - e.right).free_symbols & set(system.symbols.values())


def passing(e: ImpactEquation, used: Collection[sp.Symbol]) -> tuple[sp.Expr, ...]:
    """The impulses on a group that pass through the named point about which an equation is; (): none, or many. `used`:
    the letters of all equations of blows, and of what is asked.
    """
    solution = e.impact.solution
    if solution is None or e.law != "moment" or e.lead not in solution.instant.scene.points:
        return ()
    center = solution.instant.scene.points[e.lead]
    nil = nil_beside(solution, solution.stages[0], used)
    outer = ((s, acting) for s, acting in _outer(e) if s not in nil)
    found = [s for s, acting in outer if all(solution.value.is_zero(_moment(a, center)) for a in acting)]
    return tuple(found) if len(found) <= MOST else ()


def _moment(action: Action, center: Vec) -> sp.Expr:
    arm = action.point - center
    turning = arm.cross(action.force) if action.force is not None else sp.S.Zero
    return sp.sympify(turning + action.couple)


def _outer(e: ImpactEquation) -> Iterator[tuple[sp.Symbol, list[Action]]]:
    """The unknown impulses that act on a group from outside, with where they act on it."""
    assert e.impact.solution is not None
    solution = e.impact.solution
    reactions = solution.trial.system.reactions
    assert reactions is not None
    for push, expr in reactions.pushes:
        own = [a for a in push.actions if a.body in e.bodies]
        if own and len(own) < len(push.actions) and expr.is_Symbol:
            yield expr, own
