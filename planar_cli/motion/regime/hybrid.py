"""The model of a scene whose contacts may stick anywhere and whose impacts may come to rest.

The places that sticking keeps are those where it begins, not those of the drawing: across the surface the relation of
places stands as long as the partners touch, along it only the velocities are held.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import replace

from planar_cli.joints.base import Joint
from planar_cli.motion.regime.guards import AGAIN, Measured, speed_of
from planar_cli.motion.regime.held import Held
from planar_cli.motion.regime.model import Member, Model, always
from planar_cli.motion.scene.drives import constraints_of
from planar_cli.motion.scene.encounters import Encounter, at_another_corner, encounters_of
from planar_cli.motion.scene.gaps import Gap
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.constraints import Constraint, of_places, of_velocities
from planar_cli.motion.terms.terms import Term
from planar_cli.problem.language.expression import Law
from planar_cli.problem.scene.facts import Mode, Row
from planar_cli.problem.scene.geometry import Vec
from planar_cli.records import record


@record
class End:
    """One end of a face that lies on another body: a corner about which it may tip."""

    gap: Term
    """How far it is from the other body [m]."""
    tipping: tuple[int, ...]
    """The modes, by index, in which the face tips about it."""


class HybridModel(Model):
    """One scene with all its modes."""

    def __init__(
        self,
        scene: MovingScene,
        acts: Callable[[Member], bool] = always,
        passing: Sequence[Law] = (),
        over: Collection[str] = (),
    ) -> None:
        """`passing`: the relations of `motion` that hold for some time, and now. `over`: the impacts that the states
        they act between have behind them.
        """
        super().__init__(scene, acts)
        for relation in self.asked.said(law.statement for law in passing):
            self.drives = (*self.drives, *constraints_of(self.asked, relation.text, relation.residuals))
        for name, modes in self.modes.items():
            self.modes[name] = tuple(self._carried(m) if m.name == "tip" else m for m in modes)
        self.impacts = [j for j in self.joints if j.strikes]
        """The impacts of the file that may happen now."""
        self.joints = [j for j in self.joints if not j.strikes]
        for impact in self.impacts:
            del self.modes[impact.name]
        standing = {j.name: self._standing(j, over) for j in self.impacts}
        self.encounters = encounters_of(
            scene, self.impacts, lambda j, gap: any(self._is_there(c, gap) for c in standing[j.name]), over
        )
        """The contacts that impacts make, where no joint is one already, by the impact's name."""
        self.impacts = [j for j in self.impacts if j.name not in over]
        every = [e for found in self.encounters.values() for e in found]
        self.over = [e for e in every if e.over]
        """Those that are behind."""
        self.lasting = [e for e in every if e.plastic and not e.forced]
        """Those that leave their partners in contact, whenever they meet."""
        for encounter in (e for found in self.encounters.values() for e in found):
            self.joints.append(encounter)
            self.modes[encounter.name] = encounter.modes(scene)
        self.choices = {name: modes for name, modes in self.modes.items() if len(modes) > 1}

    def _standing(self, impact: Joint, over: Collection[str]) -> list[Joint]:
        """The joints that are contacts of its partners already; of an impact that is over whatever joins them."""
        same = [j for j in self.joints if frozenset(_partners(j)) == frozenset(_partners(impact))]
        if impact.name not in over:
            return [j for j in same if any(m.parted for m in self.modes[j.name])]
        others = [j for j in self.impacts if j.name not in over]
        return same + [j for j in others if frozenset(_partners(j)) == frozenset(_partners(impact))]

    def _is_there(self, joint: Joint, gap: Gap) -> bool:
        """Does a joint of both partners hold them where they would touch? A face holds all its corners."""
        face = any(m.name == "tip" for m in self.modes.get(joint.name, ()))
        return face or not at_another_corner(self.scene, gap.point, joint)

    def gap(self, joint: Joint, mode: Mode) -> Term:
        """How far apart the partners are."""
        return joint.distance if isinstance(joint, Encounter) else super().gap(joint, mode)

    def _measured(self, indices: Mapping[str, int]) -> tuple[Measured, ...]:
        """Of a face that is apart both ends are watched. What an impact that is over drove apart must not meet."""
        again = {e.name for e in self.over if not e.plastic}
        faces = {j.name: ends for j in self.joints if len(ends := self.ends(j)) > 1}
        found: list[Measured] = []
        for measured in super()._measured(indices):
            if measured.guard.kind == "gap" and measured.guard.joint in faces:
                found += [replace(measured, state=end.gap) for end in faces[measured.guard.joint]]
            elif measured.guard.kind == "gap" and measured.guard.joint in again:
                found.append(replace(measured, guard=replace(measured.guard, kind=AGAIN)))
            else:
                found.append(measured)
        return tuple(replace(m, guard=replace(m.guard, index=i)) for i, m in enumerate(found))

    def ends(self, joint: Joint) -> list[End]:
        """The ends of a face; none where the joint has no face that may tip."""
        found: dict[tuple[float, float], list[int]] = {}
        modes, graph = self.modes[joint.name], self.graph
        for i, mode in enumerate(modes):
            if mode.name == "tip":
                point = mode.facts.pushes[0].actions[0].point
                found.setdefault((graph.of(point.x).value, graph.of(point.y).value), []).append(i)
        return [self._end(modes[tipping[0]], tuple(tipping)) for tipping in found.values()]

    def _end(self, mode: Mode, tipping: tuple[int, ...]) -> End:
        push = next(p for p in mode.facts.pushes if p.kind == "normal")
        mover, base = push.actions
        assert mover.force is not None
        drawn = Vec(*(self.graph.number(self.graph.of(c).value) for c in (mover.point.x, mover.point.y)))
        beneath = self.scene.carried_from(base.body, drawn)
        return End(self.graph.of((mover.point - beneath).dot(mover.force)), tipping)

    def _carried(self, mode: Mode) -> Mode:
        """A face that tips, with its corner going with the body however far it has turned."""
        push = mode.facts.pushes[0].actions[0]
        drawn = Vec(*(self.graph.number(self.graph.of(c).value) for c in (push.point.x, push.point.y)))
        corner = self.scene.carried_from(push.body, drawn)

        def row(of: Row) -> Row:
            pulls = tuple(replace(p, anchor=replace(p.anchor, point=corner)) for p in of.pulls)
            return replace(of, pulls=pulls)

        pushes = tuple(
            replace(p, actions=tuple(replace(a, point=corner) for a in p.actions)) for p in mode.facts.pushes
        )
        tests = tuple(replace(t, row=row(t.row)) if t.row is not None else t for t in mode.tests)
        sliding = None if mode.sliding is None else row(mode.sliding)
        return replace(mode, facts=replace(mode.facts, pushes=pushes), tests=tests, sliding=sliding)

    def _hold(self, joint: Joint, mode: Mode) -> Held:
        held = super()._hold(joint, mode)
        if self._takes_hold(joint):
            # It holds its partners where they are then, not where they are drawn.
            return replace(held, constraints=tuple(replace(c, place=None) for c in held.constraints))
        if not self._sticks(joint, mode):
            return held
        sliding = self._sliding_mode(joint, mode)
        if sliding is None:
            return replace(held, constraints=self._together(joint, mode))
        return replace(held, constraints=self._sticking(joint, mode, sliding))

    def _takes_hold(self, joint: Joint) -> bool:
        """Does it act only from a later state than the first on?"""
        return not self.scene.problem.holds_at_first(joint.during)

    def _sticks(self, joint: Joint, mode: Mode) -> bool:
        """Does it hold what slides in another mode?"""
        others = self.modes[joint.name]
        slides = any(m.direction or m.facts.skids for m in others)
        return slides and not mode.direction and not mode.facts.skids and not mode.parted and mode.sliding is not None

    def _together(self, joint: Joint, mode: Mode) -> tuple[Constraint, ...]:
        """Bodies that move as one from where they are."""
        graph, scene = self.graph, self.scene
        found: list[Constraint] = []
        for joining in mode.facts.joinings:
            apart = scene.velocity(joining.point, joining.mover) - scene.velocity(joining.point, joining.base)
            terms = [graph.of(apart.x), graph.of(apart.y)]
            if not joining.turns and scene.rigid(joining.mover):
                terms.append(graph.of(scene.turn(joining.mover) - scene.turn(joining.base)))
            found += [replace(of_velocities(self.layout, mode.words, t), joint=joint.name) for t in terms]
        return tuple(found)

    def _sliding_mode(self, joint: Joint, mode: Mode) -> Mode | None:
        """The mode in which it slides that sticks in this one, at the same place."""
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


def _partners(joint: Joint) -> tuple[str, ...]:
    found: tuple[str, ...] = getattr(joint, "between", ())
    return found
