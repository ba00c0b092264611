"""Equations of one body that are plainer than those of the plan, where as few unknowns stand in both: one unknown comes
from each, all others are known by then.

    F_A   ↻ ΣM_G instead of → ΣF_x, for the friction that turns a body: ΣF_x needs a_G = l α/2 beside α, where nothing
          else needs that (the force of a pin stays with ΣF = m a, by which a teacher finds it)
    a_A   → ΣF_x instead of ΣM_P, where the forces are known: m a_G stands there without an arm
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from planar_cli.equation.scene.centres import centre_of
from planar_cli.equation.system.system import System
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.solve.instant.adjoint import sum_masks
from planar_cli.solve.instant.candidates import Candidate
from planar_cli.solve.instant.partners import axis_of
from planar_cli.solve.instant.plan import Block, Plan

About = Callable[[str, Vec, str], Candidate | None]
"""The sum of moments on a body about a point, by its name."""
Sums = Callable[[tuple[str, ...]], list[Candidate | None]]
"""The sums of forces on bodies along x and y."""


@record
class Kinds:
    """Unknowns as bits: all accelerations, those along lines, and friction."""

    motion: int
    moving: int
    friction: int


def with_plainer_equations(plan: Plan, system: System, about: About, sums: Sums, kinds: Kinds) -> Plan:
    """The plan with such equations."""
    found: list[Block] = []
    known = 0
    for block in plan.blocks:
        own = sum(1 << j for j in block.unknowns)
        offered: list[Candidate | None] = []
        (e, *more) = block.equations
        if not more and (body := _body(e, system)):
            center, name = system.scene.center(body), centre_of(system.scene, body)
            if (
                axis_of(e)
                and own & kinds.friction
                and e.mask & kinds.motion
                and not _is_needed(body, e, plan, system, kinds.motion)
            ):
                offered = [about(body, center, name)]
            elif e.choice is not None and e.choice.moment and own & kinds.moving:
                offered = sums((body,))
        at_hand = known & _used_elsewhere(plan, block) | own
        plainer = next((c for c in offered if c is not None and c.mask & own and not c.mask & ~at_hand), None)
        found.append(block if plainer is None else replace(block, equations=(plainer,)))
        known |= own
    return Plan(tuple(found))


def _used_elsewhere(plan: Plan, block: Block) -> int:
    """The unknowns on which this block or another one rests: what serves a test alone would have to be told for it."""
    found = sum_masks(e.mask for e in block.equations)
    for other in plan.blocks:
        if other is not block:
            found |= sum_masks(e.mask for e in other.equations) & ~sum(1 << j for j in other.unknowns)
    return found


def _body(e: Candidate, system: System) -> str:
    """The rigid body that an equation of kinetics is about; "": several, a particle, or no such equation."""
    alone = e.choice is not None and e.condition is None and e.single is None and len(e.bodies) == 1
    return e.bodies[0] if alone and system.scene.rigid(e.bodies[0]) else ""


def _is_needed(body: str, own: Candidate, plan: Plan, system: System, motion: int) -> bool:
    """Does another equation need the acceleration of a body's mass centre, or does it not follow from α alone?"""
    told = system.motion
    assert told is not None
    a = told.acceleration(system.scene.center(body), body)
    if not told.accelerations[body].angular.free_symbols or a.x.is_Symbol or a.y.is_Symbol:
        return True
    if told.velocities[body].angular != 0:
        return True
    others = [e for b in plan.blocks for e in b.equations if e is not own and e.mask & motion]
    return any(body in e.bodies and not _is_without(body, e, system) for e in others)


def _is_without(body: str, e: Candidate, system: System) -> bool:
    """Does an equation hold no acceleration of the mass centre: moments about that, or about a fixed pivot?"""
    if e.choice is None or e.bodies != (body,) or not e.choice.moment or not e.choice.name:
        return False
    return e.choice.name == centre_of(system.scene, body) or system.is_pivot(body, e.choice.vector)
