"""A check that a person can make of bodies that start from rest: work and energy of the first second.

with these accelerations for 1 s:  U = 519.2 - 69.23 - 77.88 = 372.1 J,  T = 139.5 + 232.6 = 372.1 J

Bodies that translate, and those that turn about their mass centres, keep their accelerations under constant forces.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.report.checks.power_check import MOST, changes, has_powers, powers
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.in_numbers.sums import agree, chain, counting
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ENERGY


def first_second(instant: InstantSolution, phrases: Phrases) -> Line:
    """Empty where something moves already, where a body swings, or where one body alone takes part: F s = m a s says
    nothing new.
    """
    system = instant.trial.system
    motion = system.motion
    if motion is None or not has_powers(instant, phrases):
        return ()
    try:
        twists = motion.velocities.values()
        if any(phrases.value(e) for t in twists for e in (t.linear.x, t.linear.y, t.angular)):
            return ()
        if any(_swings(instant, name, phrases) for name in system.scene.bodies):
            return ()
        work = counting(list(powers(instant, phrases, motion.acceleration, motion.accelerations)))
        change = counting(list(changes(instant, phrases, motion.acceleration, motion.accelerations)))
    except Unvalued:
        return ()
    if not work or len(change) < 2 or max(len(work), len(change)) > MOST or not agree(work, change):
        return ()
    unit = coherent_unit(ENERGY, False, phrases.ledger.us)
    # s = a t²/2 and v = a t: both sides are halves.
    works, energies = (chain([t / 2 for t in terms], unit, phrases, "J") for terms in (work, change))
    head = line("with these accelerations for 1 s: U = ", *works, ", ")
    return line(*head, Name(system.scene.problem.kinetic_energy), " = ", *energies)


def _swings(instant: InstantSolution, name: str, phrases: Phrases) -> bool:
    """Does it turn while its mass centre moves?"""
    system = instant.trial.system
    assert system.motion is not None
    body = system.scene.bodies[name]
    a = system.motion.acceleration(body.center, name)
    turns = body.rigid and phrases.certain(system.motion.accelerations[name].angular) != 0
    return turns and any(phrases.certain(sp.sympify(e)) for e in (a.x, a.y))
