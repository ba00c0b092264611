"""A check that a person can make: an equation that the solution did not use, with the numbers of the answers in it.

ladder:  ↺ ΣM_G = 89.5 - 40.8 - 22.7 = 26.0 N·m, I α = 26.0 N·m
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.scene.centres import centre_of
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.kinematics.own_accelerations import in_letters_found
from planar_cli.report.words.counted import sense_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ENERGY, FORCE, Dimension, default_unit

LEAST, MOST, TINY = 2, 6, Decimal("1e-30")
"""Terms of a sum that is worth a check, and that still fits a line; what is no part of a force."""
LONGEST = 14
"""Operations in what it amounts to."""


@record
class _Sum:
    """One sum over what acts on a body."""

    lead: Line
    terms: tuple[Decimal, ...]
    """Forces [N], or moments [N m]."""
    dimension: Dimension
    inertia: sp.Expr
    """What they amount to."""


def another_equation(instant: InstantSolution, phrases: Phrases) -> Line:
    """The check of one body; empty where no equation is left, or its numbers are not on the page."""
    if phrases.symbolic or not instant.trial.outcomes or instant.trial.system.reactions is None:
        return ()
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    for body in instant.instant.scene.bodies:
        used = [w for w in written if body in w.bodies and w.law in ("force", "moment")]
        if not used or instant.instant.scene.bodies[body].mass == 0:
            continue
        for found in _left(instant, body, used, phrases):
            terms = counting(found.terms)
            known = phrases.value.known(found.inertia) is not None
            least = 1 if known and found.dimension == ENERGY and not phrases.value.is_zero(found.inertia) else LEAST
            if known and least <= len(terms) <= MOST and not longer(found.inertia, LONGEST):
                return _told(body, found, terms, phrases, instant.instant.principle.inertia_as_force)
    return ()


def _left(instant: InstantSolution, body: str, used: list[Written], phrases: Phrases) -> Iterator[_Sum]:
    """The sums of one body about its mass centre, along x and along y that stand in no equation of the solution."""
    scene, motion = instant.instant.scene, instant.trial.system.motion
    model = scene.bodies[body]
    acting = list(acting_on(instant, body, phrases))
    still = instant.trial.system.balanced(body)
    names = (model.center_name, centre_of(scene, body))
    if model.rigid and not any(w.law == "moment" and w.lead in names for w in used):
        turned = [product_of(moment_of(a.point - model.center, a.force, phrases) + a.couple, a.size) for a in acting]
        alpha = sp.S.Zero if still or motion is None else model.inertia * motion.accelerations[body].angular
        name = model.center_name if model.center_name and model.center_name != body else "G"
        if None not in turned:
            turn = instant.trial.system.tree.turn((body,))
            lead = line(f"{sense_of(turn)} ", Name(f"ΣM_{name}"))
            yield _Sum(lead, tuple(turn * t for t in turned if t is not None), ENERGY, turn * alpha)
    for axis, arrow in (("x", "→"), ("y", "↑")):
        if any(w.law == "force" and w.lead == axis and w.bodies == (body,) for w in used):
            continue
        parts = [product_of(getattr(a.force, axis), a.size) for a in acting if a.force is not None]
        moved = None if still or motion is None else motion.acceleration(model.center, body)
        inertia = sp.S.Zero if moved is None else in_letters_found(model.mass * getattr(moved, axis), instant)
        if None not in parts:
            yield _Sum(line(f"{arrow} ", Name(f"ΣF_{axis}")), tuple(p for p in parts if p is not None), FORCE, inertia)


@record
class Acting:
    """What acts on a body for a size of one; `size`: None where no line of the page tells it."""

    point: Vec
    force: Any
    couple: Decimal
    size: Decimal | None


def product_of(part: Decimal, size: Decimal | None) -> Decimal | None:
    """What it contributes to a sum; nothing, whatever its size, where it has no part in it. None: that is not known."""
    if abs(part) < TINY:
        return Decimal(0)
    return None if size is None else part * size


def acting_on(instant: InstantSolution, body: str, phrases: Phrases) -> Iterator[Acting]:
    """What acts on a body; of a load its numbers, of a reaction its direction and its size."""
    system, value = instant.trial.system, phrases.value
    assert system.reactions is not None
    for w in system.wrenches:
        if w.body == body:
            numbers = (None, None) if w.force is None else (value.known(w.force.x), value.known(w.force.y))
            couple = value.known(sp.sympify(w.couple))
            told = couple is not None and (w.force is None or None not in numbers)
            force = None if w.force is None else Vec(*numbers) if told else Vec(Decimal(1), Decimal(1))
            yield Acting(w.point, force, couple or Decimal(0), Decimal(1) if told else None)
    for push, expr in system.reactions.pushes:
        for a in push.actions:
            if a.body == body:
                force = None if a.force is None else Vec(value(a.force.x), value(a.force.y))
                yield Acting(a.point, force, value(sp.sympify(a.couple)), value.known(expr))


def moment_of(arm: Vec, force: Any, phrases: Phrases) -> Decimal:
    """The moment of a force."""
    if force is None:
        return Decimal(0)
    x, y = (phrases.value(sp.sympify(e)) for e in (arm.x, arm.y))
    moment: Decimal = x * force.y - y * force.x
    return moment


def _told(body: str, found: _Sum, terms: list[Decimal], phrases: Phrases, inertial: bool) -> Line:
    """A sum with its terms and what it comes to, then what it amounts to with its value; nothing where these differ.
    `inertial`: that is among the terms, and they come to zero.
    """
    unit = phrases.page_unit(default_unit(found.dimension))
    change = phrases.certain(found.inertia)
    if not agree(terms, [change]):
        return ()
    if inertial and change:
        return line(f"{body}: ", *found.lead, " = ", *chain([*terms, -change], unit, phrases))
    # What is zero at sight stands nowhere else on the page.
    nothing = {s: sp.S.Zero for s in found.inertia.free_symbols if phrases.value.is_zero(s)}
    inertia = found.inertia.xreplace(nothing)
    head = line(f"{body}: ", *found.lead, " = ", *chain(terms, unit, phrases))
    return line(*head, ", ", phrases.math(inertia), " = ", *chain([change], unit, phrases)) if change else head
