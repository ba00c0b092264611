"""A check that a person can make of forces and accelerations: power, to which smooth joints add nothing.

    Σ F v = 120 - 78.5 = 41.5 W,  dT/dt = Σ (m a v + I α ω) = 30.2 + 11.3 = 41.5 W

From rest there is no power yet; other equations check what begins then.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.motion import Twist
from planar_cli.equation.values.exact import Unvalued
from planar_cli.problem.scene.geometry import Vec
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.by_direction import has_speed_of_ours
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import POWER

MOST = 6
"""Terms of a sum that fits a line."""

Moving = Callable[[Vec, str], Vec]
Twists = Mapping[str, Twist]
"""The velocities of points of bodies and of the bodies; from rest their accelerations."""


def power_check(instant: InstantSolution, phrases: Phrases) -> Line:
    """Empty where nothing moves or no more is told than a direction, where forces do work that have no value on the
    page, or where the sums are long.
    """
    system = instant.trial.system
    motion = system.motion
    if motion is None or not has_powers(instant, phrases):
        return ()
    try:
        work = counting(list(powers(instant, phrases, motion.velocity, motion.velocities)))
        change = counting(list(changes(instant, phrases, motion.velocity, motion.velocities)))
    except Unvalued:
        return ()
    if not work or not change or max(len(work), len(change)) > MOST or not agree(work, change):
        return ()
    unit = coherent_unit(POWER, False, phrases.ledger.us)
    return line(
        "power: Σ F v = ",
        *chain(work, unit, phrases),
        "; d",
        Name(system.scene.problem.kinetic_energy),
        "/dt = Σ (m a v + I α ω) = ",
        *chain(change, unit, phrases),
    )


def has_powers(instant: InstantSolution, phrases: Phrases) -> bool:
    """Are there forces and motions in numbers, of bodies that stay what they are?"""
    system = instant.trial.system
    if phrases.symbolic or not instant.trial.outcomes or system.motion is None or system.reactions is None:
        return False
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    bodies = system.scene.bodies.values()
    if not any(w.law in ("force", "moment") for w in written) or any(b.varies for b in bodies):
        return False
    told = all(w.law in ("force", "moment", "relation") for w in written)
    return told and not has_speed_of_ours(system.statements)


def powers(instant: InstantSolution, phrases: Phrases, moving: Moving, twists: Twists) -> Iterator[Decimal]:
    """What every load, and every reaction that has some, does in a second, W."""
    system, value = instant.trial.system, phrases.value
    assert system.reactions is not None
    for w in system.wrenches:
        linear = 0 if w.force is None else w.force.dot(moving(w.point, w.body))
        yield value(sp.sympify(linear + w.couple * twists[w.body].angular))
    for push, expr in system.reactions.pushes:
        parts = [
            (0 if a.force is None else a.force.dot(moving(a.point, a.body))) + a.couple * twists[a.body].angular
            for a in push.actions
        ]
        rates = [phrases.certain(sp.sympify(p)) for p in parts]
        if not agree(rates, []):
            yield sum(rates, Decimal(0)) * value(expr)


def changes(instant: InstantSolution, phrases: Phrases, moving: Moving, twists: Twists) -> Iterator[Decimal]:
    """m a · v and I α ω of every body, W."""
    motion = instant.trial.system.motion
    assert motion is not None
    for name, body in instant.trial.system.scene.bodies.items():
        if body.mass != 0:
            a, v = motion.acceleration(body.center, name), moving(body.center, name)
            yield phrases.value(sp.sympify(body.mass * a.dot(v)))
        if body.rigid:
            yield phrases.value(sp.sympify(body.inertia * motion.accelerations[name].angular * twists[name].angular))
