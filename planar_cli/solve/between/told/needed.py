"""What of the accelerations and reactions of a regime a motion rests on: only that is told before it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

import sympy as sp

from planar_cli.equation.algebra.plain import are_zero, derivative, identically_zero
from planar_cli.equation.values.exact import Valuation
from planar_cli.principles.base import Balance
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.between.equations.balances import StateBalance
from planar_cli.solve.between.equations.by_centres import by_centres
from planar_cli.solve.between.equations.energies import centre_of
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.between.told.links_in_line import line_of, says_in_line
from planar_cli.solve.between.trace.derivation import Route
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.instant.stages import acceleration_unknowns
from planar_cli.solve.instant.written import Written
from planar_cli.solve.law import Law
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.meetings import Together
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Stop
from planar_cli.solve.solution import InstantSolution

AXES = ("x", "y")
STICK = "stick"
Asked = Mapping[str, Mapping[str, tuple[sp.Expr, ...]]]
"""By state, by the name of a find: its components in the unknowns of the general position."""


def wanted_of(
    course: StatedMotion, routes: Sequence[Route], instant: InstantSolution, asked: Asked, value: Valuation
) -> tuple[frozenset[str] | None, frozenset[str] | None]:
    """Names of unknowns of a general position on which routes and finds rest, and those on which anything but finds
    at states does; None: all of them. `value`: numbers of everything.
    """
    regime = _regime(course, instant)
    if regime is None:
        return None, None
    by_work = set(course.between.tensions.values())
    said = [e for e in map(sp.sympify, course.said.get(id(regime), ())) if e not in by_work]
    lines = _pairs_in_line(course, routes)
    said = [e for e in said if not lines or not says_in_line(regime.closed(e), lines)]
    finds = {e for of_state in asked.values() for parts in of_state.values() for e in parts}
    known = unknowns_of(regime)
    names = _of_turnings(course, regime)
    for name in (s.name for s, _ in course.modes.equilibria if course.readers[s.name].regime is regime):
        # A travel that swings nowhere, like that of a free cart, has no equation of motion to be told.
        free = () if name not in course.swings and _of_places(routes) else regime.free
        swinging = _rates(regime, course.swings[name].speeds if name in course.swings else free)
        idle = _rates(regime, regime.free) - swinging
        said = [e for e in said if e in finds or not (e.is_Symbol and e.name in idle)]
        names |= swinging
    laws = [law for i, r in enumerate(course.regimes) if r is regime for law in course.laws[i].laws]
    # By the letters of their own speeds: the start of a stretch may have been put into them.
    own = {law.v for law in laws}
    for way, e in ((r, e) for r in routes for step in r.steps for e in step.derivation.equations):
        if e.kind == "followed" and _is_passed(course, regime, e.stop):
            names |= _rates(regime, regime.free)
        for law in () if _told_by_balance(course, e, way) else laws_of(e):
            if law.v in own and (law.f != 0 or _has_other(law, laws)):
                names |= _rates(regime, regime.free if law.speed is None else (law.speed,))
                names |= set() if law.constant is None else {law.constant[0].name}
        if isinstance(e.source, tuple) and (blow := e.source[0]).before is regime:
            names |= _carried(regime, blow, e.source[1])
        if isinstance(e.source, StateBalance):
            parts = _parts(course, regime, e.source, way.formulas, value)
            names |= {s.name for x in parts for s in x.free_symbols & known}
    known |= by_centres(regime) if _of_places(routes) else set()
    others = {s.name for e in said if e not in finds for s in e.free_symbols & known}
    every = {s.name for e in said for s in e.free_symbols & known}
    return frozenset(names | every), frozenset(names | others)


def _pairs_in_line(course: StatedMotion, routes: Sequence[Route]) -> list[tuple[sp.Symbol, sp.Symbol]]:
    """The angles of links that lie in one line in a state: geometry tells it, and no equation of velocities."""
    general = {own: letter for stop in course.stops.values() for letter, own in stop.letters.items()}
    told = (line_of(step.derivation.equations, step.results) for way in routes for step in way.steps)
    return list(dict.fromkeys((general[t.first], general[t.other]) for t in told if t is not None))


def _of_places(routes: Sequence[Route]) -> bool:
    """Does what is asked of an equilibrium rest on where it is alone: on no sum of forces?"""
    used = [e for way in routes for step in way.steps for e in step.derivation.equations]
    return bool(used) and all(e.kind in ("drawn", "given") for e in used)


def laws_of(e: Equation) -> tuple[Law, ...]:
    """The laws that an equation rests on and that balances of forces have to tell."""
    if isinstance(e.source, Together):
        return () if e.source.falling else e.source.laws
    return () if e.law is None else (e.law,)


def _told_by_balance(course: StatedMotion, e: Equation, way: Route) -> bool:
    """Is it a way whose speed at any time a balance of momentum to the same state tells, so that it needs no law?"""
    # A function of time, as of a damped vibration, leads to no state.
    if e.kind != "q(t)" or e.law is None or e.span is None or e.span.explicit is None or e.stop not in course.stops:
        return False
    stop = course.stops[e.stop]
    speed = next((own for letter, own in stop.letters.items() if letter in (e.law.v, e.law.speed)), None)
    if speed is None:
        return False
    put = {speed: derivative(e.span.explicit, stop.t)}
    used = (x for step in way.steps for x in step.derivation.equations)
    balances = (x for x in used if isinstance(x.source, StateBalance) and (x.since, x.stop) == (e.since, e.stop))
    # Of a mass that stays the same the law is as short as the balance.
    growing = (x for x in balances if x.kind == "momentum" and derivative(x.residual, speed).has(stop.t))
    return any(identically_zero(x.residual.xreplace(put)) for x in growing)


def _carried(regime: Regime, blow: Blow, w: Written) -> set[str]:
    """The speeds of what an equation of a blow after a regime holds, where they follow from others: v_B = -v_A/2."""
    edges = (e for e in regime.general.trial.system.tree.edges if e.body in w.bodies)
    speeds = {s for e in edges for s in (e.slide, e.rise, e.spin) if s is not None} - set(regime.free)
    return {s.name for s in speeds if blow.since.at(regime.closed(s)) != 0}


def _has_other(law: Law, laws: Iterable[Law]) -> bool:
    """Along x of P nothing acts, along y of P something does: then both sums of forces are written."""
    axis, _, thing = law.coordinate.words.partition(" of ")
    others = (x.coordinate.words for x in laws if x.f != 0)
    return axis in AXES and any(words == f"{other} of {thing}" for words in others for other in AXES)


def asked_at(course: StatedMotion, finds: Iterable[AskedFind], instant: InstantSolution) -> Asked:
    """The finds that ask at one state for forces or accelerations of this general position."""
    regime = _regime(course, instant)
    found: dict[str, dict[str, tuple[sp.Expr, ...]]] = {}
    for a in finds:
        if a.find.name in course.between.tensions:
            continue
        pending = {s: a.reader.pending[s] for p in a.raw for s in p.free_symbols if s in a.reader.pending}
        states = {state for _, state, _ in pending.values()}
        if regime is None or len(states) != 1 or any(other.regime is not regime for other, _, _ in pending.values()):
            continue
        parts = tuple(p.xreplace({s: value for s, (_, _, value) in pending.items()}) for p in a.raw)
        if any(p.free_symbols & forces_of(regime) for p in parts):
            found.setdefault(states.pop(), {})[a.find.name] = parts
    return found


def laws_of_motion(course: StatedMotion, instant: InstantSolution) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The rate of every free speed in a general position."""
    regime = _regime(course, instant)
    rates = () if regime is None else regime.accelerations.items()
    return tuple((u, f) for u, f in ((regime.general.rate_of(u), f) for u, f in rates) if u.is_Symbol) if regime else ()


