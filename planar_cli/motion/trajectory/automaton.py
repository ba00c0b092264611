"""What the following of a motion asks of a scene: a hybrid automaton.

A regime is one choice of modes with its ordinary differential equations; its guards say how long it holds. The state
`y` = (q, v) is the same vector in all regimes: a change of mode maps it by identity, an impact changes only v.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Protocol

from planar_cli.integrators.base import Step
from planar_cli.motion.trajectory.impact import Struck
from planar_cli.motion.trajectory.reduced import Reduced
from planar_cli.problem.scene.facts import Mode
from planar_cli.records import record

Resultant = Callable[[float, Sequence[float]], tuple[float, float, float]]
"""Force x, y [N] and moment about the origin [N m] at a time in a state."""


@record
class Outside:
    """What acts on a scene from outside, for the balance of its momentum."""

    at: Resultant
    """The resultant."""
    least: tuple[float, float, float]
    """Momenta that count as usual in this scene: linear x, y [N s], angular about the origin [N m s]."""


@record
class Corner:
    """Where what guides a body goes on in another direction."""

    joints: tuple[str, ...]
    """What guides it from there on."""
    after: tuple[float, ...]
    """The state beyond it."""


Choice = tuple[int, ...]
"""For every joint of `Automaton.choices`, in its order, the index of its mode."""


class Guard(Protocol):
    """A condition that must hold as long as its regime does: its value >= 0, or > 0 where it is strict."""

    @property
    def joint(self) -> str:
        """The joint, or the key of the load, whose mode it belongs to."""

    @property
    def kind(self) -> str:
        """presses, limit, slips, gap, again, taut, stretch, tips, mass."""

    @property
    def words(self) -> str:
        """The condition in words, as it holds."""

    @property
    def strict(self) -> bool:
        """May it not stay zero?"""

    @property
    def scale(self) -> float:
        """The size of a usual value."""


class Regime(Protocol):
    """One choice of modes."""

    @property
    def guards(self) -> Sequence[Guard]:
        """In the order of what `watch` returns."""

    def rates(self, t: float, y: Sequence[float]) -> list[float]:
        """y'."""

    def watch(self, t: float, y: Sequence[float]) -> list[float]:
        """The values of the guards."""

    def project(self, t: float, y: Sequence[float]) -> list[float]:
        """The nearest state that the joints of this regime allow, in places and velocities."""

    def closed(self, t: float, y: Sequence[float]) -> list[float]:
        """A state inside a step on the joints, which dense output keeps to the order of its error only."""

    def reduced(self, t: float, y: Sequence[float]) -> Reduced | None:
        """The same with the independent coordinates alone; None where that does not serve in this state."""

    def energy(self, t: float, y: Sequence[float]) -> float:
        """Kinetic energy and potentials [J]."""

    def power(self, t: float, y: Sequence[float]) -> float:
        """What feeds or drains it [W]."""

    @property
    def conservative(self) -> bool:
        """Is there nothing that feeds or drains it?"""

    @property
    def shared(self) -> frozenset[str]:
        """Joints whose forces are not unique, as redundant constraints share them."""

    def momentum(self, t: float, y: Sequence[float]) -> Sequence[float]:
        """Linear momentum x, y [N s] and angular momentum about the origin [N m s]."""

    def presumed(self, t: float, y: Sequence[float]) -> Sequence[tuple[str, str, float]]:
        """What joints take for granted and do not keep: the joint, what it does where that changes, and a number that
        must not, in parts of its scale.
        """


class Automaton(Protocol):
    """A scene that may be in one of many regimes."""

    @property
    def choices(self) -> Mapping[str, Sequence[Mode]]:
        """The modes of every joint that has several; the natural one first."""

    @property
    def scale(self) -> Sequence[float]:
        """The size of a usual value of each number of the state."""

    @property
    def time_scale(self) -> float:
        """The time in which things change [s]."""

    @property
    def energy_scale(self) -> float:
        """The size of a usual energy [J]."""

    @property
    def autonomous(self) -> bool:
        """Does nothing in it depend on the time?"""

    def regime(self, choice: Choice) -> Regime:
        """The regime of a choice."""

    def outside(self, choice: Choice) -> Outside | None:
        """What acts from outside in a choice; None: not known."""

    def undetermined(self, choice: Choice, t: float, y: Sequence[float]) -> Sequence[str]:
        """Bodies without mass that may move in this choice as nothing tells: forces do not determine their motion."""

    def drawn_apart(self, t: float, y: Sequence[float], struck: Collection[str] = ()) -> tuple[str, str] | None:
        """The plastic impact that leaves its partners at different places, and in words what is open then; None: no
        impact does. Of those without `during` these that have just `struck`.
        """

    def sliding_points(self, choice: Choice, t: float, y: Sequence[float]) -> tuple[str, str] | None:
        """The same of one that leaves points in contact which slide along each other."""

    def misfits(self, choice: Choice, t: float, y: Sequence[float]) -> Mapping[str, float]:
        """By how much a state misses what each joint of a choice demands of places and velocities, in parts of the
        scales; "" where it can not be told which.
        """

    def prepare(self, choice: Choice, t: float, y: Sequence[float]) -> None:
        """Modes are about to be chosen: what sticks in this choice would slide as it is pushed."""

    def note(self, t: float, y: Sequence[float], step: Step | None = None) -> None:
        """A state has been reached: angles that go on over many turns count from it, and along a `step` from it."""

    def struck(
        self, choice: Choice, t: float, y: Sequence[float], near: float, forced: bool = False, drawn: bool = False
    ) -> Struck:
        """What an impact at this moment has to do with: all that holds in this choice, and all that is closer than
        the part `near` of the scene's length. `forced`: with all that the file lets strike between two states. `drawn`:
        nothing but impacts makes it a blow, and no motion led there, so that particles may be drawn apart.
        """


class Stages(Protocol):
    """The scene with what acts in it at each stage of the schedule."""

    def automaton(self, reached: Sequence[str], striking: str = "") -> Automaton:
        """The scene once these states have been reached; `striking`: in the blow before this state, which joints that
        begin with it make too.
        """

    def applied(self, after: str, t: float, y: Sequence[float]) -> Mapping[str, tuple[float, ...]]:
        """The impulses of loads, by their names, in the blow that ends in the state `after`, for each velocity."""

    def apart(self, reached: Sequence[str], t: float, y: Sequence[float]) -> tuple[str, str] | None:
        """A joint that begins with the last of these states and whose partners do not touch there, with words."""

    def corner(self, reached: Sequence[str], choice: Choice, t: float, y: Sequence[float]) -> Corner | None:
        """The corner at which the last of these states is reached; None: there is none."""


@record
class Start:
    """Where a motion begins."""

    t: float
    """When [s]."""
    y: tuple[float, ...]
    """The state."""
    choice: Choice | None = None
    """The modes to begin the search with; None: the natural ones."""
    assumed: tuple[str, ...] = ()
    """What the file does not say of it, in words."""
