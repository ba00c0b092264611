"""Where a body is in a general position: what was drawn at one place is at another, and turned."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record

ZERO = sp.S.Zero


@record
class Pose:
    """Where a body is: what was drawn at `drawn` is at `place`; its angle was `before` and is `now`."""

    drawn: Vec
    place: Vec
    before: sp.Expr = ZERO
    now: sp.Expr = ZERO

    @property
    def turn(self) -> sp.Expr:
        return self.now - self.before

    def point(self, p: Vec) -> Vec:
        """Where the material point is that was drawn at p."""
        found: Vec = self.place + self.vector(p - self.drawn)
        return found

    def vector(self, v: Vec) -> Vec:
        """A vector that turns with the body."""
        if self.turn == 0 or (v.x == 0 and v.y == 0):
            return v
        c, s = sp.cos(self.before), sp.sin(self.before)
        along, across = simplified(c * v.x + s * v.y), simplified(c * v.y - s * v.x)
        c, s = sp.cos(self.now), sp.sin(self.now)
        return Vec(along * c - across * s, along * s + across * c)


HERE = Pose(Vec(ZERO, ZERO), Vec(ZERO, ZERO))
