"""A scene at the moment of an impact: what holds, what touches, and which impulses they may give, from its model.

Every contact and rope gives the directions along which it presses, pulls and rubs; a face that may tip gives those of
its two ends. Joints without such freedom, and what the file prescribes, hold. Friction of a fixed size, weights and
springs have no impulse.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field, replace

from planar_cli.errors import NOWHERE, Diagnostic, NoSolution, Undecided
from planar_cli.integrators.base import OUTSIDE
from planar_cli.joints.base import Joint
from planar_cli.motion.regime.hybrid import HybridModel
from planar_cli.motion.scene.encounters import Encounter, at_another_corner, friction_of, restitution_of
from planar_cli.motion.start.start import fixed
from planar_cli.motion.terms.constraints import Constraint
from planar_cli.motion.terms.layout import Column
from planar_cli.motion.terms.source import Code, compiled
from planar_cli.motion.terms.terms import Term
from planar_cli.motion.trajectory.automaton import Choice
from planar_cli.motion.trajectory.impact import Bond, Struck, StruckContact
from planar_cli.problem.scene.facts import Mode, Push
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import changing, record

NEAR = 1e-9
"""Partners closer than this part of the scene's length touch."""
MEETING = 1e-8
"""And closer than this part they do so at one place, as far as a motion that was followed tells."""


@record
class Direction:
    """One place at which a joint presses or pulls in an impact."""

    joint: str
    name: str
    """What the file calls it."""
    normal: Column
    """The generalized force of a unit of its impulse; times the velocities the speed of separation."""
    tangent: Column | None
    """The same across it; None where it is smooth."""
    belt: Term
    """The part of the sliding that does not come from the state's velocities [m/s]."""
    mu: Term
    """The coefficient of friction of the impact."""
    restitution: Term
    """e."""
    gap: Term | None
    """How far the partners are apart [m]; None: they always touch."""
    holding: frozenset[int]
    """The modes of the joint, by index, in which they touch."""
    forced: bool = False
    """Does it strike whatever the distance, between the states that the file names, where it is the nearest?"""
    meets: bool = False
    """Is it one of the file's impacts?"""
    inner: bool = False
    """Do bodies exert it on each other alone?"""
    loose: bool = False
    """Is one partner a particle, which may be drawn beside what it strikes, and does nothing tell how far?"""
    facing: str = ""
    """Of two points that are drawn as one: the name of that which notes on which side of each other they are."""


