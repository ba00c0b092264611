"""What a motion was: segments, transitions, when each state of the schedule was reached, and how it ended."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping
from dataclasses import field

from planar_cli.integrators.base import Counts
from planar_cli.motion.trajectory.automaton import Choice
from planar_cli.motion.trajectory.schedule import Reached
from planar_cli.motion.trajectory.segment import Segment
from planar_cli.records import record


@record
class Transition:
    """What happens at one moment between two segments."""

    t: float
    """When [s]."""
    kind: str
    """mode (another choice of modes), impact, graze (a contact that is only just touched), corner (a surface goes on
    in another direction), rest (the limit of impacts without number)."""
    words: str
    """The cause: the condition that ceased to hold, or who strikes."""
    joints: tuple[str, ...]
    """Whose modes changed, or who took part in the impact."""
    before: tuple[float, ...]
    """The state just before."""
    after: tuple[float, ...]
    """The state just after: other velocities after an impact."""
    old: Choice
    new: Choice
    begins: str = ""
    """In a change of mode: what the joints do from now on."""
    impulses: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    """In an impact: normal and friction impulse of every contact [N s]; of a rope its tension's."""
    given: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    """In an impact: what the impulses of every joint do to the momentum that belongs to each velocity of the state."""
    lost: float = 0.0
    """The kinetic energy that was lost [J]."""
    law: str = ""
    """In an impact: what was assumed, where more than one contact takes part."""
    unbalanced: float = 0.0
    """In an impact: the largest part of a usual impulse by which a momentum does not add up, linear or angular, of one
    body, or of what bodies do to each other."""
    count: float = 1
    """How many impacts it stands for; infinite for the limit of a sequence."""


@record
class Outcome:
    """How the motion ended."""

    kind: str
    """until (the time is over), reached (the last state), rest (nothing moves any more), held (nothing moves, as a
    resistance is more than what acts), repeats (the motion has come back to where it was), none (no consistent modes),
    several (more than one consistent motion), shared (forces that are not unique decide), singular, small (steps too
    small), long (too many of them), spent (a free part of a rope has run out), again (partners of an impact that is
    over meet), open (what follows a plastic impact is not told), endless (impacts or changes of mode without end),
    contradiction (joints that cannot all hold), aside (what a joint takes for granted changes), unbalanced (momentum
    or energy does not add up)."""
    words: str
    """As a sentence, with the place and time."""
    t: float
    """When [s]."""
    joint: str = ""
    """Where, if it has a place."""
    code: str = ""
    """The diagnostic code of a refusal; "" where the motion ended as it should."""

    @property
    def refused(self) -> bool:
        """Could the motion not be followed to its end?"""
        return bool(self.code)


@record
class Work:
    """What it cost."""

    steps: int = 0
    rejected: int = 0
    evaluations: int = 0
    choices: int = 0
    """Choices of modes that were looked at."""

    def more(self, counts: Counts) -> Work:
        """With the work of another run."""
        steps, rejected = self.steps + counts.steps, self.rejected + counts.rejected
        return Work(steps, rejected, self.evaluations + counts.evaluations, self.choices)


@record
class Trajectory:
    """A motion from its start to its end."""

    segments: tuple[Segment, ...]
    transitions: tuple[Transition, ...]
    """In order of time; several may happen at one moment."""
    events: tuple[Reached, ...]
    missed: tuple[str, ...]
    """States of the schedule that were not reached."""
    outcome: Outcome
    work: Work
    notes: tuple[str, ...] = ()
    """What else must be said: an unstable equilibrium that is kept, energy that an impact wins."""

    @property
    def t0(self) -> float:
        """Its beginning [s]."""
        return self.segments[0].t0 if self.segments else self.outcome.t

    @property
    def t1(self) -> float:
        """Its end [s]."""
        return self.segments[-1].t1 if self.segments else self.outcome.t

    def segment_at(self, t: float) -> Segment:
        """The segment in which a time lies; at a transition the one before it."""
        k = bisect_right(self.segments, t, key=lambda s: s.t1)
        if k and self.segments[k - 1].t1 == t:
            k -= 1
        return self.segments[min(k, len(self.segments) - 1)]

    def at(self, t: float) -> list[float]:
        """The state at a time."""
        return self.segment_at(t).at(t)

    def event(self, name: str) -> Reached | None:
        """A state of the schedule; None where it was not reached."""
        return next((e for e in self.events if e.name == name), None)
