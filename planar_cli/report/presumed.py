"""What was taken for granted: signs of letters as drawn, rounded corners, joints that take hold in a blow."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.expansion import expanded
from planar_cli.equation.plain import longer
from planar_cli.problem.expression import JustAfter
from planar_cli.problem.scene import Problem
from planar_cli.report.blocks import Note, line
from planar_cli.report.words import Phrases
from planar_cli.solve.solved_problem import PartSolution

LONGEST = 30


def presumed_notes(part: PartSolution, phrases: Phrases, positive: tuple[sp.Expr, ...] = ()) -> Iterator[Note]:
    """One line for each sign: the file may `assume` it, or the other; `positive`: the side on which the answers hold.
    One for each corner, where a state `just after` would be a blow.
    """
    signs = list(positive)
    signs += [e for instant in part.instants for e in instant.instant.scene.presumed()]
    signs += [e for instant in part.instants for e in instant.conditions]
    if part.motion is not None:
        signs += part.motion.presumed
    for expr in dict.fromkeys(signs):
        if not longer(expr, LONGEST):
            yield Note("Assume", line(phrases.math(_above_zero(expr))))
    if light := _without_mass(part):
        neglected = "it is neglected, or counted with another body"
        yield Note("Assume", line(f"No mass of {' and of '.join(light)} is given: {neglected}."))
    if part.motion is None:
        return
    for state in part.motion.corners:
        yield Note("Assume", line(f"At {state} the corner is rounded and smooth: the speed is kept."))
    for told in _taking_hold(part.motion.problem):
        yield Note("Assume", line(told))


def _without_mass(part: PartSolution) -> dict[str, None]:
    """Bodies that move on and turn, of which the file gives a moment of inertia alone."""
    found: dict[str, None] = {}
    for instant in part.instants:
        motion, scene = instant.trial.system.motion, instant.instant.scene
        for name, body in scene.bodies.items() if motion is not None else ():
            if body.mass != 0 or body.inertia == 0 or not body.rigid or motion is None:
                continue
            v = motion.velocity(body.center, name)
            if any(instant.value.known(p) != 0 for p in (v.x, v.y)):
                found[name] = None
    return found


def _taking_hold(problem: Problem) -> Iterator[str]:
    """Joints that the file lets act from just after a blow on: what makes parts move alike takes part in the blow."""
    blows = {s.name: r.state for s in problem.states for r in s.relations if isinstance(r, JustAfter)}
    for joint in problem.joints:
        if joint.during is not None and not joint.strikes and (before := blows.get(joint.during[0])) is not None:
            where = f"at {place}" if (place := getattr(joint, "at", "")) else joint.name
            yield f"The {joint.kind} {where} takes hold in the blow, so that it acts from {before} on."


def _above_zero(expr: Any) -> sp.Expr:
    """A sum that is positive as one side greater than the other."""
    terms = sp.Add.make_args(expanded(expr))
    left = sp.Add(*(t for t in terms if not t.could_extract_minus_sign()))
    right = sp.Add(*(-t for t in terms if t.could_extract_minus_sign()))
    return sp.StrictGreaterThan(left, right, evaluate=False)