@changing
class Strikes:
    """Impacts of one model."""

    model: HybridModel
    directions: tuple[Direction, ...]
    mutual: frozenset[str]
    """The joints that bodies exert on each other alone, where they are drawn."""
    _codes: dict[Choice, Code] = field(default_factory=dict)

    def at(
        self,
        choice: Choice,
        t: float,
        y: Sequence[float],
        near: float,
        forced: bool = False,
        drawn: bool = False,
    ) -> Struck:
        """The scene at this moment. `near`: partners closer than this part of its length touch. `forced`: between
        states that the file names. `drawn`: no motion led there, and nothing but impacts makes it a blow; where none of
        them touches, particles are only drawn apart.
        """
        layout = self.model.layout
        bonds = self._bonds(choice)
        if choice not in self._codes:
            self._codes[choice] = compiled(self._terms(bonds), layout.state, layout.time)
        try:
            numbers = iter(self._codes[choice].function(t, y))
        except OUTSIDE:
            raise self._undirected(t, y) from None
        masses = tuple(next(numbers) for _ in layout.slots)
        velocities = tuple(y[layout.count :])
        made = []
        for constraint in bonds:
            row = self._row(numbers, constraint.row)
            rate = next(numbers)
            if constraint.rate is None:
                rate = sum(a * v for a, v in zip(row, velocities, strict=True))
            made.append(Bond(constraint.joint, row, rate, inner=constraint.joint in self.mutual))
        indices = self.model.chosen(choice)
        contacts: list[StruckContact] = []
        beside: list[StruckContact] = []
        meet = False
        scale = self.model.scales.length
        read = [(d, *self._read(d, numbers)) for d in self.directions]
        nearest: dict[str, float] = {}
        for d, *_, gap in read:
            nearest[d.name] = min(gap / scale, nearest.get(d.name, gap / scale))
        for d, normal, tangent, belt, mu, restitution, gap in read:
            apart = gap / scale
            reach = max(NEAR, near)
            touches = apart <= reach + (nearest[d.name] if d.forced and forced else 0.0)
            # What strikes from afar, as the file has it, has no place at which both sides would act.
            inner = d.inner and apart <= MEETING
            towards = self._turned(d, normal, velocities) if touches and d.facing else normal
            contact = StruckContact(d.name, towards, 0.0, tangent, belt, restitution, mu, inner)
            if indices.get(d.joint, 0) in d.holding or touches:
                contacts.append(contact)
                meet = meet or d.meets
            elif d.loose:
                beside.append(contact)
        if drawn and not meet:
            contacts += beside
        speeds = tuple(self.model.scale[layout.count :])
        frames = tuple((f.x, f.y, f.theta) for f in layout.frames.values())
        places = tuple((y[f.x], y[f.y]) for f in layout.frames.values())
        return Struck(velocities, masses, speeds, tuple(made), tuple(contacts), frames=frames, places=places)

    def _turned(self, d: Direction, normal: tuple[float, ...], velocities: Sequence[float]) -> tuple[float, ...]:
        """The normal of two points that are drawn as one: from the side from which they approach."""
        rate = sum(a * v for a, v in zip(normal, velocities, strict=True))
        return tuple(-x for x in normal) if self.model.scene.facings.parts(d.facing, rate) else normal

    def _undirected(self, t: float, y: Sequence[float]) -> NoSolution | Undecided:
        """What to say where the line has no direction along which two partners would strike each other."""
        layout = self.model.layout
        for d in self.directions:
            try:
                compiled([*d.normal.values()], layout.state, layout.time).function(t, y)
            except OUTSIDE:
                text = (
                    f"{d.name}: both partners have one centre at t = {t:.6g} s; in which direction they strike is open"
                )
                mark = next((j.mark for j in self.model.scene.problem.joints if j.name == d.name), NOWHERE)
                return NoSolution([Diagnostic(mark, "PL528", text, "draw them apart, or write `normal: 0 deg`")])
        return Undecided(f"at t = {t:.6g} s what would act in a blow has no value")

    def _read(
        self, d: Direction, numbers: Iterator[float]
    ) -> tuple[tuple[float, ...], tuple[float, ...] | None, float, float, float, float]:
        """In numbers: along and across, sliding, friction, restitution, and how far the partners are apart [m]."""
        normal = self._row(numbers, d.normal)
        tangent = None if d.tangent is None else self._row(numbers, d.tangent)
        belt, mu, restitution = next(numbers), next(numbers), next(numbers)
        return normal, tangent, belt, mu, restitution, 0.0 if d.gap is None else abs(next(numbers))

    def _row(self, numbers: Iterable[float], column: Column) -> tuple[float, ...]:
        row = [0.0] * self.model.layout.count
        for i, x in zip(column, numbers, strict=False):
            row[i] = x
        return tuple(row)

    def _bonds(self, choice: Choice) -> list[Constraint]:
        """What holds on both sides."""
        model, indices = self.model, self.model.chosen(choice)
        pressing = {d.joint for d in self.directions}
        found: list[Constraint] = []
        for joint in model.joints:
            if joint.name in pressing:
                continue
            modes = model.modes[joint.name]
            # Finite friction gives way in an impact.
            index = next((i for i, m in enumerate(modes) if m.name == "slip"), indices[joint.name])
            found += model.held(joint, index).constraints
        return [*found, *model.drives]

    def _terms(self, bonds: Iterable[Constraint]) -> list[Term]:
        found = [s.mass for s in self.model.layout.slots]
        for constraint in bonds:
            found += [*constraint.row.values(), constraint.moving]
        for d in self.directions:
            found += d.normal.values()
            found += [] if d.tangent is None else d.tangent.values()
            found += [d.belt, d.mu, d.restitution, *(() if d.gap is None else (d.gap,))]
        return found


def strikes_of(model: HybridModel) -> Strikes:
    """What presses, pulls and rubs in the impacts of a model."""
    found: list[Direction] = []
    for joint in model.joints:
        modes = model.modes[joint.name]
        if isinstance(joint, Encounter):
            found.append(_meeting(model, joint, modes))
        elif any(m.parted for m in modes):
            found += [_with_impact(model, joint, d) for d in _pressing(model, joint, modes)]
    facts = {j.name: [p for m in model.modes[j.name] for p in m.facts.pushes] for j in model.joints}
    aside = {j.name for j in model.joints if j.drawn_beside}
    mutual = (n for n, pushes in facts.items() if pushes and n not in aside and not any(map(_on_ground, pushes)))
    return Strikes(model, tuple(found), frozenset(mutual))


