"""Laws of motion that speak along the velocity or across it: what begins at rest has no such direction."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.errors import Diagnostic, NoSolution, refuse
from planar_cli.motion.regime.model import Model
from planar_cli.motion.terms.zeros import Zeros
from planar_cli.problem.language.expression import Part, Quantity
from planar_cli.problem.language.walk import walk

NATURAL = ("t", "n")
"""The parts along a velocity and across it."""
NOTHING = 1e-9
"""A speed up to this part of a usual one is none."""


def demand_directions(model: Model, zeros: Zeros) -> None:
    """NoSolution: a law gives a natural component of what begins at rest. FileProblem: it gives the rate of its speed,
    which is one number whatever the direction, but tells no way to go. Once the start has been found.
    """
    usual = max(zeros.sizes[model.layout.count :], default=1.0)
    for q in _natural(model):
        velocity = model.asked.quantities.speed(q)
        (square,) = zeros.numbers((model.scene.graph.of(velocity.dot(velocity)),))
        if math.sqrt(max(square, 0.0)) <= NOTHING * usual:
            rests = f"{q.things[0]}, which begins at rest: it has no direction there"
            hint = "write it along a direction, as `.along(30 deg)`, or give the speed with which it begins"
            if q.word == "v":
                raise refuse(q.mark, "PL556", f"the rate of the speed of {rests}", hint)
            kind = next(p.kind for p in q.parts if p.kind in NATURAL)
            raise NoSolution([Diagnostic(q.mark, "PL556", f".{kind} of {rests}", hint)])


def _natural(model: Model) -> Iterator[Quantity]:
    """Natural components of accelerations, and speeds whose rate is given, in laws that hold all the time."""
    for law in model.scene.problem.motion:
        for node in walk(law.statement) if law.during is None else ():
            match node:
                case Quantity(word="a", parts=parts) if any(p.kind in NATURAL for p in parts):
                    yield node
                case Quantity(word="dot", argument=Quantity(word="v", parts=(Part(kind="mag"),)) as speed):
                    yield speed
