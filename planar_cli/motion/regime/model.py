"""The fast model of one scene: its state, its choices of modes, and for every choice a regime, made when asked for."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cached_property

from planar_cli.integrators.base import Step
from planar_cli.joints.base import Joint, distinct
from planar_cli.loads.base import Load, mode_key
from planar_cli.motion.regime.guards import Guard, Measured, Watch, speed_of
from planar_cli.motion.regime.held import Held
from planar_cli.motion.regime.regime import Parts, Regime
from planar_cli.motion.regime.stops import MOVES
from planar_cli.motion.scene.drives import asked_of, drives_of
from planar_cli.motion.scene.scene import MovingScene
from planar_cli.motion.terms.constraints import Constraint, coefficients, of_places
from planar_cli.motion.terms.layout import Frame, Layout, Slot
from planar_cli.motion.terms.rank import Independent, independent
from planar_cli.motion.terms.scales import Scales, scales_of
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term, evaluate
from planar_cli.problem.scene.facts import Facts, Mode, Skid, Wrench
from planar_cli.problem.scene.geometry import Vec
from planar_cli.problem.scene.ordinary import scales_of as ordinary
from planar_cli.problem.scene.residuals import Residual
from planar_cli.problem.scene.scene import GROUND

Choice = tuple[int, ...]
"""For every joint (and load) of `Model.choices`, in its order, the index of its mode."""
Member = Joint | Load
DIRECTED = 8
"""A step is cut at least into so many parts where directions count their turns."""
MANY = 100.0
"""Where bodies turn further than that in a step [rad], it is looked up how far the angles that are counted do."""
MOST_TURNED = 1e5
"""Of a step that turns a body further than that [rad] turns are no longer counted one by one."""
STILL = 1e-12
"""A resistance that is below this part of the force scale at rest vanishes there."""
NO_SPEED = 1e-10
"""A speed below this part of the scale is rounding."""
ANYWHERE = (0.6, 0.8)
"""From where a particle is sought whose place is open, in parts of the scene's extent: no special place."""


def always(member: Member) -> bool:
    """Does a joint or load act at all times?"""
    return member.during is None


