"""What a file says of time, in numbers: states in their order, each with what tells that it has been reached.

The first state is the start. Every later one is the first instant after the one before it at which its relations hold;
one that has a time may stand anywhere, and what is listed behind it comes after it. Reading the relations of a file
into these is for whoever knows the scene.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from planar_cli.motion.trajectory.automaton import Choice, Regime
from planar_cli.records import record

Measure = Callable[[Regime, Choice, float, Sequence[float]], float]
"""A number at an instant of the motion: in this regime, at this time, in this state."""
Condition = Callable[[Regime, Choice, float, Sequence[float]], bool]


@record
class Crossing:
    """A number whose zero tells that a state is reached."""

    value: Measure
    scale: float
    """The size of a usual value."""
    sense: int = 0
    """-1: it must fall through zero (a largest value, by its rate); 1: rise (a smallest one); 0: either."""


@record
class Reached:
    """A state of the schedule that was reached."""

    name: str
    t: float
    """When [s]."""
    y: tuple[float, ...]
    """The state as it arrives."""
    choice: Choice
    """The modes as it arrives."""
    segment: int
    """In which segment, counted from 0."""


@record
class Event:
    """A state of the file after the first one."""

    name: str
    time: float | None = None
    """The time at which it is, where the file says so [s]."""
    crossing: Crossing | None = None
    """What reaches zero there."""
    others: tuple[Crossing, ...] = ()
    """What reaches zero there too, and tells the state where the first one is only touched; all hold there."""
    modes: tuple[tuple[str, str], ...] = ()
    """Joints with the mode that they have there: it is reached when they all have it."""
    conditions: tuple[Condition, ...] = ()
    """What else must hold there: it is not reached where one of them fails."""
    after: str = ""
    """`just after` this state: when that one is reached and what strikes there has struck."""
    rest: bool = False
    """Reached when nothing moves."""
    endless: bool = False
    """At t = infinity: reached when the motion has settled."""
    back: int = 0
    """It comes before so many of the given times that are listed just before it: after them it never happens."""

    @property
    def crossings(self) -> tuple[Crossing, ...]:
        """All that reaches zero there."""
        return self.others if self.crossing is None else (self.crossing, *self.others)


@record
class Schedule:
    """All that a file says of time."""

    start: str = ""
    """The first state's name."""
    events: tuple[Event, ...] = ()
    breakpoints: tuple[float, ...] = ()
    """Times at which loads jump or have a kink [s]."""
    heard: Callable[[Reached], None] | None = None
    """Told of every state that is reached, as it is reached."""
