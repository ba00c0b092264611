"""From where a motion that was followed is followed again: one of its states, with other places or velocities there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from planar_cli.motion.follow.stages import SceneStages
from planar_cli.motion.trajectory.automaton import Automaton, Choice, Corner, Start
from planar_cli.records import record
from planar_cli.simulate.measures import Moment


@record
class Since:
    """A state, the states `before` it, and the `moments` of all of these."""

    state: str
    before: tuple[str, ...]
    start: Start
    moments: Mapping[str, Moment]


@record
class Later:
    """The stages of a scene once the states `before` have been reached (motion/trajectory/automaton.py)."""

    stages: SceneStages
    before: tuple[str, ...]

    def automaton(self, reached: Sequence[str], striking: str = "") -> Automaton:
        return self.stages.automaton((*self.before, *reached), striking)

    def applied(self, after: str, t: float, y: Sequence[float]) -> Mapping[str, tuple[float, ...]]:
        return self.stages.applied(after, t, y)

    def apart(self, reached: Sequence[str], t: float, y: Sequence[float]) -> tuple[str, str] | None:
        return self.stages.apart((*self.before, *reached), t, y)

    def corner(self, reached: Sequence[str], choice: Choice, t: float, y: Sequence[float]) -> Corner | None:
        return self.stages.corner((*self.before, *reached), choice, t, y)
