"""A motion that comes back to where it was: from then on it repeats itself, where nothing varies in time.

What a motion has not reached until then it never reaches. It has come back where it passes the plane through an
earlier state, across its rates there, in the same direction and next to that state (a section of Poincare); or where
it begins anew, after an impact or a change of modes, in the same modes and next to the state of the first such time.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

from planar_cli.integrators.base import Rates, Step
from planar_cli.motion.terms.crossings import Watch
from planar_cli.motion.trajectory.automaton import Choice
from planar_cli.records import changing

RETURNS, NEARLY = 1e-7, 1e-4
"""A state is the same as another up to this part of its scales; nearly the same is one that was missed by errors."""
HALVINGS = 50


@changing
class Recurrence:
    """Watches the steps of a motion for the return of its first state."""

    t0: float
    y0: tuple[float, ...]
    across: tuple[float, ...]
    """The rates of the first state, each in parts of the square of its scale."""
    scale: Sequence[float]
    watch: Watch
    """What is awaited: also turns that it counts must be the same."""
    awaited: Sequence[float]
    """Its values in the first state."""
    away: bool = False
    """Has the motion left the first state?"""
    behind: bool = False
    """Has the motion been on the side from which it came?"""
    period: float | None = None
    """After which it came back [s]."""
    missed: bool = False
    """Did it come back but for errors, so that later returns are chance?"""

    def passes(self, step: Step) -> None:
        """Look at the next step."""
        apart = zip(step.y1, self.y0, self.scale, strict=True)
        self.away = self.away or any(abs(a - b) > NEARLY * s for a, b, s in apart)
        side = self._side(step.y1)
        if side < 0:
            self.behind = True
        elif self.behind and self.period is None and not self.missed:
            self.behind = False
            t = self._crossed(step)
            off = self.off(t, step.at(t))
            self.missed = RETURNS < off <= NEARLY
            self.period = t - self.t0 if off <= RETURNS else None

    def off(self, t: float, y: list[float]) -> float:
        """By how much a state is another than the first one, in parts of scales."""
        awaited = zip(self.watch.values(t, y), self.awaited, self.watch.scales, strict=True)
        return max(abs(a - b) / s for a, b, s in (*zip(y, self.y0, self.scale, strict=True), *awaited))

    def _side(self, y: Sequence[float]) -> float:
        """On which side of the plane through the first state another lies."""
        return sum(n * (b - a) for n, a, b in zip(self.across, self.y0, y, strict=True))

    def _crossed(self, step: Step) -> float:
        """When the plane is passed within a step, from behind."""
        low, high = step.t0, step.t1
        for _ in range(HALVINGS):
            middle = (low + high) / 2
            if self._side(step.at(middle)) < 0:
                low = middle
            else:
                high = middle
        return high


Place = tuple[Choice, tuple[str, ...]]
"""The modes, and the states that have been reached."""


@changing
class Recurrences:
    """What looks for returns from one change of modes to the next, by modes and states reached the first of them."""

    first: dict[Place, Recurrence] = field(default_factory=dict)

    def at(
        self, place: Place, rates: Rates, t: float, y: tuple[float, ...], scale: Sequence[float], watch: Watch
    ) -> Recurrence:
        """Looks for the return of a state, or has seen it to be that of an earlier one. `watch`: what is awaited."""
        across = tuple(r / s**2 for r, s in zip(rates(t, list(y)), scale, strict=True))
        found = Recurrence(t, y, across, scale, watch, watch.values(t, list(y)))
        first = self.first.setdefault(place, found)
        if first.away and not first.missed:
            off = first.off(t, list(y))
            first.missed = RETURNS < off <= NEARLY
            found.period = t - first.t0 if off <= RETURNS else None
        return found
