"""On what a solution rests, read from its trace: the principles of a page, and what a lesson has to speak of.

Only what is told counts: of a motion the equations of its regimes on which an answer rests.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import field
from typing import Any

from planar_cli.calculus.linear_laws import EQUATION
from planar_cli.problem.expression import Quantity
from planar_cli.problem.facts import Mode
from planar_cli.problem.scene import GROUND
from planar_cli.records import changing, record
from planar_cli.solve.between.trace import BalanceTrace, ImpactEquation, MotionTrace, Relation, RouteTrace
from planar_cli.solve.instant.stages import Stage
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.instant.written import Written
from planar_cli.solve.solution import InstantSolution
from planar_cli.solve.solved_problem import PartSolution

MOVING = ("v", "a", "coriolis")


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
    inertial: bool = False
    """Are inertial forces drawn among the forces?"""
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
    moments: list[Moments] = field(default_factory=list)
    groups: list[tuple[str, ...]] = field(default_factory=list)
    """Several bodies whose forces are summed together."""
    sticking: list[str] = field(default_factory=list)
    slipping: list[str] = field(default_factory=list)
    """Contacts, by their joints."""
    together: int = 0
    """Most unknowns that follow from equations together."""
    energies: list[BalanceTrace] = field(default_factory=list)
    momenta: list[BalanceTrace] = field(default_factory=list)
    blows: bool = False
    restitution: bool = False
    laws: set[str] = field(default_factory=set)
    """Kinds of integrals of laws, v(t), v(q), …; constant: of such an acceleration; steady: of such a speed."""
    over: set[str] = field(default_factory=set)
    """What integrals of laws that are not constant run over, in words."""
    integrated: bool = False
    swings: bool = False

    @property
    def kinetic(self) -> bool:
        return self.forces or bool(self.singles)

    @property
    def coriolis(self) -> bool:
        return bool(self.sliding or self.frames)


def uses_of(parts: Iterable[PartSolution]) -> Uses:
    """Of some parts together."""
    found = Uses()
    for part in parts:
        if part.tale is None or not part.tale.whole:
            for instant in part.instants:
                if not instant.quiet:
                    _of_instant(found, instant, _stages(part, instant))
        else:
            found.relations = True
        if part.motion is not None:
            _of_motion(found, part.motion)
        if part.followed is not None:
            found.integrated = True
        for answer in part.found:
            what = answer.find.found.what if answer.find is not None else None
            if isinstance(what, Quantity) and what.word in MOVING:
                base = what.things[1] if len(what.things) == 2 else GROUND
                found.beside |= base != GROUND
                _add(found.frames, base if any(_turns(i, base) for i in part.instants) else None)
    return found


def _turns(instant: InstantSolution, body: str) -> bool:
    motion = instant.trial.system.motion
    return motion is not None and body in motion.velocities and motion.velocities[body].angular != 0


def _stages(part: PartSolution, instant: InstantSolution) -> tuple[Stage, ...]:
    wanted = None if part.motion is None else part.motion.regime(instant).wanted
    return used_blocks(instant.stages, wanted)


def _of_instant(found: Uses, instant: InstantSolution, stages: tuple[Stage, ...]) -> None:
    written = [w for s in stages for b in s.blocks for w in b.equations if not w.given]
    system = instant.trial.system
    found.at_rest |= instant.instant.at_rest
    found.together = max([found.together, *(len(b.unknowns) for s in stages for b in s.blocks)])
    for w in written:
        if w.law == "relation":
            _of_relation(found, w)
        elif w.law == "single":
            found.singles.add(w.words)
        else:
            found.forces = True
            found.inertial |= instant.instant.principle.inertia_as_force
            _add(found.groups, w.bodies if len(w.bodies) > 1 else None)
            if w.law == "moment":
                _add(found.moments, Moments(w.lead, w.bodies, _kind(instant, w)))
    for mode in system.modes.values():
        _of_joint(found, instant, mode)


def _of_joint(found: Uses, instant: InstantSolution, mode: Mode) -> None:
    motion = instant.trial.system.motion
    for j in mode.facts.joinings:
        if j.rolling is not None:
            _add(found.rolling, (j.mover, j.base, j.place))
        if j.path is not None and motion is not None and not mode.facts.laws and _turns(instant, j.base):
            _add(found.sliding, (j.place, j.base) if motion.slide_speed(j) != 0 else None)
    joint = next((j.joint for j in mode.facts.joinings), "")
    rubs = mode.name == "stick" or (mode.name == "slip" and mode.facts.laws)
    if rubs and joint and found.forces:
        _add(found.sticking if mode.name == "stick" else found.slipping, joint)
    _add(found.cords, next((push.joint for push in mode.facts.pushes if push.kind == "tension"), None))


def _of_relation(found: Uses, w: Written) -> None:
    found.relations = True
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
    for e in _relations(routes):
        if isinstance(e.source, BalanceTrace):
            (found.energies if e.source.law.letter == "T" else found.momenta).append(e.source)
        elif isinstance(e.source, ImpactEquation):
            found.blows = True
        found.restitution |= e.kind == "blow" and e.words.startswith("Restitution")
        if e.law is not None and e.law.f != 0:
            steady = not e.law.f.free_symbols & {*motion.varying, e.law.v}
            found.laws.add(e.kind if not steady else "constant" if e.law.order == 2 else "steady")
            found.over |= set() if steady else {_over(e)}
        found.integrated |= e.kind == "followed"
    found.integrated |= any(p.how in ("integral", "quadrature", "flow") for s in motion.spans for p in s.pieces)
    found.swings |= bool(motion.oscillations)


def _over(e: Relation) -> str:
    """What the integral of a law runs over."""
    if e.span is not None and EQUATION in e.span.words:
        return "Linear equation of motion, solved by its characteristic equation."
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


def principles(uses: Uses) -> list[str]:
    """What the head of a page names, a sentence for each."""
    return list(_laws(uses)) or ["Kinematics: places, velocities and accelerations."]


def _laws(uses: Uses) -> Iterator[str]:
    if uses.coriolis:
        yield "Motion relative to a turning body, with the Coriolis acceleration."
    elif uses.beside:
        yield "Motion relative to a moving body."
    if uses.relations and not (
        uses.kinetic or uses.energies or uses.momenta or uses.blows or uses.beside or uses.coriolis
    ):
        yield "Kinematics: places, velocities and accelerations."
    if uses.forces:
        yield DALEMBERT if uses.inertial else "Newton's second law."
    if any("virtual power" in words for words in uses.singles):
        yield "Virtual power, in which no reaction takes part."
    if any(words.startswith("Lagrange") for words in uses.singles):
        yield "Lagrange's equations, in which no reaction takes part."
    if uses.blows:
        yield "Impulse and momentum across the blow."
    if uses.energies:
        yield "Work and energy between the states."
    yield from _momenta(uses)
    over = uses.over | ({OVER_TIME} if uses.integrated else set())
    if over:
        yield from sorted(over)
    elif "constant" in uses.laws:
        yield "Constant acceleration."
    if uses.swings:
        yield "Small oscillations about an equilibrium."


def _momenta(uses: Uses) -> Iterator[str]:
    if any(b.gain != 0 or not b.law.kept for b in uses.momenta):
        yield "Impulse and momentum over a time."
    kept = [b for b in uses.momenta if b.gain == 0 and b.law.kept]
    if any(b.law.lead != TURNING for b in kept):
        yield "Conservation of momentum."
    if any(b.law.lead == TURNING for b in kept):
        yield "Conservation of angular momentum."


OVER_TIME = "Integration over time."
TURNING = "↺ "
"""The lead of a balance of moments or of angular momentum."""
DALEMBERT = "d'Alembert's principle: with the inertial forces each body is in equilibrium."
