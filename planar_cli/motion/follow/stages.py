"""The scene of a problem file as a hybrid automaton, with what acts in it between which of its states."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence, Set
from functools import cached_property

from planar_cli.integrators.base import Step
from planar_cli.joints.base import Joint, distinct
from planar_cli.motion.follow.afterwards import begun_apart, drawn_apart, sliding_points
from planar_cli.motion.follow.corners import corner, normals, passing_over
from planar_cli.motion.follow.outside import outside_of
from planar_cli.motion.follow.struck import Strikes, strikes_of
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.regime.mode import Chooser, Chosen
from planar_cli.motion.regime.model import Member, Model
from planar_cli.motion.regime.regime import Regime
from planar_cli.motion.scene.gaps import Gap
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.start.equilibrium import in_equilibrium
from planar_cli.motion.start.start import given_of, start_of
from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.dense import null_space
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term, evaluate, ordered
from planar_cli.motion.trajectory.automaton import Choice, Corner, Outside, Start
from planar_cli.motion.trajectory.impact import Struck
from planar_cli.problem.checks.held_masses import while_flowing
from planar_cli.problem.language.expression import Law
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.order_of_states import struck_at_once
from planar_cli.problem.scene.scene import Problem

STILL = 1e-9
"""A body that misses the velocity of what it lies on by less than this part of the speeds sticks to it."""


class SceneAutomaton:
    """A model, asked as an automaton."""

    def __init__(self, model: HybridModel) -> None:
        self.model = model
        self.scale = model.scale
        self.time_scale = model.time_scale
        self.energy_scale = model.scales.energy
        self._outside: dict[Choice, Outside | None] = {}
        self._missed: dict[Choice, tuple[list[str], list[float], Code]] = {}

    @property
    def choices(self) -> Mapping[str, Sequence[Mode]]:
        """The modes of every joint and load that has several."""
        return self.model.choices

    @cached_property
    def strikes(self) -> Strikes:
        """What presses, pulls and rubs in an impact."""
        return strikes_of(self.model)

    @cached_property
    def autonomous(self) -> bool:
        """Does nothing in it depend on the time?"""
        model = self.model
        terms: list[Term] = [s.mass for s in model.layout.slots]
        for wrenches in model.wrenches.values():
            terms += model.layout.of_actions(wrenches).values()
        for joint in model.joints:
            for index in range(len(model.modes[joint.name])):
                for constraint in model.held(joint, index).constraints:
                    terms += _terms_of(constraint)
        for drive in model.drives:
            terms += _terms_of(drive)
        return model.layout.time not in set(ordered(terms))

    def regime(self, choice: Choice) -> Regime:
        """The regime of a choice."""
        return self.model.regime(choice)

    def misfits(self, choice: Choice, t: float, y: Sequence[float]) -> Mapping[str, float]:
        """By how much each joint is missed, in parts of lengths and speeds."""
        if choice not in self._missed:
            self._missed[choice] = self._misses(choice)
        joints, sizes, code = self._missed[choice]
        found: dict[str, float] = {}
        for joint, size, value in zip(joints, sizes, code.function(t, y), strict=True):
            found[joint] = max(found.get(joint, 0.0), abs(value) / size)
        return found

    def outside(self, choice: Choice) -> Outside | None:
        """What acts from outside in a choice."""
        if choice not in self._outside:
            self._outside[choice] = outside_of(self.model, self.regime(choice))
        return self._outside[choice]

    def undetermined(self, choice: Choice, t: float, y: Sequence[float]) -> tuple[str, ...]:
        """Bodies without mass that some motion moves which no constraint forbids and no mass resists.

        A round body that only spins so does nothing that matters, nor does one that may go one way, along which nothing
        drives it: a pulley between vertical parts of ropes stays where it is drawn.
        """
        model, indices = self.model, self.model.chosen(choice)
        layout = model.layout
        masses = [s.mass for s in layout.slots]
        if all(m.constant and m.value > 0.0 for m in masses):
            return ()
        held = [c for j in model.joints for c in model.held(j, indices[j.name]).constraints]
        constraints = [*held, *model.drives]
        terms = [*masses, *(x for c in constraints for x in c.row.values())]
        numbers = iter(compiled(terms, layout.state, layout.time).function(t, y))
        rows = [
            [m if i == k else 0.0 for k in range(layout.count)] for i, m in enumerate(next(numbers) for _ in masses)
        ]
        for constraint in constraints:
            row = [0.0] * layout.count
            for i in constraint.row:
                row[i] = next(numbers)
            rows.append(row)
        found: set[str] = set()
        for vector in null_space([r for r in rows if any(r)], layout.count):
            largest = max(map(abs, vector))
            moves = [s for s, v in zip(layout.slots, vector, strict=True) if abs(v) > 1e-9 * largest]
            if not any(s.kind in ("x", "y") for s in moves):
                continue
            if len(moves) > 1 or self._is_driven(vector, largest, choice, t, y):
                found |= {s.body for s in moves}
        return tuple(sorted(found))

    def _is_driven(self, way: Sequence[float], largest: float, choice: Choice, t: float, y: Sequence[float]) -> bool:
        """Does a load or a reaction drive along this way? `largest`: its largest part."""
        moved = {i for i, v in enumerate(way) if abs(v) > 1e-9 * largest}
        try:
            rows = self._driving(choice, t, y, moved)
        except ZeroDivisionError:
            # The ends of a spring coincide: it has no direction in this position, but drives in any other.
            return True
        return any(abs(sum(f * v for f, v in zip(row, way, strict=True))) > 1e-9 * largest for row in rows)

    def _driving(self, choice: Choice, t: float, y: Sequence[float], moved: Set[int]) -> list[list[float]]:
        """What loads and reactions drive, for each velocity, in parts of the largest; of those that drive `moved`."""
        model, indices = self.model, self.model.chosen(choice)
        layout = model.layout
        columns = [layout.of_actions(wrenches) for wrenches in model.wrenches.values()]
        for joint in model.joints:
            columns += [layout.of_actions(p.actions) for p in model.modes[joint.name][indices[joint.name]].facts.pushes]
        columns = [c for c in columns if not moved.isdisjoint(c)]
        numbers = iter(compiled([x for c in columns for x in c.values()], layout.state, layout.time).function(t, y))
        found: list[list[float]] = []
        for column in columns:
            row = [0.0] * layout.count
            for i in column:
                row[i] = next(numbers)
            largest = max(map(abs, row), default=0.0) or 1.0
            found.append([x / largest for x in row])
        return found

    def drawn_apart(self, t: float, y: Sequence[float], struck: Collection[str] = ()) -> tuple[str, str] | None:
        """The impact that leaves its partners at different places, and what is open then."""
        return drawn_apart(self.model, t, y, struck) if self.model.over or struck else None

    def sliding_points(self, choice: Choice, t: float, y: Sequence[float]) -> tuple[str, str] | None:
        """The impact that leaves points in contact that slide along each other, and what is open then."""
        return sliding_points(self.model, choice, t, y) if self.model.lasting else None

    def prepare(self, choice: Choice, t: float, y: Sequence[float]) -> None:
        """Friction of a fixed size that holds now has, at its limit, the direction that it has while it holds."""
        slidings = self.model.skids.slidings
        if not slidings or any(self.misfits(choice, t, y).get(j, 0.0) > STILL for j in slidings):
            return
        regime = self.model.regime(choice)
        pushes = list(zip(regime.reactions, regime.forces(t, y), strict=True))
        for joint in slidings:
            found = {p.name.rpartition("_")[2]: size for p, size in pushes if p.joint == joint and p.kind == "friction"}
            if found:
                self.model.skids.begins(t, joint, -found.get("x", 0.0), -found.get("y", 0.0))

    def note(self, t: float, y: Sequence[float], step: Step | None = None) -> None:
        """Angles that go on over many turns and directions of sliding count from this state."""
        self.model.note(t, y, step)

    def struck(
        self, choice: Choice, t: float, y: Sequence[float], near: float, forced: bool = False, drawn: bool = False
    ) -> Struck:
        """The scene at the moment of an impact."""
        return self.strikes.at(choice, t, y, near, forced, drawn)

    def _misses(self, choice: Choice) -> tuple[list[str], list[float], Code]:
        """Residuals of places and velocities, with their joints and sizes."""
        model, indices = self.model, self.model.chosen(choice)
        held = [c for j in model.joints for c in model.held(j, indices[j.name]).constraints]
        joints: list[str] = []
        sizes: list[float] = []
        terms: list[Term] = []
        for constraint in (*held, *model.drives):
            size = _size(model, constraint)
            if constraint.place is not None:
                joints.append(constraint.joint)
                sizes.append(size)
                terms.append(constraint.place)
            if constraint.rate is not None:
                joints.append(constraint.joint)
                sizes.append(size / model.scales.time)
                terms.append(constraint.rate)
        return joints, sizes, compiled(terms, model.layout.state, model.layout.time)


def _size(model: HybridModel, constraint: Constraint) -> float:
    """The usual size of a residual: that of its parts, each coordinate at its scale."""
    scale = model.scale
    return max((abs(t.value) * scale[i] for i, t in constraint.row.items()), default=1.0) or 1.0


def _terms_of(constraint: Constraint) -> list[Term]:
    return [t for t in (constraint.place, constraint.rate, constraint.rest) if t is not None]


class SceneStages:
    """A problem's scene at each stage of its schedule. What has no `during` acts always."""

    def __init__(self, scene: MovingScene) -> None:
        self.scene = scene
        self.passing: list[Member] = list(_passing([*distinct(scene.problem.joints), *scene.loads()]))
        """What acts between some states only."""
        self.laws: list[Law] = [law for law in scene.problem.motion if law.during is not None]
        """What `motion` prescribes between some states only."""
        bodies = scene.problem.bodies
        self.heavy = any(b.mass is not None or b.weight is not None or b.any_mass for b in bodies)
        """Has anything mass?"""
        self.before = [s.name for s in scene.problem.states if s.before]
        """Equilibria that lie before the motion: what acts from there on acts as it begins."""
        self._made: dict[tuple[tuple[bool, ...], tuple[str, ...]], SceneAutomaton] = {}
        for joint in (m for m in self.passing if isinstance(m, Joint) and m.unilateral and m.touches):
            # From which side something comes is noted on the way there.
            joint.modes(scene)

    def begin(self, t: float, y: Sequence[float]) -> None:
        """A motion begins anew: turns and directions of sliding count from this state."""
        for automaton in self._made.values():
            automaton.model.begin()
            automaton.model.skids.begun.clear()
            automaton.note(t, y)

    def automaton(self, reached: Sequence[str], striking: str = "") -> SceneAutomaton:
        """The scene once these states have been reached; `striking`: in the blow before this state, in which joints
        that begin with it take hold.
        """
        past = [m for m in self.passing if _strikes(m) and m.during is not None and m.during[1] in reached]
        # In a blow between two states those strike that the file names.
        absent, over = (past, ()) if striking else ([], tuple(m.name for m in past))
        acting = tuple(
            m not in absent and (self._acts(m, reached) or self._takes_hold(m, striking))
            for m in (*self.passing, *self.laws)
        )
        if (acting, over) not in self._made:
            members = zip((*self.passing, *self.laws), acting, strict=True)
            here = [m for m, acts in members if acts]
            idle = [m for m in self.passing if m not in here]
            laws = [law for law in self.laws if law in here]
            self._made[acting, over] = SceneAutomaton(HybridModel(self.scene, lambda m: m not in idle, laws, over))
        return self._made[acting, over]

    def start(self) -> Start:
        """Where the motion begins, by the first state or the instant of the file."""
        reached = () if struck_at_once(self.scene.problem.states) else (self._first(),)
        idle = self._idle(reached)
        model = Model(self.scene, lambda m: m not in idle)
        driven = [law.statement for law in self.laws if self._acts(law, reached)]
        found = start_of(model, (*given_of(model), *driven))
        return Start(found.time, found.state, None, found.assumed)

    def _first(self) -> str:
        """The first state's name."""
        states = self.scene.problem.states
        return states[0].name if states else ""

    def _idle(self, reached: Sequence[str]) -> list[Member]:
        return [m for m in self.passing if not self._acts(m, reached)]

    @staticmethod
    def _takes_hold(member: Member | Law, state: str) -> bool:
        """Is it a joint that acts from this state on, so that the blow before it makes it hold?"""
        lasts = isinstance(member, Joint) and not member.strikes
        return lasts and member.during is not None and member.during[0] == state

    def applied(self, after: str, t: float, y: Sequence[float]) -> Mapping[str, tuple[float, ...]]:
        """The impulses of the loads that strike before the state `after`."""
        loads = [x for x in self.scene.problem.loads if x.strikes and x.during is not None and x.during[1] == after]
        layout = self.automaton(()).model.layout
        found: dict[str, tuple[float, ...]] = {}
        for load in loads:
            column = layout.of_actions(load.impulses(self.scene))
            numbers = compiled(list(column.values()), layout.state, layout.time).function(t, y)
            total = list(found.get(load.name, (0.0,) * layout.count))
            for i, x in zip(column, numbers, strict=True):
                total[i] += x
            found[load.name] = tuple(total)
        return found

    def apart(self, reached: Sequence[str], t: float, y: Sequence[float]) -> tuple[str, str] | None:
        """A joint that begins with the last of these states and whose partners do not touch there, with words."""
        begun = [m for m in self.passing if isinstance(m, Joint) and m.touches and _begins(m, reached)]
        return begun_apart(self.automaton(reached).model, begun, t, y) if begun else None

    def corner(self, reached: Sequence[str], choice: Choice, t: float, y: Sequence[float]) -> Corner | None:
        """The corner at which the last of these states is reached; None: there is none."""
        lasting = [m for m in self.passing if isinstance(m, Joint) and not m.strikes and m.during is not None]
        begun = [j for j in lasting if _begins(j, reached)]
        ended = [j for j in lasting if j.during is not None and j.during[1] == reached[-1]]
        if not begun or not ended:
            return None
        before, model = self.automaton(reached[:-1]).model, self.automaton(reached).model
        names = passing_over(before, model, begun, ended)
        left = normals(before, [j for j in ended if j.guides])
        return corner(model, choice, names, left, t, y) if names else None

    def _acts(self, member: Member | Law, reached: Sequence[str]) -> bool:
        """Has the state been reached from which it acts, and not yet that until which it does? What has struck each
        other goes on from there: in contact, or apart.
        """
        if member.during is None:
            return True
        start, end = member.during
        if _strikes(member):
            return start in reached
        begun = start in reached or start in self.before
        # A law that ends with the last state is the last that is known of what has no mass.
        lasts = isinstance(member, Law) and not self.heavy and end == self.scene.problem.states[-1].name
        return begun and (lasts or end not in reached)


