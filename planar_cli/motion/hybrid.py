"""The model of a scene whose contacts may stick anywhere and whose impacts may come to rest.

The places that sticking keeps are those where it begins, not those of the drawing: across the surface the relation of
places stands as long as the partners touch, along it only the velocities are held.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from planar_cli.joints.base import Joint
from planar_cli.motion.constraints import Constraint, of_places, of_velocities
from planar_cli.motion.guards import speed_of
from planar_cli.motion.held import Held
from planar_cli.motion.model import Member, Model, always
from planar_cli.motion.scene import MovingScene
from planar_cli.problem.facts import Mode


class HybridModel(Model):
    """One scene with all its modes."""

    def __init__(self, scene: MovingScene, acts: Callable[[Member], bool] = always) -> None:
        super().__init__(scene, acts)

    def _hold(self, joint: Joint, mode: Mode) -> Held:
        held = super()._hold(joint, mode)
        sliding = self._sliding_mode(joint, mode)
        if sliding is None:
            return held
        return replace(held, constraints=self._sticking(joint, mode, sliding))

    def _sliding_mode(self, joint: Joint, mode: Mode) -> Mode | None:
        """The mode in which a joint slides that sticks in this one, at the same place; None where it does not stick."""
        if mode.direction or mode.parted or not mode.facts.joinings or len(self.modes[joint.name]) == 1:
            return None
        place = mode.facts.pushes[0].actions[0].point if mode.facts.pushes else None
        for other in self.modes[joint.name]:
            same = bool(other.facts.pushes) and other.facts.pushes[0].actions[0].point == place
            if other.direction and same:
                return other
        return None

    def _sticking(self, joint: Joint, mode: Mode, sliding: Mode) -> tuple[Constraint, ...]:
        """Across as where it slides; along, velocities only."""
        across = [of_places(self.layout, joint.name, title, place) for title, place in self.places(joint, sliding)]
        if mode.sliding is None:
            return tuple(across)
        speed = speed_of(self.graph, self.scene, mode.sliding)
        along = of_velocities(self.layout, mode.sliding.title, speed)
        return (*across, replace(along, joint=joint.name))