def _pressing(model: HybridModel, joint: Joint, modes: Sequence[Mode]) -> list[Direction]:
    """The directions of a contact or a rope."""
    parted = next(m for m in modes if m.parted)
    flat = [m for m in modes if not m.parted and m.name != "tip"]
    # What may be met from both sides presses either way, and touches in the modes of both.
    sides = [[m for m in flat if m.side == side] for side in dict.fromkeys(m.side for m in flat)]
    wholes = [_direction(model, joint, modes, pressing) for pressing in sides]
    touching = frozenset(i for whole in wholes for i in whole.holding)
    wholes = [replace(whole, gap=model.gap(joint, parted), holding=touching) for whole in wholes]
    ends = model.ends(joint)
    if not ends:
        return wholes
    flush = {i for i, m in enumerate(modes) if not m.parted and m.name != "tip"}
    found = []
    for end in ends:
        own = _direction(model, joint, modes, [modes[i] for i in end.tipping])
        found.append(replace(own, gap=end.gap, holding=frozenset({*end.tipping, *flush})))
    return found


def _meeting(model: HybridModel, joint: Encounter, modes: Sequence[Mode]) -> Direction:
    """The direction of an impact."""
    found = _direction(model, joint, modes, [m for m in modes if not m.parted])
    found = replace(found, name=joint.impact, gap=joint.distance, forced=joint.forced, meets=True)
    frames = [model.layout.frames.get(body) for body in (joint.gap.first, joint.gap.second)]
    loose = any(f is not None and f.theta is None for f in frames) and not fixed(model, joint.distance)
    # Two particles stand for bodies of any size, so that nothing tells where they touch.
    inner = found.inner and any(f is None or f.theta is not None for f in frames)
    found = replace(found, loose=loose, inner=inner, facing=joint.gap.facing)
    return replace(found, restitution=joint.restitution, mu=joint.mu)


def _with_impact(model: HybridModel, joint: Joint, direction: Direction) -> Direction:
    """A contact between the partners of an impact has its restitution, and its friction if that has one."""
    partners = set(getattr(joint, "between", ()))
    for impact in model.impacts:
        if partners and set(getattr(impact, "between", ())) == partners and not _elsewhere(model, impact, joint):
            restitution = restitution_of(model.scene, impact)
            found = replace(direction, restitution=restitution, forced=impact.during is not None, meets=True)
            mu = friction_of(model.scene, impact)
            return replace(found, mu=mu) if direction.tangent is not None and mu.value else found
    return direction


def _elsewhere(model: HybridModel, impact: Joint, contact: Joint) -> bool:
    """Does the file let them strike at another corner than that on which they stand?"""
    at = getattr(impact, "at", "")
    return bool(at) and at_another_corner(model.scene, model.scene.point(at), contact)


def _direction(model: HybridModel, joint: Joint, modes: Sequence[Mode], pressing: Sequence[Mode]) -> Direction:
    """Along the pushes of these modes."""
    graph, layout = model.graph, model.layout
    mode = pressing[0]

    def column(kinds: tuple[str, ...]) -> Column | None:
        push = next((p for p in mode.facts.pushes if p.kind in kinds), None)
        return None if push is None else layout.of_actions(push.actions)

    normal = column(("normal", "tension"))
    assert normal is not None, joint.name
    factors = [law.factor for m in modes for law in m.facts.laws if law.of is not None]
    mu = graph.of(factors[0]) if factors else graph.number(0.0)
    sliding = next((m.sliding for m in pressing if m.sliding is not None), None)
    belt = -graph.of(sliding.rate) if sliding is not None else graph.number(0.0)
    holding = frozenset(i for i, m in enumerate(modes) if m in pressing)
    tangent = column(("friction",)) if factors else None
    mu, zero = graph.call("abs", mu), graph.number(0.0)
    pushes = [p for m in pressing for p in m.facts.pushes]
    inner = not any(map(_on_ground, pushes))
    return Direction(joint.name, joint.name, normal, tangent, belt, mu, zero, None, holding, inner=inner)


def _on_ground(push: Push) -> bool:
    """Does a push act on the ground?"""
    return any(a.body == GROUND for a in push.actions)
