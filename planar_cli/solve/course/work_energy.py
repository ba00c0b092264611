"""Work and kinetic energy between two states.

    T_1 + U_1-2 = T_2        T = Σ m v_G²/2 + I_G ω²/2

U is the work of weights, springs and all other loads, and of friction where something slips; ideal joints (smooth pins
and guides, rolling without slip, taut ropes) do none. The work of a weight is m g (y_1 - y_2), that of a spring
k (s_1² - s_2²)/2; any other is a function of place, or there is no such equation. (An Introduction to Planar Dynamics,
3.3, 3.5, 4.5, equations 4.61 - 4.67.)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import sympy as sp

from planar_cli.equation.moving import Moving
from planar_cli.equation.plain import longer, simplified
from planar_cli.problem.acting import acting_loads
from planar_cli.problem.facts import Wrench
from planar_cli.problem.geometry import Vec
from planar_cli.solve.course.equations import NO_MASS, Equation
from planar_cli.solve.course.general import General
from planar_cli.solve.course.potential import potential
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.timeline import Stop

FRICTION = "friction at {}"
"""What does work where no load does: bodies that skid."""
LONGEST = 500
"""A longer kinetic energy is not put on paper."""


@dataclass(frozen=True, slots=True)
class Source:
    """What does work: its name in words, the power, and minus its potential energy where it has one."""

    words: str
    power: sp.Expr
    function: sp.Expr | None = None


@dataclass(frozen=True, slots=True)
class Energies:
    """Of one regime: the kinetic energy of every body, and what does work; in the unknowns of the general position."""

    kinetic: tuple[tuple[str, sp.Expr], ...]
    sources: tuple[Source, ...]

    def exprs(self) -> list[sp.Expr]:
        """All that the regime has to work out for it."""
        found = [e for _, e in self.kinetic]
        found += [s.power if s.function is None else s.function for s in self.sources]
        return found


@dataclass(frozen=True, slots=True)
class Work:
    """The work of one source between two states: a difference of values of `function`, a closed formula."""

    words: str
    value: sp.Expr


@dataclass(frozen=True, slots=True)
class Balance:
    """One energy equation: T at both states and the works, in letters of the states. `kinetic`: by body, at the end;
    `idle`: the reactions that do no work.
    """

    since: Stop
    stop: Stop
    before: sp.Expr
    after: sp.Expr
    works: tuple[Work, ...]
    kinetic: tuple[tuple[str, sp.Expr], ...]
    idle: tuple[sp.Symbol, ...]


def energies_of(general: General) -> Energies | None:
    """What a regime has of energy; None: no mass, or something unknown drives it, or a support moves."""
    scene, system = general.instant.scene, general.trial.system
    if system.reactions is None or not any(b.mass != 0 for b in scene.bodies.values()):
        return None
    if any(b.varies(general.time) for b in scene.bodies.values()):
        return None
    if any(p.kind == "drive" for p in system.pushes) or any(
        c.kind == "given" for c in system.acceleration_conditions()
    ):
        return None
    facts = [mode.facts for mode in system.modes.values()]
    if any(j.drift is not None for f in facts for j in f.joinings) or any(r.rate != 0 for f in facts for r in f.rows):
        return None
    motion = general.quantities.motion
    carried = [t.linear for t in motion.velocities.values()]
    if any(general.time in v.x.free_symbols | v.y.free_symbols for v in carried):
        return None
    kinetic = []
    for name, body in scene.bodies.items():
        v, omega = motion.velocity(body.center, name), motion.velocities[name].angular
        kinetic.append((name, body.mass * v.dot(v) / 2 + body.inertia * omega**2 / 2))
    return Energies(tuple((n, e) for n, e in kinetic if e != 0), tuple(_sources(general)))


def _sources(general: General) -> Iterator[Source]:
    """Weights first, then loads one by one, then the friction of what slips."""
    scene, system, motion = general.instant.scene, general.trial.system, general.quantities.motion
    assert system.reactions is not None
    named: dict[tuple[str, str], list[Wrench]] = {}
    for w in system.wrenches:
        named.setdefault((w.kind, w.name), []).append(w)
    loads = {(x.kind, x.name): x for x in acting_loads(scene.problem)}
    setting = Moving(scene, motion, general.value)
    for (kind, name), wrenches in named.items():
        power = sp.Add(*(_power(w, general) for w in wrenches))
        load = loads.get((kind, name))
        stored = None if load is None else load.potential(setting)
        working = FRICTION if load is None else load.working or f"{kind} {{}}"
        yield Source(working.format(name), power, None if stored is None else -sp.sympify(stored))
    followers = {law.push for law in system.laws}
    for push, value in system.reactions.pushes:
        if push.name not in followers or value == 0:
            continue
        parts = [a.force.dot(motion.velocity(a.point, a.body)) for a in push.actions if a.force is not None]
        parts += [a.couple * motion.velocities[a.body].angular for a in push.actions]
        yield Source(FRICTION.format(push.place), sp.Add(*parts) * value)


def _power(w: Wrench, general: General) -> sp.Expr:
    motion = general.quantities.motion
    force = w.force or Vec(sp.S.Zero, sp.S.Zero)
    return force.dot(motion.velocity(w.point, w.body)) + w.couple * motion.velocities[w.body].angular


@dataclass(frozen=True, slots=True)
class Closed:
    """The energies of a regime as closed formulas: T, T by body, and a function of place for every source."""

    kinetic: tuple[tuple[str, sp.Expr], ...]
    functions: tuple[tuple[str, sp.Expr], ...]
    idle: tuple[sp.Symbol, ...]

    @property
    def total(self) -> sp.Expr:
        return sp.Add(*(e for _, e in self.kinetic))


def closed_energies(regime: Regime, energies: Energies | None) -> Closed | None:
    """None: some work depends on more than the place, or formulas grow too long."""
    if energies is None:
        return None
    kinetic = tuple((n, simplified(regime.closed(e))) for n, e in energies.kinetic)
    if any(longer(e, LONGEST) or not regime.told(e) for _, e in kinetic):
        return None
    functions = []
    for source in energies.sources:
        if source.function is not None:
            found: sp.Expr | None = regime.closed(source.function)
        else:
            found = potential(regime.closed(source.power), regime)
        if found is None or found.has(sp.Integral) or longer(found, LONGEST):
            return None
        if found.free_symbols & set(regime.letters):
            functions.append((source.words, found))
    return Closed(kinetic, tuple(functions), _idle(regime.general))


def _idle(general: General) -> tuple[sp.Symbol, ...]:
    """The reactions that do no work."""
    system = general.trial.system
    followers = {law.push for law in system.laws}
    return tuple(system.symbols[p.name] for p in system.pushes if p.name not in followers and p.kind != "drive")


def energy_equations(course: RegimeSequence, closed: Sequence[Closed | None], k: int) -> Iterator[Equation]:
    """The equations that end at state k: from the state before it, and from where the run began."""
    begins = k
    while begins > 0 and not course.is_impulsive(begins - 1) and closed[begins - 1] is not None:
        begins -= 1
    for since in dict.fromkeys((k - 1, begins)) if begins < k else ():
        yield from _balance(course, closed, since, k)


def _balance(course: RegimeSequence, closed: Sequence[Closed | None], since: int, k: int) -> Iterable[Equation]:
    stops = [course.stops[course.states[i].name] for i in range(since, k + 1)]
    first, last = closed[since], closed[k - 1]
    assert first is not None
    assert last is not None
    sums: dict[str, list[sp.Expr]] = {}
    for i in range(since, k):
        here = closed[i]
        assert here is not None
        a, b = stops[i - since], stops[i - since + 1]
        for words, function in here.functions:
            sums.setdefault(words, []).append(b.at(function) - a.at(function))
    works = tuple(Work(words, w) for words, parts in sums.items() if (w := simplified(sp.Add(*parts))) != 0)
    before, after = stops[0].at(first.total), stops[-1].at(last.total)
    balance = Balance(
        stops[0], stops[-1], before, after, works, tuple((n, stops[-1].at(e)) for n, e in last.kinetic), last.idle
    )
    residual = after - before - sp.Add(*(w.value for w in works))
    times = {s.t for s in stops}
    if residual.free_symbols & times or not residual.free_symbols & set(stops[-1].letters.values()):
        return ()
    words = "work and kinetic energy"
    extra = NO_MASS if any(b.any_mass for b in course.problem.bodies) else 0.0
    return (Equation(residual, "energy", words, stops[-1].name, stops[0].name, source=balance, surcharge=extra),)
