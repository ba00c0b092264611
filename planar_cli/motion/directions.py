"""Laws of motion that speak along the velocity or across it: what begins at rest has no such direction."""

from __future__ import annotations

import math
from collections.abc import Iterator

from planar_cli.errors import Diagnostic, NoSolution
from planar_cli.motion.model import Model
from planar_cli.motion.zeros import Zeros
from planar_cli.problem.expression import Quantity
from planar_cli.problem.walk import walk

NATURAL = ("t", "n")
"""The parts along a velocity and across it."""
NOTHING = 1e-9
"""A speed up to this part of a usual one is none."""


def demand_directions(model: Model, zeros: Zeros) -> None:
    """NoSolution: a law gives a natural component of what begins at rest. At a start that has been found."""
    usual = max(zeros.sizes[model.layout.count :], default=1.0)
    for q in _natural(model):
        velocity = model.asked.quantities.speed(q)
        (square,) = zeros.numbers((model.scene.graph.of(velocity.dot(velocity)),))
        if math.sqrt(max(square, 0.0)) <= NOTHING * usual:
            kind = next(p.kind for p in q.parts if p.kind in NATURAL)
            text = f".{kind} of {q.things[0]}, which begins at rest: it has no direction there"
            hint = "write it along a direction, as `.along(30 deg)`, or give the speed with which it begins"
            raise NoSolution([Diagnostic(q.mark, "PL556", text, hint)])


def _natural(model: Model) -> Iterator[Quantity]:
    """Natural components of accelerations in laws that hold all the time."""
    for law in model.scene.problem.motion:
        for node in walk(law.statement) if law.during is None else ():
            if isinstance(node, Quantity) and node.word == "a" and any(p.kind in NATURAL for p in node.parts):
                yield node
