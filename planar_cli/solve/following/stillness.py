"""Which free speeds stay zero: nothing sets them in motion, whatever the others do.

A load that hangs straight down could sway, and does not: the rate of its sideways speed vanishes where it hangs, for
every value of what moves. That is decided in numbers, at places that the motion may come to, as it may rest on the
numbers of the file (the load is drawn exactly below the rim of the pulley).
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import by_name
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import CERTAIN, Valuation
from planar_cli.equation.values.sample import anywhere
from planar_cli.errors import FileProblem, NotReached, NoValue
from planar_cli.problem.language.expression import AtRest
from planar_cli.solve.between.equations.stated_motion import StatedMotion
from planar_cli.solve.instant.worked import unknowns_of
from planar_cli.solve.regimes.constraints import project
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

SAMPLES = 2
"""So many places are looked at."""
BESIDE = Decimal("0.1")
"""So far from where they start, in parts of an ordinary size, what moves is looked at."""


def hanging(course: RegimeSequence) -> frozenset[str]:
    """Free speeds by which what hangs on ropes could sway, and does not, in a motion that begins at rest as drawn. That
    is told before any regime is worked out, as formulas in which things sway are long.
    """
    states = course.states
    if not states or course.modes.stretches[0].blow is not None:
        return frozenset()
    if not any(isinstance(s, AtRest) and s.body is None for s in states[0].relations):
        return frozenset()
    first, given = course.regimes[0], course.given()
    drawn = {c.symbol: given.known(c.drawn) for c in first.coordinates if c.drawn is not None}
    start = {s: n for s, n in drawn.items() if n is not None} | dict.fromkeys(first.free, Decimal(0))
    names = {s.name for r in course.regimes for s in r.general.trial.system.hanging()} & {u.name for u in first.free}
    if not names or len(start) + 1 < len(first.letters):
        return frozenset()
    return resting(course, start) & names


def resting(course: RegimeSequence, start: Mapping[sp.Symbol, Decimal]) -> frozenset[str]:
    """Free speeds that are zero at the start and that nothing sets in motion, whatever the others do: also those that
    rest from the beginning, and may move in modes that were found since.
    """
    stretches = course.modes.stretches
    held = stretches[0].resting
    idle = {u for u in course.regimes[0].free if start.get(u) == 0}
    idle |= {u for r in course.regimes for u in r.free if u.name in held}
    idle -= _stated_later(course)
    acting = list(enumerate(zip(course.regimes, stretches, strict=False)))
    # What moves in no regime from there on, as it then lies on a floor, rests whatever acts.
    last = {u: max((i for i, (r, _) in acting if u in r.free), default=-1) for u in idle}
    while idle:
        moved = {
            u
            for i, (r, s) in acting
            for u in acted_on(course, r, idle, start)
            if u.name not in s.resting and i <= last[u]
        }
        if not moved:
            return frozenset(u.name for u in idle)
        idle -= moved
    return frozenset()


def _stated_later(course: RegimeSequence) -> set[sp.Symbol]:
    """Free speeds that nothing drives, and of which a later state says something: only the states tell them."""
    if not isinstance(course, StatedMotion):
        return set()
    later = [d.residual for name, found in course.demands.items() if name != course.first.name for d in found]
    said = {s for residual in later for s in residual.free_symbols}
    found = {u for r in course.regimes for u in r.free if is_undriven(r, u)}
    return {
        u for u in found if any(s.letters.get(u) in said for n, s in course.stops.items() if n != course.first.name)
    }


def is_undriven(regime: Regime, u: sp.Symbol) -> bool:
    """Does nothing tell how a free speed changes?"""
    return regime.general.rate_of(u) in regime.accelerations.get(u, sp.S.Zero).free_symbols


def unturned(course: StatedMotion, start: Mapping[sp.Symbol, Decimal], asked: Collection[sp.Symbol]) -> frozenset[str]:
    """Free speeds that are zero at the start, whose change nothing tells, and which nothing needs: a light pulley over
    which a smooth rope slides may turn, and nobody asks. `asked`: all symbols that finds ask for.
    """
    idle = [u for u in course.regimes[0].free if start.get(u) == 0]
    return frozenset(
        u.name for u in idle if all(_is_apart(course, r, u, asked) for r in course.distinct_regimes() if u in r.free)
    )


def acted_on(
    course: RegimeSequence, regime: Regime, idle: set[sp.Symbol], start: Mapping[sp.Symbol, Decimal]
) -> set[sp.Symbol]:
    """Those of these speeds on which something acts while all of them vanish."""
    own = {u for u in idle if u in regime.free}
    plain = dict.fromkeys(idle, sp.S.Zero)
    worked = {u for u in own if u in regime.accelerations and regime.accelerations[u].subs(plain) == 0}
    asked = {u: regime.general.rate_of(u) for u in own - worked}
    if not asked:
        return idle - own
    places = _places(course, regime, idle, start)
    least = {u: CERTAIN * n * 10**15 for u, n in course.natural(asked).items()}
    kept = {u for u, a in asked.items() if places and all(_is_none(p.get(a), least[u]) for p in places)}
    return idle - own | asked.keys() - kept


def _is_apart(course: StatedMotion, regime: Regime, u: sp.Symbol, asked: Collection[sp.Symbol]) -> bool:
    """Does nothing tell how a speed changes, and nothing else depend on it or on what moves with it?"""
    if not is_undriven(regime, u):
        return False
    own = regime.general.rate_of(u)
    places = {q for q, rate in regime.rates.items() if u in rate.free_symbols}
    if any(regime.rates[q] != u for q in places):
        return False
    mine = {u, own, *places}
    mine |= {stop.letters[s] for stop in course.stops.values() for s in mine if s in stop.letters}
    later = [d.residual for name, found in course.demands.items() if name != course.first.name for d in found]
    said = [e for e in map(regime.closed, regime.exprs) if e != u]
    others = [a for s, a in regime.accelerations.items() if s != u]
    watched = [*(w.expr for w in regime.watches), *regime.slips, *(e for _, e in regime.sided.values())]
    return mine.isdisjoint(asked) and all(mine.isdisjoint(e.free_symbols) for e in (*later, *said, *others, *watched))


def _is_none(number: Decimal | None, least: Decimal) -> bool:
    return number is not None and abs(number) <= least


def _places(
    course: RegimeSequence, regime: Regime, idle: set[sp.Symbol], start: Mapping[sp.Symbol, Decimal]
) -> list[dict[sp.Symbol, Decimal]]:
    """The accelerations at positions, with speeds, that the motion may come to while these speeds vanish; none, where
    no such is found.
    """
    moving: set[sp.Symbol] = set()
    while True:
        try:
            found = [_place(course, regime, idle, moving, start, k) for k in range(SAMPLES)]
            tried = [regime.general.instant.try_choice(regime.general.choice, (v,), given=g) for v, g in found]
        except (NotReached, NoValue, FileProblem):
            # Nor where something has no direction, as a cord whose ends coincide before it is stretched.
            return []
        if not all(trial.outcomes for trial in tried):
            return []
        values = [trial.outcomes[0].value for trial in tried]
        more = {
            c.symbol
            for c in regime.coordinates
            if c.symbol not in moving and not all(_is_still(regime, c, v) for v in values)
        }
        if not more:
            return [unknowns_of(trial.system, trial.outcomes[0]) for trial in tried]
        moving |= more


def _is_still(regime: Regime, c: Coordinate, value: Valuation) -> bool:
    """Does a coordinate not change at this place?"""
    rate = c.rate if value.known(c.rate) is not None else regime.rates.get(c.symbol, c.rate)
    return value.vanishes(rate)


def _place(
    course: RegimeSequence,
    regime: Regime,
    idle: set[sp.Symbol],
    moving: set[sp.Symbol],
    start: Mapping[sp.Symbol, Decimal],
    number: int,
) -> tuple[Valuation, dict[sp.Symbol, Decimal]]:
    """One such position, and free speeds there: what moves lies beside where it starts, the rest where it starts (or is
    drawn).

    NotReached, NoValue: there is none.
    """
    base = course.base() if isinstance(course, StatedMotion) else course.given()
    natural = course.natural(regime.letters)
    sought = {s: n * anywhere(SAMPLES * k + number) for k, (s, n) in enumerate(course.natural(course.sought()).items())}
    here: dict[sp.Symbol, Decimal] = {regime.time: start.get(regime.time, Decimal(0))}
    for c in regime.coordinates:
        # What is drawn with a constant that is sought is where a number for it puts it.
        drawn = None if c.drawn is None else base.extended(sought).known(c.drawn)
        here[c.symbol] = start.get(c.symbol, Decimal(0) if drawn is None else drawn)
    here |= {c.start: here[c.symbol] for c in regime.coordinates if c.drawn is None}
    way = -1 if number % 2 else 1
    for i, letter in enumerate((regime.time, *sorted(moving, key=lambda s: s.name))):
        forward = 1 if letter == regime.time else way
        here[letter] += forward * BESIDE * natural[letter] * anywhere(SAMPLES * i + number)
    given = {
        u: Decimal(0) if u in idle else way * natural[u] * anywhere(SAMPLES * (len(moving) + 1 + i) + number)
        for i, u in enumerate(regime.free)
    }
    given |= dict.fromkeys(regime.general.resting, Decimal(0))
    # Forces of modes get lines of their own as they are tried.
    base = regime.general.instant.scene.valuations[0].updated(base)
    value, given = base.extended({**sought, **here}), {**sought, **given}
    closing = tuple(c for c in regime.general.constraints if c.residual.free_symbols & moving)
    within = tuple(q for q in by_name(moving) if any(q in c.residual.free_symbols for c in closing))
    return (value.extended(project(closing, within, value)) if closing else value), given
