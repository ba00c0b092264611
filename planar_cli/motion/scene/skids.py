"""Friction of a fixed size against the sliding of one body on another, seen from above."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import field

from planar_cli.motion.terms.functions import Sliding
from planar_cli.motion.terms.layout import Layout
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.scene.facts import Skid, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.scene import GROUND
from planar_cli.problem.scene.setting import MovingSetting
from planar_cli.records import changing


@changing
class Skids:
    """The slidings of one scene, by joint; their directions are noted from time to time."""

    layout: Layout
    scene: MovingSetting
    slidings: dict[str, Sliding] = field(default_factory=dict)
    _terms: dict[str, tuple[Term, Term, Term]] = field(default_factory=dict)
    """Direction x, y, and the speed in it."""
    _velocities: dict[str, Vec] = field(default_factory=dict)
    _code: Code | None = None
    least: float = 0.0
    """A speed up to this is rounding [m/s]."""
    begun: dict[str, list[tuple[float, float, float]]] = field(default_factory=dict)
    """By joint, in order of time: when friction that held was asked for its direction, and against which way it pushed.
    """

    noted: dict[str, float] = field(default_factory=dict)
    """When a velocity last told the direction, by joint."""

    def begins(self, t: float, joint: str, x: float, y: float) -> None:
        """What sticks would slide along (x, y) if it did now."""
        size = math.hypot(x, y)
        if size:
            self.begun.setdefault(joint, []).append((t, x / size, y / size))
            self.slidings[joint].x, self.slidings[joint].y = x / size, y / size

    def loads(self, skid: Skid) -> dict[int, Term]:
        """The generalized force of the friction."""
        return dict(self.layout.of_actions(self.wrenches(skid)))

    def wrenches(self, skid: Skid) -> tuple[Wrench, ...]:
        """The friction on the body, and reversed on what it slides on."""
        x, y, _ = self._of(skid)
        size = self.layout.graph.of(skid.size)
        both = ((skid.body, -1.0), (skid.base, 1.0))
        found = (Wrench(skid.joint, "skid", b, skid.point, Vec(x, y) * (size * s), 0, size) for b, s in both)
        return tuple(w for w in found if w.body != GROUND)

    def speed(self, skid: Skid) -> Term:
        """The speed of the sliding in the direction last noted [m/s]."""
        return self._of(skid)[2]

    def note(self, t: float, y: Sequence[float]) -> None:
        """From now on the directions of this state count."""
        if not self.slidings:
            return
        if self._code is None:
            parts = [p for v in self._velocities.values() for p in (v.x, v.y)]
            self._code = compiled(parts, self.layout.state, self.layout.time)
        self.recall(t)
        numbers = iter(self._code.function(t, y))
        for joint, sliding in self.slidings.items():
            if sliding.note(next(numbers), next(numbers)):
                self.noted[joint] = t

    def recall(self, t: float) -> None:
        """At a time without velocity the direction counts in which sliding was last to begin."""
        for joint, known in self.begun.items():
            k = bisect_right(known, t, key=lambda begun: begun[0])
            if k and known[k - 1][0] >= self.noted.get(joint, -math.inf):
                _, self.slidings[joint].x, self.slidings[joint].y = known[k - 1]

    def forget(self) -> None:
        """A motion begins anew."""
        self.noted.clear()
        for sliding in self.slidings.values():
            sliding.x = sliding.y = 0.0

    def _of(self, skid: Skid) -> tuple[Term, Term, Term]:
        if skid.joint not in self._terms:
            graph = self.layout.graph
            apart = self.scene.velocity(skid.point, skid.body) - self.scene.velocity(skid.point, skid.base)
            velocity = Vec(graph.of(apart.x), graph.of(apart.y))
            sliding = self.slidings[skid.joint] = Sliding(least=self.least)
            self._velocities[skid.joint], self._code = velocity, None
            number = len(self.slidings)
            for part, function in (("x", sliding.along_x), ("y", sliding.along_y), ("speed", sliding.speed)):
                graph.others[f"skid{number}_{part}"] = function
            x, y, speed = (graph.call(f"skid{number}_{p}", velocity.x, velocity.y) for p in ("x", "y", "speed"))
            self._terms[skid.joint] = (x, y, speed)
        return self._terms[skid.joint]
