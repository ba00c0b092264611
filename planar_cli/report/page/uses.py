"""On what a solution rests, read from its trace: the principles of a page, and what a lesson has to speak of.

Only what is told counts: of a motion the equations of its regimes on which an answer rests.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import Any

import sympy as sp

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.equation.system.one_body import inner_reactions
from planar_cli.problem.language.expression import Quantity
from planar_cli.problem.language.walk import walk
from planar_cli.problem.scene.facts import Mode
from planar_cli.problem.scene.scene import GROUND
from planar_cli.records import changing, record
from planar_cli.report.given.drawing_only import drawing_only
from planar_cli.report.instant.wanted import letters_asked
from planar_cli.report.kinematics.rope_lengths import drums
from planar_cli.report.kinetics.at_rest import balance
from planar_cli.report.words.characteristic import linear_method
from planar_cli.solve.between.trace.trace import BalanceTrace, ImpactEquation, MotionTrace, Relation, RouteTrace
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.instant.written import Written
from planar_cli.solve.law import ANOMALY, RELATIVE
from planar_cli.solve.passages import RATES
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution

MOVING = ("v", "a", "coriolis")
KEPLER = "Kepler's laws: under an attraction K m/r² energy and angular momentum are constant, the orbit is an ellipse."
OVER_TIME = "Integration over time."


@record
class Moments:
    """A sum of moments of some bodies: about which point, and what that is to the one body."""

    about: str
    bodies: tuple[str, ...]
    kind: str
    """centre: its mass centre; pivot: the fixed point about which it turns; else any other point."""


@changing
class Uses:
    """What one part, or a whole page, rests on."""

    relations: bool = False
    forces: bool = False
    at_balance: bool = False
    """Are all forces and moments those of bodies in equilibrium?"""
    welded: bool = False
    """Are bodies joined to one?"""
    inertial: bool = False
    """Are inertial forces drawn among the forces?"""
    streams: bool = False
    """Does a stream bring mass to a body, or take it?"""
    singles: set[str] = field(default_factory=set)
    """Equations of a whole scene, by their words."""
    at_rest: bool = False
    rolling: list[tuple[str, str, str]] = field(default_factory=list)
    """Mover, base and point of contact of what rolls."""
    sliding: list[tuple[str, str]] = field(default_factory=list)
    """Points that slide along a body that turns."""
    beside: bool = False
    """Is something asked relative to a body that moves?"""
    frames: list[str] = field(default_factory=list)
    """Bodies that turn, and relative to which something is asked."""
    left_out: list[tuple[str, str]] = field(default_factory=list)
    """Points whose relation leaves out an unknown, with that."""
    cords: list[str] = field(default_factory=list)
    wound: list[tuple[str, str]] = field(default_factory=list)
    """Cords that are wound on bodies, with these."""
    links: list[str] = field(default_factory=list)
    impulses: bool = False
    """Are impulses told by the momenta that they change?"""
    extreme: bool = False
    """Is something largest or smallest?"""
    at_limit: bool = False
    """Is something about to slip, to tip or to slacken?"""
    axles: bool = False
    """Does a body turn about a fixed pin?"""
    drawn: frozenset[str] = frozenset()
    """Lengths of the file that only place what is drawn."""
    asked: set[str] = field(default_factory=set)
    """The words of all that is asked: r, v, omega."""
    taut: set[str] = field(default_factory=set)
    """Of what kinds the joints are that pull: rope, belt, link."""
    moments: list[Moments] = field(default_factory=list)
    groups: list[tuple[str, ...]] = field(default_factory=list)
    """Several bodies whose forces are summed together."""
    sticking: list[str] = field(default_factory=list)
    slipping: list[str] = field(default_factory=list)
    """Contacts, by their joints."""
    together: int = 0
    """Most unknowns that follow from equations together."""
    energies: list[BalanceTrace] = field(default_factory=list)
    turning_energy: bool = False
    """Has one of these balances the kinetic energy of a rotation?"""
    momenta: list[BalanceTrace] = field(default_factory=list)
    blows: bool = False
    restitution: bool = False
    laws: set[str] = field(default_factory=set)
    """Kinds of integrals of laws, v(t), v(q), …; constant: of such an acceleration; steady: of such a speed."""
    over: set[str] = field(default_factory=set)
    """What integrals of laws that are not constant run over, in words."""
    constant: set[str] = field(default_factory=set)
    """The units of the coordinates whose speed or acceleration is constant."""
    passages: set[str] = field(default_factory=set)
    """What is told beside the equations, by the kinds of `solve.passages`."""
    kinetic_energy: bool = False
    """Is the kinetic energy of one instant asked?"""
    integrated: bool = False
    swings: bool = False

    @property
    def kinetic(self) -> bool:
        return self.forces or bool(self.singles)

    @property
    def coriolis(self) -> bool:
        return bool(self.sliding or self.frames)


def uses_of(parts: Iterable[PartSolution], why: str | None = None) -> Uses:
    """Of some parts together. `why`: the name of the find for which alone they are told; None: all are."""
    found = Uses()
    parts = tuple(parts)
    found.drawn = drawing_only(parts)
    for part in parts:
        if part.tale is None or not part.tale.whole:
            for instant in part.instants:
                if not instant.quiet:
                    _of_instant(found, instant, _stages(part, instant, why))
        else:
            found.relations = True
        if part.motion is not None:
            _of_motion(found, part.motion)
        if part.followed is not None:
            found.integrated = True
        found.passages |= {p.kind for p in part.tale.passages} if part.tale is not None else set()
        found.beside |= any(_refers(i) for i in part.instants)
        for answer in (f for f in part.found if why in (None, f.name)):
            found.kinetic_energy |= part.motion is None and answer.energy
            what = answer.find.found.what if answer.find is not None else None
            quantities = [n for n in walk(what) if isinstance(n, Quantity)] if what is not None else []
            found.asked |= {n.word for n in quantities}
            found.streams |= any(_is_stream(n, part) for n in quantities)
            if isinstance(what, Quantity) and what.word in MOVING:
                base = what.things[1] if len(what.things) == 2 else GROUND
                found.beside |= base != GROUND and any(_moves(i, base) for i in part.instants)
                _add(found.frames, base if any(_turns(i, base) for i in part.instants) else None)
    return found


def _is_stream(q: Quantity, part: PartSolution) -> bool:
    """Is it the force or the power of a stream?"""
    streams = {x.name for i in part.instants for x in i.trial.system.wrenches if x.kind == "stream"}
    return q.word in ("force", "power") and not streams.isdisjoint(q.things)


def _turns(instant: InstantSolution, body: str) -> bool:
    motion = instant.trial.system.motion
    return motion is not None and body in motion.velocities and motion.velocities[body].angular != 0


def _refers(instant: InstantSolution) -> bool:
    """Does the file give a velocity or an acceleration relative to something that moves?"""
    problem = instant.instant.scene.problem
    stated = [*(law.statement for law in problem.motion), *(problem.instant or ())]
    stated += [s for state in problem.states for s in state.relations]
    given = (n for s in stated for n in walk(s) if isinstance(n, Quantity) and n.word in MOVING)
    return any(len(q.things) == 2 and _moves(instant, q.things[1]) for q in given)


def _moves(instant: InstantSolution, base: str) -> bool:
    """Does a body, or a point, to which something refers move?"""
    scene, motion = instant.instant.scene, instant.trial.system.motion
    owner = base if base in scene.bodies else scene.owner(base)
    if owner == GROUND or motion is None:
        return False
    v = motion.velocity(scene.point(base), owner)
    return base == owner or v.x != 0 or v.y != 0


def _stages(part: PartSolution, instant: InstantSolution, why: str | None) -> tuple[Stage, ...]:
    wanted = letters_asked(part, why) if part.motion is None else part.motion.regime(instant).wanted
    return used_blocks(instant.stages, wanted)


def _of_instant(found: Uses, instant: InstantSolution, stages: tuple[Stage, ...]) -> None:
    written = [w for s in stages for b in s.blocks for w in b.equations if not w.given]
    system = instant.trial.system
    if any(w.law in ("force", "moment") for w in written):
        balanced = all(balance(system, s) for s in stages if s.level == "acceleration")
        found.at_balance = balanced and (found.at_balance or not found.forces)
        found.welded |= next(inner_reactions(system), None) is not None
    found.at_rest |= instant.instant.at_rest
    found.together = max([found.together, *(len(b.unknowns) for s in stages for b in s.blocks)])
    for w in written:
        found.extreme |= w.source == "extreme"
        found.at_limit |= w.source == "limit"
        if w.law == "relation":
            _of_relation(found, w)
        elif w.law == "single":
            found.singles.add(w.words)
        else:
            found.forces = True
            found.streams |= any(x.kind == "stream" and x.body in w.bodies for x in system.wrenches)
            found.inertial |= instant.instant.principle.inertia_as_force
            _add(found.groups, w.bodies if len(w.bodies) > 1 else None)
            if w.law == "moment":
                _add(found.moments, Moments(w.lead, w.bodies, _kind(instant, w)))
    for mode in system.modes.values():
        _of_joint(found, instant, mode)


def _of_joint(found: Uses, instant: InstantSolution, mode: Mode) -> None:
    motion = instant.trial.system.motion
    for j in mode.facts.joinings:
        found.axles |= j.path is None and j.rolling is None and j.base == GROUND and _turns(instant, j.mover)
        if j.rolling is not None:
            _add(found.rolling, (j.mover, j.base, j.place))
        if j.path is not None and motion is not None and not mode.facts.laws and _turns(instant, j.base):
            _add(found.sliding, (j.place, j.base) if motion.slide_speed(j) != 0 else None)
    joint = next((j.joint for j in mode.facts.joinings), "")
    rubs = mode.name == "stick" or (mode.name == "slip" and mode.facts.laws)
    if rubs and joint and found.forces:
        _add(found.sticking if mode.name == "stick" else found.slipping, joint)
    pulling = next((push.joint for push in mode.facts.pushes if push.kind == "tension"), None)
    if pulling is not None:
        _of_pulling(found, instant, pulling)


def _of_pulling(found: Uses, instant: InstantSolution, name: str) -> None:
    """What kind of joint pulls; of a cord on which body it is wound."""
    joint = next((j for j in instant.instant.scene.problem.joints if j.name == name), None)
    if joint is None:
        return
    found.taut.add(joint.kind)
    bodies = drums(joint)
    for body in bodies:
        _add(found.wound, (name, body))
    if not bodies:
        _add(found.links if joint.kind == "link" else found.cords, name)


def _of_relation(found: Uses, w: Written) -> None:
    found.relations = True
    if w.source in ("coordinate", "given") and w.place:
        found.passages.add(RATES)
    if w.words.startswith("so that ") and w.words.endswith(" drops out"):
        _add(found.left_out, (w.place, w.words.removeprefix("so that ").removesuffix(" drops out")))


def _kind(instant: InstantSolution, w: Written) -> str:
    system = instant.trial.system
    if len(w.bodies) == 1 and w.lead in (system.scene.bodies[w.bodies[0]].center_name, "G"):
        return "centre"
    pins = [j for m in system.modes.values() for j in m.facts.joinings if j.path is None and j.rolling is None]
    fixed = any(
        GROUND in (j.base, j.mover) and {j.base, j.mover} == {GROUND, *w.bodies} for j in pins if j.place == w.lead
    )
    return "pivot" if fixed else ""


def _of_motion(found: Uses, motion: MotionTrace) -> None:
    routes = [motion.route, *motion.passing.values()]
    if any(leg.turns for route in routes for leg in route.steps):
        found.laws.add("steady")
        found.constant.add("rad")
    for e in _relations(routes):
        if isinstance(e.source, BalanceTrace):
            (found.energies if e.source.law.letter else found.momenta).append(e.source)
            parts = e.source.parts.moving if e.source.parts is not None else ()
            found.turning_energy |= any(m.inertia != 0 and m.omega != 0 for m in parts)
        elif isinstance(e.source, ImpactEquation):
            found.blows = True
        found.restitution |= e.kind == "blow" and e.words.startswith("Restitution")
        if e.law is not None and e.law.f != 0:
            steady = not e.law.f.free_symbols & {*motion.varying, e.law.v}
            if steady:
                found.constant.add(e.law.coordinate.unit)
            found.laws.add(e.kind if not steady else "constant" if e.law.order == 2 else "steady")
            found.over |= set() if steady else {_over(e, motion.ledger.symbols["t"])}
        found.laws |= {RELATIVE} if e.kind == RELATIVE else set()
        found.integrated |= e.kind == "followed"
        found.extreme |= e.kind == "extreme"
        found.over |= {KEPLER} if e.kind == ANOMALY else set()
    found.integrated |= any(p.how in ("integral", "quadrature", "flow") for s in motion.spans for p in s.pieces)
    found.impulses |= any(p.how == "change" for s in motion.spans for p in s.pieces)
    found.swings |= bool(motion.oscillations)


def _over(e: Relation, time: sp.Symbol) -> str:
    """What the integral of a law runs over."""
    if e.span is not None and EQUATION in e.span.words:
        return linear_method(e.span.words, e.law, time)
    if e.kind in ("v(q)", "q(v)"):
        turns = e.law is not None and e.law.coordinate.unit == "rad"
        return f"Integration over the {'angle: ω dω = α dθ' if turns else 'way: v dv = a ds'}."
    return OVER_TIME


def _relations(routes: Iterable[RouteTrace]) -> Iterator[Relation]:
    for route in routes:
        yield from (e for step in route.steps if not step.is_datum for e in step.relations)


def _add(kept: list[Any], new: Any) -> None:
    if new is not None and new not in kept:
        kept.append(new)
