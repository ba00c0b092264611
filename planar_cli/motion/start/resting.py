"""Rest beside what is driven: everything that can be at rest is."""

from __future__ import annotations

from planar_cli.errors import NOWHERE
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.zeros import Equation, Zeros


def resting(layout: Layout, zeros: Zeros) -> list[list[Equation]]:
    """What is zero at rest, in the order in which it is asked for: the rates of whole bodies, then those of rotations,
    then the others, one by one.
    """
    sizes = zeros.sizes[len(layout.slots) :]
    rates = [(s, Equation(s.rate, size, "at rest", NOWHERE)) for s, size in zip(layout.slots, sizes, strict=True)]
    bodies = dict.fromkeys(s.body for s, _ in rates)
    whole = [[e for s, e in rates if s.body == body] for body in bodies]
    turning = [[e] for s, e in rates if s.kind == "theta"]
    return [*whole, *turning, *([e] for s, e in rates if s.kind != "theta")]
