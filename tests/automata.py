"""Scenes of one or two bodies with their regimes written by hand: doubles for tests of what happens between regimes."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

from planar_cli.integrators.base import Step
from planar_cli.motion.trajectory.automaton import Automaton, Choice
from planar_cli.motion.trajectory.impact import Struck, StruckContact
from planar_cli.problem.scene.facts import Facts, Mode

GRAVITY = 9.81
Function = Callable[[float, Sequence[float]], float]
Vector = Callable[[float, Sequence[float]], list[float]]


@dataclass(frozen=True)
class Always:
    """A scene in which everything acts all the time."""

    scene: Automaton

    def automaton(self, reached: Sequence[str], striking: str = "") -> Automaton:
        """The same always."""
        return self.scene

    def applied(self, after: str, t: float, y: Sequence[float]) -> Mapping[str, tuple[float, ...]]:
        """None."""
        return {}

    def corner(self, reached: Sequence[str], choice: Choice, t: float, y: Sequence[float]) -> None:
        """None."""


@dataclass(frozen=True)
class Condition:
    """A guard."""

    joint: str
    kind: str
    words: str
    value: Function
    strict: bool = False
    scale: float = 1.0


@dataclass(frozen=True)
class Law:
    """A regime: the accelerations, and what it demands of the state by giving it back mended."""

    accelerations: Vector
    conditions: tuple[Condition, ...] = ()
    mend: Vector = lambda t, y: list(y)
    stored: Function = lambda t, y: 0.0
    fed: Function = lambda t, y: 0.0

    @property
    def guards(self) -> tuple[Condition, ...]:
        return self.conditions

    @property
    def conservative(self) -> bool:
        return False

    def rates(self, t: float, y: Sequence[float]) -> list[float]:
        return [*y[len(y) // 2 :], *self.accelerations(t, y)]

    def watch(self, t: float, y: Sequence[float]) -> list[float]:
        return [c.value(t, y) for c in self.conditions]

    def project(self, t: float, y: Sequence[float]) -> list[float]:
        return self.mend(t, y)

    def closed(self, t: float, y: Sequence[float]) -> list[float]:
        return list(y)

    def reduced(self, t: float, y: Sequence[float]) -> None:
        return None

    def energy(self, t: float, y: Sequence[float]) -> float:
        return self.stored(t, y)

    def power(self, t: float, y: Sequence[float]) -> float:
        return self.fed(t, y)

    @property
    def shared(self) -> frozenset[str]:
        return frozenset()

    def presumed(self, t: float, y: Sequence[float]) -> tuple[()]:
        return ()

    def momentum(self, t: float, y: Sequence[float]) -> tuple[float, float, float]:
        return (0.0, 0.0, 0.0)


def modes(*names: str) -> tuple[Mode, ...]:
    return tuple(Mode(name, name, Facts()) for name in names)


@dataclass(frozen=True)
class Scene:
    """An automaton of such regimes. `contacts`: what touches at a time in a state, in a choice."""

    choices: Mapping[str, Sequence[Mode]]
    laws: Callable[[Choice], Law]
    masses: tuple[float, ...]
    scale: tuple[float, ...]
    contacts: Callable[[Choice, float, Sequence[float]], list[StruckContact]] = lambda choice, t, y: []
    time_scale: float = 1.0
    energy_scale: float = 1.0
    autonomous: bool = True
    made: dict[Choice, Law] = field(default_factory=dict)

    def regime(self, choice: Choice) -> Law:
        if choice not in self.made:
            self.made[choice] = self.laws(choice)
        return self.made[choice]

    def outside(self, choice: Choice) -> None:
        return None

    def undetermined(self, choice: Choice, t: float, y: Sequence[float]) -> tuple[str, ...]:
        return ()

    def drawn_apart(self, t: float, y: Sequence[float], struck: Collection[str] = ()) -> None:
        pass

    def sliding_points(self, choice: Choice, t: float, y: Sequence[float]) -> None:
        pass

    def misfits(self, choice: Choice, t: float, y: Sequence[float]) -> Mapping[str, float]:
        mended = self.regime(choice).project(t, y)
        return {"": max(abs(a - b) / s for a, b, s in zip(mended, y, self.scale, strict=True))}

    def prepare(self, choice: Choice, t: float, y: Sequence[float]) -> None:
        pass

    def note(self, t: float, y: Sequence[float], step: Step | None = None) -> None:
        pass

    def struck(
        self, choice: Choice, t: float, y: Sequence[float], near: float, forced: bool = False, drawn: bool = False
    ) -> Struck:
        n = len(self.masses)
        speeds = tuple(self.scale[n:])
        return Struck(tuple(y[n:]), self.masses, speeds, (), tuple(self.contacts(choice, t, y)))


def touching(gap: float) -> bool:
    return abs(gap) <= 1e-8