class Model:
    """One scene."""

    def __init__(self, scene: MovingScene, acts: Callable[[Member], bool] = always) -> None:
        """`acts`: which joints and loads there are; others act between other states."""
        self.scene = scene
        self.graph = scene.graph
        self.layout = layout_of(scene)
        self.skids = scene.skids(self.layout)
        self.joints = [j for j in distinct(scene.problem.joints) if acts(j)]
        self.loads = [x for x in scene.loads() if acts(x) and not x.strikes]
        self.modes: dict[str, tuple[Mode, ...]] = {j.name: j.modes(scene) for j in self.joints}
        self.ways = {x: found for x in self.loads if (found := x.modes(scene))}
        """The modes of the loads that have several."""
        self.modes |= {mode_key(x.name): found for x, found in self.ways.items()}
        self.choices: dict[str, tuple[Mode, ...]] = {n: m for n, m in self.modes.items() if len(m) > 1}
        """The modes of every joint and load that has several, the natural one first."""
        self.wrenches: dict[Load, tuple[Wrench, ...]] = {x: x.wrenches(scene) for x in self.loads}
        self.asked = asked_of(scene, self.layout)
        ties = tuple(of_places(self.layout, "", tie.title, tie.residual) for tie in scene.ties)
        self.drives = (*drives_of(scene, self.asked), *ties)
        """What the file prescribes, and what keeps points where they are written."""
        self.scales = self._scales()
        self.skids.least = NO_SPEED * self.scales.speed
        self.drives = (*self.drives[: -len(ties) or None], *self._beside_joints(ties))
        self._regimes: dict[Choice, Regime] = {}
        self._held: dict[tuple[str, int], Held] = {}
        self._independent: dict[tuple[str, ...], Independent] = {}
        self._turnings: Code | None = None
        self._turned = 0
        self._quick: dict[tuple[Term, ...], Code] = {}
        """The rates of the angles that are counted."""

    # --- what a motion asks ------------------------------------------------------------------------------------------

    @property
    def natural(self) -> Choice:
        """Every joint in its natural mode."""
        return (0,) * len(self.choices)

    @property
    def reference(self) -> tuple[float, list[float]]:
        """Time and state as drawn, at rest."""
        return self.layout.time.value, [*self.layout.drawn, *(v.value for v in self.layout.speeds)]

    @property
    def scale(self) -> list[float]:
        """The size of a usual value of each number of the state."""
        lengths = [1.0 if s.kind == "theta" else self.scales.length for s in self.layout.slots]
        return [*lengths, *(size / self.scales.time for size in lengths)]

    @property
    def time_scale(self) -> float:
        """The time in which things change [s]."""
        return self.scales.time

    def regime(self, choice: Choice | None = None) -> Regime:
        """The regime of a choice; None: the natural one."""
        choice = self.natural if choice is None else choice
        if choice not in self._regimes:
            self._regimes[choice] = self._made(choice)
        return self._regimes[choice]

    def note(self, t: float, y: Sequence[float], step: Step | None = None) -> None:
        """Angles that go on over many turns and directions of sliding count from this state; along a `step` from it,
        turns are counted.
        """
        for name, angle in self._angles(t, y):
            self.graph.turnings[name].note(t, angle)
        if step is not None:
            self.wind(self.between(step))
        self.skids.note(t, y)
        self.scene.facings.note(self.layout.state, self.layout.time, t, y)

    def wind(self, way: Iterable[tuple[float, Sequence[float]]]) -> None:
        """Note turns on a way alone; the others still count from where they did."""
        turnings = self.graph.turnings
        last = {name: turning.last for name, turning in turnings.items()}
        for t, y in way if last else ():
            for name, angle in self._angles(t, y):
                turnings[name].note(t, angle)
        for name, angle in last.items():
            turnings[name].last = angle

    def recall(self, t: float) -> None:
        """Turns count from what was noted before a time of the way [s]."""
        for turning in self.graph.turnings.values():
            turning.recall(t)

    def between(self, step: Step) -> Iterator[tuple[float, Sequence[float]]]:
        """Times and states of a step, its end last, so close that nothing turns further than a radian in between."""
        # A direction from place to place may turn further than any body does.
        pieces = max(self.pieces(step), DIRECTED if self.graph.turned else 1)
        for k in range(1, pieces):
            t = step.t0 + (step.t1 - step.t0) * k / pieces
            yield t, step.at(t)
        yield step.t1, step.y1

    @cached_property
    def _turns(self) -> list[int]:
        """Where the rates of angles stand in the state."""
        return [self.layout.count + i for i, slot in enumerate(self.layout.slots) if slot.kind == "theta"]

    def pieces(self, step: Step) -> int:
        """In how many parts no body turns further than a radian."""
        turns = self._turns
        fastest = max((max(abs(step.y0[i]), abs(step.y1[i])) for i in turns), default=0.0)
        turned = fastest * abs(step.t1 - step.t0)
        if turned > MANY and self.graph.turned:
            turned = min(turned, self._angles_turn(step))
        return 1 + int(min(turned, MOST_TURNED))

    def _angles_turn(self, step: Step) -> float:
        """About how far the angle that turns most goes in a step: a body may turn fast, and no angle with it."""
        turned = tuple(self.graph.turned.values())
        if turned not in self._quick:
            rates = self.graph.rates(turned, self.layout.rates())
            self._quick[turned] = compiled(rates, self.layout.state, self.layout.time)
        length = step.t1 - step.t0
        times = [step.t0 + length * k / DIRECTED for k in range(DIRECTED + 1)]
        try:
            rates_there = [rate for t in times for rate in self._quick[turned].function(t, step.at(t))]
        except ZeroDivisionError:
            # A place comes through the one from which it is seen.
            return math.inf
        return abs(length) * max(map(abs, rates_there))

    def _angles(self, t: float, y: Sequence[float]) -> Iterable[tuple[str, float]]:
        """The angles that go on over many turns, by their names in the code."""
        turned = self.graph.turned
        if not turned:
            return ()
        if self._turnings is None or self._turned < len(turned):
            self._turnings = compiled(list(turned.values()), self.layout.state, self.layout.time)
            self._turned = len(turned)
        return zip(turned, self._turnings.function(t, y), strict=True)

    def begin(self) -> None:
        """Forget what was noted: a motion begins anew."""
        self.scene.facings.begin()
        for turning in self.graph.turnings.values():
            turning.begin()
        self.skids.forget()

    # --- making a regime ---------------------------------------------------------------------------------------------

    def chosen(self, choice: Choice) -> dict[str, int]:
        """The index of the mode of every joint and load that has modes."""
        return dict.fromkeys(self.modes, 0) | dict(zip(self.choices, choice, strict=True))

    def choice_of(self, names: Mapping[str, str]) -> Choice:
        """The choice in which joints have the modes of these names; the natural one where none is named."""
        found = []
        for joint, modes in self.choices.items():
            found.append(next((i for i, m in enumerate(modes) if m.name == names.get(joint)), 0))
        return tuple(found)

    def _made(self, choice: Choice) -> Regime:
        indices = self.chosen(choice)
        held = tuple(self.held(j, indices[j.name]) for j in self.joints)
        idle = {key for name, i in indices.items() for key in self.modes[name][i].facts.idle}
        # A weight is called by its body, as a load of the file may be.
        acting = [x for x in self.loads if x not in self.ways or mode_key(x.name) not in idle]
        potential, stored = self.graph.number(0.0), []
        for load in acting:
            # The weight m g of what grows as it rises is no slope of m g y.
            grows = any(w.body in self.scene.placed for w in self.wrenches[load])
            part = None if grows else load.potential(self.scene)
            if part is not None:
                potential = potential + part
                stored.append(load)
        growing = self.scene.growing()
        wasting = [*(w for x in acting if x not in stored for w in self.wrenches[x]), *growing]
        wrenches = (*(w for x in acting for w in self.wrenches[x]), *growing)
        # What joints hold counts them among its own loads.
        skids = [w for h in held for skid in h.mode.facts.skids for w in self.skids.wrenches(skid)]
        return Regime(
            Parts(
                layout=self.layout,
                scales=self.scales,
                held=held,
                drives=self.drives,
                wrenches=(*wrenches, *skids),
                loads=self.layout.of_actions(wrenches),
                wasting=self.layout.of_actions(wasting),
                potential=potential,
                acting=tuple(acting),
                measured=self._measured(indices),
                independent=self._rank(held),
            )
        )

    def held(self, joint: Joint, index: int) -> Held:
        """A joint in one of its modes."""
        key = (joint.name, index)
        if key not in self._held:
            self._held[key] = self._hold(joint, self.modes[joint.name][index])
        return self._held[key]

    def _hold(self, joint: Joint, mode: Mode) -> Held:
        layout, graph = self.layout, self.graph
        constraints = tuple(of_places(layout, joint.name, title, place) for title, place in self.places(joint, mode))
        loads: dict[int, Term] = {}
        for skid in mode.facts.skids:
            for i, t in self.skids.loads(skid).items():
                loads[i] = loads[i] + t if i in loads else t
        columns = {p.name: layout.of_actions(p.actions) for p in mode.facts.pushes}
        followers = {law.push: (graph.of(law.factor), law.of) for law in mode.facts.laws}
        presumed = tuple(self._scalars(joint.presumes(self.scene, mode)))
        return Held(joint.name, mode, constraints, mode.facts.pushes, columns, followers, loads, presumed)

    def places(self, joint: Joint, mode: Mode) -> list[tuple[str, Term]]:
        """The position residuals of a joint in one of its modes, scalar by scalar."""
        return self._scalars(joint.residuals(self.scene, mode))

    def _scalars(self, residuals: Iterable[Residual]) -> list[tuple[str, Term]]:
        """The residuals that vary, scalar by scalar, with their titles."""
        found = []
        for residual in residuals:
            value = residual.of(self.scene.poses)
            parts = (value.x, value.y) if isinstance(value, Vec) else (value,)
            found += [(residual.title, self.graph.of(p)) for p in parts]
        return [(title, p) for title, p in found if not p.constant]

    def _rank(self, held: Sequence[Held]) -> Independent:
        """Which constraints say something new, in any position but singular ones."""
        key = tuple(f"{h.joint} {self.modes[h.joint].index(h.mode)}" for h in held)
        if key not in self._independent:
            constraints: list[Constraint] = [c for h in held for c in h.constraints]
            self._independent[key] = independent(self.layout, [*constraints, *self.drives], self.scales)
        return self._independent[key]

    # --- conditions --------------------------------------------------------------------------------------------------

    def _measured(self, indices: Mapping[str, int]) -> tuple[Measured, ...]:
        found: list[Measured] = []
        joints = {j.name: j for j in self.joints}
        for name, index in indices.items():
            mode, joint = self.modes[name][index], joints.get(name)
            if len(self.modes[name]) == 1 and mode.facts == Facts():
                continue
            gap = self.gap(joint, mode) if joint is not None and mode.parted else None
            speeds = tuple(self.skids.speed(s) for s in mode.facts.skids)
            found += Watch(self.layout, self.scales, self.scene, name, mode, speeds, gap).measured()
        found += self._masses()
        found += self._resistances()
        return tuple(replace(m, guard=replace(m.guard, index=i)) for i, m in enumerate(found))

    def _masses(self) -> list[Measured]:
        """Masses that vary stay positive."""
        found = []
        for name, place in self.scene.places.items():
            if not place.mass.constant:
                guard = Guard(name, "mass", f"{name} has mass", True, self.scales.mass, 0)
                found.append(Measured(guard, place.mass))
        return found

    def _resistances(self) -> list[Measured]:
        """Bodies go on moving against loads that oppose the velocity and do not vanish with it: at rest they are none,
        and just before as large as ever. What moves in a way that is prescribed goes through rest all the same.
        """
        found: list[Measured] = []
        held = [*self.drives, *(c for j in self.joints for c in self.held(j, 0).constraints)] if self.drives else []
        if held and len(independent(self.layout, held, self.scales).kept) == self.layout.count:
            return found
        still = dict.fromkeys(self.layout.speeds, 0.0)
        for load, wrenches in self.wrenches.items():
            for w in wrenches if load.opposes else ():
                (size,) = evaluate([self.graph.of(w.magnitude)], still)
                if not abs(size) <= STILL * self.scales.force:
                    speed = self.skids.speed(Skid(load.name, w.body, GROUND, w.point, w.magnitude))
                    words = f"{w.body} moves against {load.name}, which does not vanish at rest"
                    found.append(Measured(Guard(load.name, MOVES, words, False, self.scales.speed, 0), speed))
        return found

    def gap(self, joint: Joint, mode: Mode) -> Term:
        """How far apart the partners of a contact are, how slack a rope is [m]; > 0 where the mode is as it says."""
        test = mode.tests[0]
        if test.row is None:
            pressing = next(m for m in self.modes[joint.name] if m.name != "stick" and not m.parted)
            normal = next(p for p in pressing.facts.pushes if p.kind == "normal")
            measured = self.layout.of_actions(normal.actions)
        else:
            pressing = self.modes[joint.name][0]
            speed = speed_of(self.graph, self.scene, test.row) * test.sense
            measured = coefficients(speed, {s.rate: i for i, s in enumerate(self.layout.slots)}, self.layout)
        _, place = self.places(joint, pressing)[0]
        # The residual grows with the gap, or shrinks.
        slopes = of_places(self.layout, joint.name, "", place).row
        same = sum(t.value * measured[i].value for i, t in slopes.items() if i in measured)
        return place if same > 0 else -place

    # --- the whole ---------------------------------------------------------------------------------------------------

    def _beside_joints(self, ties: Sequence[Constraint]) -> list[Constraint]:
        """Of what keeps points where they are written: what no joint says.

        Where a joint keeps a point on its line, the line ends when the joint lets go of it.
        """
        said: list[Constraint] = []
        for joint in self.joints if ties else ():
            modes = self.modes[joint.name]
            loosest = next((m for m in modes if m.name not in ("stick", "tip") and not m.parted), modes[0])
            said += [of_places(self.layout, joint.name, *place) for place in self.places(joint, loosest)]
        kept = independent(self.layout, [*said, *ties], self.scales).kept
        return [ties[k - len(said)] for k in kept if k >= len(said)]

    def _demanded(self, drive: Constraint, demand: Term) -> float:
        """The speed [m/s] or acceleration [m/s²] that a drive demands as drawn, at rest."""
        slopes = [
            abs(t.value) * (1.0 if self.layout.slots[i].kind != "theta" else 1.0 / self.scene.extent)
            for i, t in drive.row.items()
        ]
        largest, moving = max(slopes, default=0.0), abs(demand.value)
        return moving / largest if largest > 0 and math.isfinite(moving) else 0.0

    def _scales(self) -> Scales:
        masses = [p.mass.value for p in self.scene.places.values()]
        heaviest = max(masses, default=0.0)
        accelerations = [abs(self.scene.gravity.value)]
        for wrenches in self.wrenches.values():
            for wrench in wrenches:
                if wrench.force is not None and wrench.body != GROUND and heaviest > 0:
                    x, y = self.graph.of(wrench.force.x).value, self.graph.of(wrench.force.y).value
                    accelerations += [abs(v) / heaviest for v in (x, y) if abs(v) > 0]
        accelerations += [self._demanded(drive, drive.rest) for drive in self.drives if drive.rate is None]
        speeds = [self._demanded(drive, drive.moving) for drive in self.drives]
        return scales_of(self.scene.extent, masses, accelerations, speeds, ordinary(self.scene.problem).time)


def layout_of(scene: MovingScene) -> Layout:
    """All bodies in the order of the file, then the coordinates of the file that are variables of their own."""
    slots: list[Slot] = []
    frames: dict[str, Frame] = {}
    for name, place in scene.places.items():
        first = len(slots)
        slots.append(Slot(place.x, place.vx, place.mass, name, "x"))
        slots.append(Slot(place.y, place.vy, place.mass, name, "y"))
        if place.theta is not None and place.omega is not None:
            slots.append(Slot(place.theta, place.omega, place.inertia, name, "theta"))
        frames[name] = Frame(first, first + 1, first + 2 if place.theta is not None else None)
    zero = scene.graph.number(0.0)
    slots += [Slot(q, v, zero, "", "coordinate") for q, v in scene.own_variables.values()]
    drawn = [s.coordinate.value for s in slots]
    for name in scene.reference.open & frames.keys():
        drawn[frames[name].x] += ANYWHERE[0] * scene.extent
        drawn[frames[name].y] += ANYWHERE[1] * scene.extent
    return Layout(scene.graph, scene.time, tuple(slots), frames, scene.arm, tuple(drawn))
