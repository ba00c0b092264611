"""A check that a person can make of forces and accelerations: power, to which smooth joints add nothing.

    Σ F v = 120 - 78.5 = 41.5 W,  dT/dt = Σ (m a v + I α ω) = 30.2 + 11.3 = 41.5 W

From rest the velocities are a t soon after, and the same sums with a in place of v are those of U = T.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.exact import Unvalued
from planar_cli.equation.motion import Twist
from planar_cli.problem.geometry import Vec
from planar_cli.report.blocks import Line, Name, line
from planar_cli.report.page_units import coherent_unit
from planar_cli.report.sums import agree, chain, counting
from planar_cli.report.words import Phrases
from planar_cli.solve.instant.by_direction import has_speed_of_ours
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ENERGY, POWER

MOST = 6
"""Terms of a sum that fits a line."""

Moving = Callable[[Vec, str], Vec]
"""The velocity of a point of a body; from rest its acceleration."""


def power_check(instant: InstantSolution, phrases: Phrases) -> Line:
    """Empty where nothing moves or no more is told than a direction, where forces do work that have no value on the
    page, or where the sums are long.
    """
    system = instant.trial.system
    motion = system.motion
    if phrases.symbolic or not instant.trial.outcomes or motion is None or system.reactions is None:
        return ()
    written = [w for s in instant.stages if s.level == "acceleration" for b in s.blocks for w in b.equations]
    bodies = system.scene.bodies.values()
    if not any(w.law in ("force", "moment") for w in written) or any(b.varies for b in bodies):
        return ()
    if any(w.law not in ("force", "moment", "relation") for w in written) or has_speed_of_ours(system.statements):
        return ()
    try:
        still = all(
            phrases.value(e) == 0 for t in motion.velocities.values() for e in (t.linear.x, t.linear.y, t.angular)
        )
        moving, twists = (motion.acceleration, motion.accelerations) if still else (motion.velocity, motion.velocities)
        work = counting(list(_powers(instant, phrases, moving, twists)))
        change = counting(list(_changes(instant, phrases, moving, twists)))
    except Unvalued:
        return ()
    if not work or not change or max(len(work), len(change)) > MOST or not agree(work, change):
        return ()
    told = _from_rest if still else _moving
    return told(work, change, Name(system.scene.problem.kinetic_energy), phrases)


def _powers(instant: InstantSolution, phrases: Phrases, moving: Moving, twists: dict[str, Twist]) -> Iterator[Decimal]:
    """The power of every load, and of every reaction that has some, W."""
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


def _changes(instant: InstantSolution, phrases: Phrases, moving: Moving, twists: dict[str, Twist]) -> Iterator[Decimal]:
    """m a · v and I α ω of every body, W."""
    motion = instant.trial.system.motion
    assert motion is not None
    for name, body in instant.trial.system.scene.bodies.items():
        if body.mass != 0:
            a, v = motion.acceleration(body.center, name), moving(body.center, name)
            yield phrases.value(sp.sympify(body.mass * a.dot(v)))
        if body.rigid:
            yield phrases.value(sp.sympify(body.inertia * motion.accelerations[name].angular * twists[name].angular))


def _moving(work: list[Decimal], change: list[Decimal], energy: Name, phrases: Phrases) -> Line:
    unit = coherent_unit(POWER, False, phrases.ledger.us)
    return line(
        "power: Σ F v = ",
        *chain(work, unit, phrases),
        "; d",
        energy,
        "/dt = Σ (m a v + I α ω) = ",
        *chain(change, unit, phrases),
    )


def _from_rest(work: list[Decimal], change: list[Decimal], energy: Name, phrases: Phrases) -> Line:
    """Works ΣF · a t²/2 and kinetic energies Σ m (a t)²/2: the same sums, halved."""
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    works, energies = ([t / 2 for t in terms] for terms in (work, change))
    return line(
        "work and energy soon after the start, with s = a t²/2 and v = a t: U/t² = ",
        *chain(works, unit, phrases, "J/s^2"),
        ", ",
        energy,
        "/t² = ",
        *chain(energies, unit, phrases, "J/s^2"),
    )
