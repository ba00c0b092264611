"""A statement by which the point of contact of a round body has no velocity is told as what it is:

At 3 the ball rolls without slipping:   v_G,3 = -R ω_3
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.scene.scene import Scene
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import with_article
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace, Relation
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution

KINDS = ("contact", "rolling")
LEAST = 2
"""The velocity of a point of contact has as many letters: that of the centre, and the angular one."""


def with_rolling_told(part: PartSolution) -> PartSolution:
    """A part whose motion has these words."""
    if part.motion is None:
        return part
    route, steps = part.motion.route, []
    contacts = list(_at_contacts(part.motion))
    for step in route.steps:
        relations = tuple(_as_rolling(e, part.motion, contacts) for e in step.relations)
        steps.append(step if relations == step.relations else replace(step, relations=relations))
    same = all(a is b for a, b in zip(steps, route.steps, strict=True))
    return part if same else replace(part, motion=replace(part.motion, route=replace(route, steps=tuple(steps))))


def _as_rolling(e: Relation, found: MotionTrace, contacts: Sequence[tuple[str, sp.Expr]]) -> Relation:
    """The relation, with these words where it says that a body rolls."""
    if e.kind != "given" or e.since or e.source is not None or len(e.residual.free_symbols) < LEAST:
        return e
    for body, v in contacts:
        if _is_multiple(e.residual, v) or _is_multiple(e.residual.xreplace(dict(found.general)), v):
            return replace(e, words=f"{with_article(body)} rolls without slipping")
    return e


def _is_multiple(one: sp.Expr, other: sp.Expr) -> bool:
    if one.free_symbols != other.free_symbols:
        return False
    ratio = simplified(one / other)
    return bool(ratio.is_number and ratio != 0)


def _at_contacts(found: MotionTrace) -> Iterator[tuple[str, sp.Expr]]:
    """Bodies that turn, with the velocity at their contact with what is at rest: in a motion, and just after a blow."""
    for regime in found.regimes:
        yield from _of(regime.solution, blow=False)
    sources = (e.source for leg in found.route.steps for e in leg.relations)
    for impact in {id(s.impact): s.impact for s in sources if isinstance(s, ImpactEquation)}.values():
        if impact.solution is not None:
            yield from _of(impact.solution, blow=True)


def _of(solution: InstantSolution, blow: bool) -> Iterator[tuple[str, sp.Expr]]:
    scene, motion = solution.instant.scene, solution.trial.system.motion
    for joint in scene.problem.joints if motion is not None else ():
        at = getattr(joint, "at", None)
        partners = getattr(joint, "between", ())
        if motion is None or joint.kind not in KINDS or at not in scene.points or on_a_belt(scene, partners):
            continue
        bodies = [b for p in partners if (b := scene.carrier(p)) in scene.bodies]
        if len(bodies) != 1 or not scene.rigid(bodies[0]):
            continue
        # In a blow velocities after it stand where an instant has accelerations.
        of = motion.acceleration if blow else motion.velocity
        yield from ((bodies[0], v) for v in _along(of(scene.points[at], bodies[0])))


def on_a_belt(scene: Scene, partners: Iterable[str]) -> bool:
    """Is one of the partners of a joint a surface that runs by itself, on which rolling is not what it is on rest?"""
    return any(p in scene.surfaces and scene.surfaces[p].speed is not None for p in partners)


def _along(v: Vec) -> Iterator[sp.Expr]:
    """The one component that is not zero."""
    parts = [p for p in map(sp.sympify, (v.x, v.y)) if p != 0]
    if len(parts) == 1 and len(parts[0].free_symbols) >= LEAST:
        yield parts[0]
