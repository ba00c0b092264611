"""Why kinetic friction points as it is drawn: the way in which what begins to slip does so, by the accelerations found.

a_C = a_G + R α = 4.5285 + 0.4 · 9.782 = 8.441 m/s² > 0: spool slides at C to the right, against its friction
"""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.exact import ZERO
from planar_cli.problem.scene.facts import Action, Mode
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.report.document.blocks import Line, Name, line
from planar_cli.report.kinematics.own_accelerations import in_letters_found
from planar_cli.report.notation.numbers import vector_words
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.study import TINY
from planar_cli.solve.solution import InstantSolution
from planar_cli.units import ACCELERATION

LONGEST, MOST = 8, 2
"""A longer acceleration is no reason at sight; so many are told."""


def slip_senses(instant: InstantSolution, phrases: Phrases) -> list[Line]:
    """One line for each contact that begins to slip from rest as its friction did not suffice; nothing where the
    velocities tell it, or the acceleration is long.
    """
    trial = instant.trial
    begins = any(trial.choice) and instant.instant.at_rest and trial.outcomes and not phrases.symbolic
    if not begins or phrases.lettered or any(trial.velocities[0].values.values()):
        return []
    told = (x for mode in trial.system.modes.values() for x in _told(mode, instant, phrases))
    return list(told)[:MOST]


def _told(mode: Mode, instant: InstantSolution, phrases: Phrases) -> Iterator[Line]:
    friction = next((p for p in mode.facts.pushes if p.kind == "friction"), None)
    if mode.name != "slip" or mode.sliding is None or mode.sliding.rate != 0 or friction is None:
        return
    if abs(instant.trial.outcomes[0].assembly.row_speed(mode.sliding)) > TINY:
        return
    own, *others = friction.actions
    if own.force is None or len(others) != 1:
        return
    (other,) = others
    way = _ahead(own.force, instant)
    found = _along(own, other, way, instant)
    number = instant.value.known(found)
    size = instant.trial.outcomes[0].push(friction.name)
    if not number or size is None or operations(found) > LONGEST or not found.free_symbols:
        return
    # What slides does so against the friction on it.
    against = size * (instant.value.known(own.force.dot(way)) or ZERO)
    if against * number >= 0:
        return
    x, y = (number * (instant.value.known(sp.sympify(c)) or ZERO) for c in (way.x, way.y))
    turns = not instant.value.vanishes(_angular(own.body, instant))
    value = phrases.of_dimension(number, ACCELERATION)
    head = () if found.is_Symbol or other.body != GROUND or not turns else line(Name(f"a_{friction.place}"), " = ")
    put = [piece for side in phrases.substituted(found, value) for piece in (" = ", side)]
    whole = line(*head, phrases.math(found), *put, " = ", value, " > 0" if number > 0 else " < 0")
    where = f" on {other.body}" if other.body != GROUND else f" at {friction.place}" if turns else ""
    words = f": {own.body} slides{where} {_way(x, y, instant)}, against its friction"
    yield line(*whole, words)


def _angular(body: str, instant: InstantSolution) -> sp.Expr:
    motion = instant.trial.system.motion
    return sp.S.Zero if motion is None else sp.sympify(motion.accelerations[body].angular)


def _way(x: Decimal, y: Decimal, instant: InstantSolution) -> str:
    """To the right, or up the slope; on a level table there is none."""
    if x and y and instant.instant.scene.problem.plane == "vertical":
        return "up the slope" if y > 0 else "down the slope"
    return vector_words(x, y)


def _ahead(force: Vec, instant: InstantSolution) -> Vec:
    """The direction of a friction, to the right or up."""
    x, y = (instant.value.known(sp.sympify(c)) or ZERO for c in (force.x, force.y))
    return force * -1 if x < 0 or (x == 0 and y < 0) else force


def _along(own: Action, other: Action, way: Vec, instant: InstantSolution) -> sp.Expr:
    """The acceleration of a point of a body relative to its partner, in what the page finds."""
    motion = instant.trial.system.motion
    assert motion is not None
    whole = motion.acceleration(own.point, own.body)
    if other.body != GROUND:
        whole = whole - motion.acceleration(other.point, other.body)
    named = {e: s for stage in instant.stages for s, e in stage.algebra.explicit.items()}
    found = simplified(sp.sympify(whole.dot(way)))
    return named.get(found, in_letters_found(found, instant))
