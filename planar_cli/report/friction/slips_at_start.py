"""A round body that slips from the start of a motion does so by its velocities there, which is no assumption:

Motion  ball slips at C: at 2, v_C = v_G,2 + R ω_2 = J/m to the right
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.scene.scene import with_article
from planar_cli.report.document.blocks import Block, Line, Name, Note, Text, line
from planar_cli.report.friction.rolls_at_state import on_a_belt
from planar_cli.report.words.motion_phrases import motion_phrases
from planar_cli.report.words.state_words import place
from planar_cli.solve.between.trace.trace import ImpactEquation, MotionTrace
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import VELOCITY

SEPARATOR = "; "
SLIPS = "slip"
LONGEST = 8
"""A longer velocity is no reason at sight."""


def with_slips_told(
    blocks: Sequence[Block], motion: MotionTrace, instant: InstantSolution, figures: int
) -> list[Block]:
    """The blocks of one general position, with the velocity of slip at its first state for the assumption."""
    told = dict(_slips(motion, instant, figures))
    found: list[Block] = []
    for b in blocks:
        match b:
            case Note("Assume", (Text(text),)):
                words = text.split(SEPARATOR)
                found += [Note("Motion", told[w]) for w in words if w in told]
                rest = [w for w in words if w not in told]
                found += [replace(b, line=line(SEPARATOR.join(rest)))] if rest else []
            case _:
                found.append(b)
    return found


def _slips(motion: MotionTrace, instant: InstantSolution, figures: int) -> Iterator[tuple[str, Line]]:
    """The words of each assumption that a velocity at the first state tells, with it."""
    stretches = motion.regime(instant).stretches
    starts = [since for since, until in stretches if since != until]
    if not starts:
        return
    state = min(starts, key=motion.states.index)
    for key, mode in instant.trial.system.modes.items():
        if mode.name == SLIPS and (told := _velocity(motion, instant, key, state, figures)):
            yield mode.words, told


def _velocity(motion: MotionTrace, instant: InstantSolution, key: str, state: str, figures: int) -> Line:
    """How fast the point of contact of a body that turns slips on the level ground, which is at rest; (): otherwise."""
    scene, moving = instant.instant.scene, instant.trial.system.motion
    partners = _partners(instant, key)
    bodies = [b for p in partners if (b := scene.carrier(p)) in scene.bodies]
    if moving is None or len(bodies) != 1 or key not in scene.points or not scene.rigid(bodies[0]):
        return ()
    if on_a_belt(scene, partners):
        return ()
    v = moving.velocity(scene.points[key], bodies[0])
    omega = moving.velocities[bodies[0]].angular
    if not instant.value.is_zero(v.y) or not sp.sympify(omega).free_symbols & sp.sympify(v.x).free_symbols:
        return ()
    there = {g: own for own, g in motion.general.items() if motion.ledger.roles[own].at == state}
    letters = simplified(sp.sympify(v.x).xreplace(there).xreplace(dict(motion.route.plain)))
    value = _value(letters, motion)
    sign = motion.value.known(value)
    if not sign or not letters.free_symbols <= _known(motion, state):
        return ()
    phrases = motion_phrases(motion, figures)
    if operations(letters) > LONGEST or operations(value) > LONGEST:
        return ()
    sides: list[Any] = [Name(f"v_{key}"), " = ", phrases.math(letters)]
    if phrases.has_numbers(value):
        numbers = phrases.numbers(letters)
        sides += [] if numbers is None else [" = ", numbers]
        sides += [" = ", phrases.of_dimension(sign, VELOCITY)]
    elif value != letters:
        sides += [" = ", phrases.math(value)]
    way = "right" if sign > 0 else "left"
    return line(f"{with_article(bodies[0])} slips at {key}: {place(state)}, ", *sides, f" to the {way}")


def _known(motion: MotionTrace, state: str) -> set[sp.Symbol]:
    """What is known before the motion from a state on: what is given, and what a blow just before makes."""
    blows = {id(leg): leg for leg in motion.route.steps for e in leg.relations if isinstance(e.source, ImpactEquation)}
    own = {s for leg in blows.values() for s in leg.unknowns if motion.ledger.roles[s].at == state}
    sought = {u.name for u in motion.problem.unknowns}
    return own | {s for s in motion.ledger.known_letters() if s.name not in sought}


def _partners(instant: InstantSolution, key: str) -> Sequence[str]:
    joints = (j for j in instant.instant.scene.problem.joints if j.name == key or getattr(j, "at", None) == key)
    return next((between for j in joints if (between := tuple(getattr(j, "between", ())))), ())


def _value(expr: sp.Expr, motion: MotionTrace) -> sp.Expr:
    """A velocity in what is given, by the formulas of the way."""
    formulas: Mapping[sp.Symbol, Any] = {**motion.route.formulas, **motion.route.plain}
    for _ in motion.route.steps:
        put = {s: formulas[s] for s in expr.free_symbols & formulas.keys() if formulas[s] is not None}
        if not put:
            break
        expr = expr.xreplace(put)
    return simplified(expr)
