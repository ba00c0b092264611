"""On which side of a thin rod something is that may go round its ends, or of a line that it may pass before they meet.

The side counts that was noted last while it was beyond the ends: so the distance keeps its sign where they strike, and
what has gone round meets the rod from the other side.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field, replace

from planar_cli.motion.scene.gaps import Gap
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Graph, Term
from planar_cli.records import changing

NEAR = 1e-9
"""Nearer to the rod's line, or to its end, than this part of the scene's extent, the side does not change."""

ARRIVED = 1e-6
"""Nearer than this part of it to a line, what has come to it is on it, and stays on its side."""


@changing
class Facing:
    """One of them."""

    off: Term
    """How far it is from the rod's line, on the side where it is drawn > 0 [m]."""
    within: tuple[Term, ...]
    """All positive beside the rod, not beyond its ends [m]."""
    near: float
    """A distance that is none [m]."""
    side: float = 1.0
    """1: where it is drawn; -1: on the other side."""
    told: bool = False
    """Of two points that are drawn as one, and of a point that comes to a line: has their motion told the side?"""
    free: bool = False
    """Does nothing keep it on its side until they meet?"""

    def at(self, off: float) -> float:
        """The side last noted, wherever it is now; where it is free, that on which it is."""
        if self.free and abs(off) > self.near:
            return 1.0 if off > 0 else -1.0
        return self.side

    def note(self, off: float, *within: float) -> None:
        """It is here now."""
        if min(within, default=0.0) <= self.near < abs(off):
            self.side, self.told = 1.0 if off > 0 else -1.0, not self.free

    def parts(self, rate: float) -> bool:
        """Would two points, drawn as one, or a point and a line part at this rate, so that they come from the other
        side? That is noted.
        """
        turned = rate > 0 and not self.told
        self.side *= -1 if turned else 1
        self.told = self.told or rate != 0
        return turned


@changing
class Facings:
    """All of one scene."""

    graph: Graph
    extent: float
    """Of the scene [m]."""
    members: list[Facing] = field(default_factory=list)
    _points: dict[str, tuple[str, Term]] = field(default_factory=dict)
    _code: Code | None = None

    def both_sides(self, gap: Gap, called: str) -> Gap:
        """A gap as it is on the side where the partners are. `called`: by this two points, or what comes to a line,
        keep their side.
        """
        if gap.points and not gap.told:
            name, side = self._kept(called, Facing(gap.distance, (), NEAR * self.extent))
            return replace(gap, distance=side * gap.distance, normal=gap.normal * side, facing=name)
        met = gap.line if gap.free else gap.thin
        if met is None:
            return gap
        center, radius = met
        facing = Facing(gap.distance + radius, gap.within, NEAR * self.extent, free=gap.free)
        name, side = self._kept(called, facing) if gap.free else self._side(facing)
        point = center + (gap.point - center) * side
        gap = replace(gap, distance=side * facing.off - radius, point=point, normal=gap.normal * side)
        # Of a point on a line nothing but how it moves tells from which side it has come.
        return replace(gap, facing=name) if gap.free and radius.constant and radius.zero else gap

    def last_side(self, called: str, off: Term) -> Term:
        """+1 or -1: on which side of a line, `off` from it, something is or was before it came there."""
        return self._kept(called, Facing(off, (), ARRIVED * self.extent, free=True))[1]

    def _kept(self, called: str, facing: Facing) -> tuple[str, Term]:
        """The name of a member and its side; the same however often the gap is asked for."""
        if called not in self._points:
            self._points[called] = self._side(facing)
        return self._points[called]

    def _side(self, facing: Facing) -> tuple[str, Term]:
        """The name of a member that is new, and its side."""
        self.members.append(facing)
        self._code = None
        name = f"facing{len(self.members)}"
        self.graph.others[name] = facing.at
        self.graph.slopes[name] = lambda off: self.graph.number(0.0)
        return name, self.graph.call(name, facing.off)

    def parts(self, name: str, rate: float) -> bool:
        """Would the two points of a member part at this rate, so that they come from the other side?"""
        return self.members[int(name.removeprefix("facing")) - 1].parts(rate)

    def note(self, state: Sequence[Term], time: Term, t: float, y: Sequence[float]) -> None:
        """From now on the sides of this state count. `state`: the variables that `y` holds."""
        if not self.members:
            return
        if self._code is None:
            self._code = compiled(list(self._terms()), state, time)
        numbers = iter(self._code.function(t, y))
        for facing in self.members:
            facing.note(next(numbers), *(next(numbers) for _ in facing.within))

    def begin(self) -> None:
        """A motion begins anew, as drawn."""
        for facing in self.members:
            facing.side, facing.told = 1.0, False

    def _terms(self) -> Iterator[Term]:
        for facing in self.members:
            yield facing.off
            yield from facing.within
