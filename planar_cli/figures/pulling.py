"""The pulls of ropes in a diagram: away from the body, each where its strand leaves the rim of a wheel."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planar_cli.equation.scene.bodies import BodyModel
from planar_cli.figures.drawn import Drawn
from planar_cli.figures.partners import sketch_of
from planar_cli.figures.ropes import Strand, strands
from planar_cli.figures.shapes import moved
from planar_cli.problem.scene.sketches import Cord
from planar_cli.report.document.marks import Arc, Arrow, Mark, Spot

HERE = 1e-6
"""Places that are no farther apart, m, are one."""
ALIKE = 0.5
"""A strand on a small wheel, which only the drawing has, is off the direction of its pull by no more than this."""
SMALL = 6.0
"""A diagram with such a wheel is at least so many of its radii wide."""


class Pulling:
    """The strands of ropes that leave the bodies of a diagram. Each is taken by one arrow."""

    def __init__(self, found: Sequence[Strand]) -> None:
        self.left, self.rims = list(found), [s for s in found if s.small and s.radius]

    @classmethod
    def of(cls, drawn: Drawn, bodies: Sequence[BodyModel], pulls: Sequence[Spot]) -> Pulling:
        """`pulls`: the places of tensions of the list; an arrow that stands for several strands leaves no rim."""
        names = {b.name for b in bodies}
        cords = (s for j in drawn.scene.problem.joints for s in sketch_of(drawn, j) if isinstance(s, Cord))
        own = [s for cord in cords for s in strands(drawn, cord) if s.body in names]
        return cls([s for s in own if sum(_is_at(s, p) for p in pulls) >= sum(o.center == s.center for o in own)])

    @property
    def least(self) -> float:
        """So wide is the diagram, at least, m."""
        return max((SMALL * s.radius for s in self.rims), default=0.0)

    def wheels(self) -> Iterator[Mark]:
        """The wheels under particles."""
        yield from {s.center: Arc(s.center, s.radius, "thin") for s in self.rims}.values()

    def placed(self, mark: Mark, at: Spot) -> Mark:
        """An arrow where its strand is; as it is, if none is there."""
        here = [s for s in self.left if _is_at(s, at)]
        if not isinstance(mark, Arrow) or not here:
            return mark
        off = {s: abs(math.remainder(s.angle - mark.angle, 2 * math.pi)) for s in here}
        own = min(here, key=lambda s: off[s])
        if off[own] > ALIKE:
            return mark
        self.left.remove(own)
        return replace(mark, at=_leaves(own, mark.angle), inward=False)


def _leaves(strand: Strand, angle: float) -> Spot:
    """Where a pull is drawn: it touches a small wheel, although its strand has another direction."""
    if not strand.small or not strand.radius:
        return moved(strand.center, 0.0, *strand.off)
    aside = strand.off[1] * math.cos(angle) - strand.off[0] * math.sin(angle)
    return moved(strand.center, angle, 0.0, math.copysign(strand.radius, aside))


def _is_at(strand: Strand, at: Spot) -> bool:
    """Does the list have the pull of a strand there: in the centre of its wheel, or on its rim?"""
    return min(math.dist(at, strand.center), math.dist(at, moved(strand.center, 0.0, *strand.off))) < HERE