def forces_of(regime: Regime) -> set[sp.Symbol]:
    """Accelerations and reactions."""
    system = regime.general.trial.system
    return {*acceleration_unknowns(system), *system.symbols.values()}


def unknowns_of(regime: Regime) -> set[sp.Symbol]:
    """These and velocities."""
    return forces_of(regime) | set(regime.general.trial.system.tree.velocity_unknowns())


def _regime(course: StatedMotion, instant: InstantSolution) -> Regime | None:
    """The regime of a general position."""
    return next((r for r in _regimes(course) if r.general.solution is instant), None)


def _regimes(course: StatedMotion) -> Iterator[Regime]:
    """Those of the motion, and those of equilibrium states."""
    yield from course.distinct_regimes()
    yield from (course.readers[s.name].regime for s, _ in course.modes.equilibria)


def _is_passed(course: StatedMotion, regime: Regime, stop: str) -> bool:
    """Does a regime act on the way to a state?"""
    names = [s.name for s in course.states]
    return stop in names and any(r is regime for r in course.regimes[: names.index(stop)])


def _rates(regime: Regime, speeds: Iterable[sp.Symbol]) -> set[str]:
    """The accelerations that go with free speeds."""
    return {s.name for u in speeds for s in sp.sympify(regime.general.rate_of(u)).free_symbols}