def stages_of(
    problem: Problem, values: Mapping[str, float], speeds: Mapping[str, tuple[float, float, float]]
) -> SceneStages:
    """The scene of a problem. Where the drawing leaves open on which side a body presses, it presses where it does at
    the start; once it has left that side it does not press on the other. What is drawn on a line comes from the side
    from which it moves. `values`: numbers for letters, by name; `speeds`: of bodies at the start, where the file leaves
    them open.
    """
    values = in_equilibrium(problem, values)
    problem = while_flowing(problem)
    scene = MovingScene(problem, values, speeds=speeds)
    stages = SceneStages(scene)
    automaton = stages.automaton((problem.states[0].name,) if problem.states else ())
    pressing = any(m.side for modes in automaton.choices.values() for m in modes)
    open_gaps = {j.name: gaps for j in distinct(problem.joints) if j.strikes and (gaps := _untold(scene.gaps(j)))}
    if not pressing and not open_gaps:
        return stages
    start = stages.start()
    automaton.note(start.t, start.y)
    sides: dict[str, int] = {}
    if pressing:
        found = Chooser(automaton, start.t, start.y).choose(automaton.model.natural)
        if isinstance(found, Chosen):
            chosen = zip(automaton.choices.items(), found.choice, strict=True)
            sides |= {name: modes[i].side for (name, modes), i in chosen if modes[i].side}
    at = automaton.model.layout.values(start.t, start.y)
    for name, gaps in open_gaps.items():
        if any(rate > 0 for rate in evaluate([scene.graph.rate(g.distance, scene.rates()) for g in gaps], at)):
            sides[name] = -1
    return SceneStages(MovingScene(problem, values, sides, speeds))


def _untold(gaps: Iterable[Gap]) -> list[Gap]:
    """Those that are closed as drawn, so that the drawing does not tell on which side the partners are."""
    return [g for g in gaps if not g.told and all(w.value >= 0 for w in g.within)]


def _strikes(member: Member | Law) -> bool:
    """Is it an impact?"""
    return isinstance(member, Joint) and member.strikes


def _begins(joint: Joint, reached: Sequence[str]) -> bool:
    """Does it act from the last of these states on?"""
    return joint.during is not None and joint.during[0] == reached[-1]


def _passing(members: Sequence[Member]) -> Iterator[Member]:
    """Those that act between some states only."""
    return (m for m in members if m.during is not None)
