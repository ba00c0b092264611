"""Impacts without number in a finite time: a ball that bounces lower and lower comes to rest on the floor.

The times between impacts then shrink by a constant ratio r (the coefficient of restitution, on a level floor), and what
is left of them is Δ r / (1 - r). The sum is taken when r is settled and what the body would still move does not count.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace

from planar_cli.motion.follow.transition import Moment, Resolved, resolve
from planar_cli.motion.trajectory.automaton import Choice
from planar_cli.motion.trajectory.trajectory import Outcome, Transition
from planar_cli.records import changing

NEEDED = 4
"""So many impacts with shrinking intervals are needed before a limit is spoken of."""
SLOWEST = 1.0 - 1e-6
"""A ratio above this does not shrink."""
FINEST = 1e-10
"""Lower bounces than this part of the scene's size can hardly be told from rest."""


@changing
class Bounces:
    """The latest impacts."""

    times: list[float] = field(default_factory=list)
    """When [s]."""
    speeds: list[float] = field(default_factory=list)
    """By how much the velocities changed, in parts of their scales."""

    def add(self, t: float, before: Sequence[float], after: Sequence[float], scale: Sequence[float]) -> None:
        """One impact more, from the states before and after it; velocities are their second halves."""
        half = len(scale) // 2
        speed = max(abs(a - b) / s for a, b, s in zip(after[half:], before[half:], scale[half:], strict=True))
        self.times = [*self.times[-NEEDED:], t]
        self.speeds = [*self.speeds[-NEEDED:], speed]

    def forget(self) -> None:
        """Something else happened."""
        self.times, self.speeds = [], []

    def limit(self, time_scale: float, tolerance: float) -> tuple[float, float] | None:
        """When the impacts end, if they are about to, and the uncertainty of that time [s]."""
        if len(self.times) < NEEDED:
            return None
        a, b, c = (self.times[i + 1] - self.times[i] for i in range(len(self.times) - 4, len(self.times) - 1))
        if min(a, b, c) <= 0:
            return None
        first, second = b / a, c / b
        if not 0 < second < SLOWEST or not 0 < first < SLOWEST:
            return None
        left = c * second / (1 - second)
        doubt = left * abs(second - first) / (1 - second)
        # What still moves meanwhile: the last speed for the time that is left; and how high the last bounce was.
        tolerance = max(tolerance, FINEST)
        moves, height = (t / time_scale * self.speeds[-1] for t in (left, c))
        if (moves > tolerance and height > FINEST) or doubt > 1e3 * tolerance * time_scale:
            return None
        return self.times[-1] + left, doubt


def summed_up(bounces: Bounces, moment: Moment, found: Resolved) -> tuple[Resolved | Outcome, float | None]:
    """What an instant leads to where its impacts are among many that end in a finite time: their partners stay
    together; and when the impacts end [s]. None: they do not; then `found` stands.
    """
    impacts = [x for x in found.transitions if x.kind == "impact"]
    if not impacts:
        return found, None
    automaton = moment.automaton
    bounces.add(moment.t, impacts[-1].after, moment.y, automaton.scale)
    limit = bounces.limit(automaton.time_scale, moment.tolerance)
    if limit is None:
        return found, None
    closed = resolve(replace(moment, inelastic=True))
    if not isinstance(closed, Resolved):
        return closed, None
    bounces.forget()
    return closed, limit[0]


def at_rest(transitions: Sequence[Transition], t: float, y: tuple[float, ...], choice: Choice) -> Transition:
    """The limit of a sequence of impacts, the last of which is known."""
    last = next(x for x in reversed(transitions) if x.kind == "impact")
    words = "the impacts, without number, have come to an end"
    return Transition(t, "rest", words, last.joints, y, y, choice, choice, count=float("inf"))