def _of_turnings(course: StatedMotion, regime: Regime) -> set[str]:
    """The pushes that decide where this regime ends."""
    symbols = regime.general.trial.system.symbols
    ends = [*course.modes.turnings.values()]
    # That of two components may stand in the distance of their point, no longer in its coordinates.
    tests = [
        w.test
        for w in regime.watches
        if any(e in (w.expr, -w.expr) or (w.test.within and words.startswith(w.test.words)) for e, words in ends)
    ]
    pushes = (name for test in tests for name in (*(n for n, _ in test.pushes), *test.within))
    return {symbols[name].name for name in pushes if name in symbols}


def modes_asked(course: StatedMotion, finds: Iterable[AskedFind], instant: InstantSolution) -> frozenset[str]:
    """The pushes of contacts that stick in a general position, of which it is asked how they act at a state, where no
    short formula tells the friction: that a body needs none is told by its equations.
    """
    regime = _regime(course, instant)
    if regime is None:
        return frozenset()
    system, names = regime.general.trial.system, [s.name for s in course.states]
    found: set[str] = set()
    for what in (f.find.found.what for f in finds):
        q = what.left if isinstance(what, Relation) else what
        if not isinstance(q, Quantity) or q.word != "mode" or q.at not in names:
            continue
        first = names.index(str(q.at))
        acting = course.regimes[min(first, len(course.regimes) - 1)]
        for joint, mode in system.modes.items() if acting is regime else ():
            named = {joint, system.aliases.get(joint)} & set(q.things)
            tests = [t for t in mode.tests if not t.strict] if named and mode.name == STICK else []
            pushes = {n for t in tests for n, _ in t.pushes}
            if any(regime.closed(system.symbols[n]) == 0 for n in pushes):
                found |= {system.symbols[n].name for n in pushes}
    return frozenset(found)


def _kinetic(balance: Balance, regime: Regime, stop: Stop, value: Valuation) -> Iterator[sp.Expr]:
    """What tells the amounts of a balance: of a body about whose instantaneous centre its energy is told, only how it
    turns.
    """
    led = {m.body: m.omega for m in balance.moving if not m.why and centre_of(m, regime, stop, value)}
    yield from (led.get(body, amount) for body, amount in balance.amounts)


def _parts(
    course: StatedMotion,
    regime: Regime,
    source: StateBalance,
    formulas: Mapping[sp.Symbol, sp.Expr],
    value: Valuation,
) -> Iterator[sp.Expr]:
    """What a balance takes from a regime: amounts where it ends there and they are not zero at both ends, and forces
    that do work or turn on the way.
    """
    names = [s.name for s in course.states]
    first, last = names.index(source.since.name), names.index(source.stop.name)
    acting = [k for k in range(first, last) if course.regimes[k] is regime]
    if not acting:
        return
    for offered in course.between.offered.get(id(regime), []):
        if offered.balance.words != source.law.words or offered.balance.name != source.law.name:
            continue
        if offered.balance.bodies != source.law.bodies:
            continue
        if acting[-1] == last - 1 and not are_zero((source.before, source.after), formulas):
            yield from _kinetic(offered.balance, regime, source.stop, value)
        yield from (s.rate for s in offered.balance.sources if s.function is None)
