"""A regime over an interval of time, with the steps that were taken in it."""

from __future__ import annotations

from bisect import bisect_right

from planar_cli.integrators.base import Step
from planar_cli.motion.trajectory.automaton import Choice, Regime
from planar_cli.motion.trajectory.balance import Balance
from planar_cli.records import record


@record
class Segment:
    """A regime from one time to another."""

    choice: Choice
    regime: Regime
    t0: float
    """Beginning [s]."""
    t1: float
    """End [s]."""
    start: tuple[float, ...]
    """The state at the beginning."""
    end: tuple[float, ...]
    """The state at the end."""
    steps: tuple[Step, ...]
    """What the integrator took, the last of them perhaps beyond the end; none where the state stays as it is."""
    balance: Balance | None = None
    """How energy and momentum add up over it."""

    def at(self, t: float) -> list[float]:
        """The state at a time of the segment."""
        if t <= self.t0 or not self.steps:
            return list(self.start)
        if t >= self.t1:
            return list(self.end)
        k = bisect_right(self.steps, t, key=lambda step: step.t1)
        step = self.steps[min(k, len(self.steps) - 1)]
        return step.at(t) if t == step.t0 else self.regime.closed(t, step.at(t))
