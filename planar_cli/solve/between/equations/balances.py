"""Balances of an amount between two states: what principles offer over a stretch of time, in closed formulas.

    amount at the second state - amount at the first = Σ what its sources bring in between

A balance is put on paper where everything that a source brings is a function of place and time.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from itertools import pairwise

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded, wide
from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.principles.base import Balance, Source
from planar_cli.records import record
from planar_cli.solve.regimes.costs import NO_MASS
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.potential import potential
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Stop

COMPARED = 60
"""A law with more operations is not compared with others."""


@record
class Offered:
    """A balance in the unknowns of a general position, and whose it is."""

    principle: str
    """The word of the principle."""
    balance: Balance

    def exprs(self) -> list[sp.Expr]:
        """All that a regime has to work out for it."""
        found = [e for _, e in self.balance.amounts]
        return found + [s.rate if s.function is None else s.function for s in self.balance.sources]


@record
class Closed:
    """The same in coordinates, free speeds and t."""

    offered: Offered
    amounts: tuple[tuple[str, sp.Expr], ...]
    """By body; all together where they are told in one line."""
    functions: tuple[tuple[str, sp.Expr], ...]
    """Of every source a function of which its rate is the derivative, by its words."""

    @property
    def total(self) -> sp.Expr:
        return sp.Add(*(e for _, e in self.amounts))

    def is_of(self, other: Closed) -> bool:
        """Is it the same law, in another regime?"""
        mine, others = self.offered, other.offered
        return (mine.principle, mine.balance.name, mine.balance.bodies) == (
            others.principle,
            others.balance.name,
            others.balance.bodies,
        )


@record
class StateBalance:
    """One equation between two states, in their letters."""

    law: Balance
    since: Stop
    stop: Stop
    before: sp.Expr
    after: sp.Expr
    brought: tuple[tuple[str, sp.Expr], ...]
    """What sources bring, by their words; those that bring nothing are left out."""
    amounts: tuple[tuple[str, sp.Expr], ...] = ()
    """The amount at the end, by body."""
    given: Mapping[str, Mapping[sp.Symbol, sp.Expr]] = field(default_factory=dict)
    """By the bodies whose amount is told by what the file gives: letters of the state, with what they are."""

    @property
    def gain(self) -> sp.Expr:
        """What all sources bring."""
        return sp.Add(*(e for _, e in self.brought))


def closed_balances(regime: Regime, offered: Sequence[Offered]) -> list[Closed]:
    """Those that have closed formulas, without repetition."""
    found: list[Closed] = []
    seen: list[tuple[str, sp.Expr]] = []
    for one in offered:
        closed = _closed(regime, one)
        if closed is None:
            continue
        law = closed.total - sp.Add(*(f for _, f in closed.functions))
        law = law if wide(law) else expanded(law)
        others = [x for principle, x in seen if principle == one.principle and not longer(x, COMPARED)]
        if any(not (law / x).free_symbols & set(regime.letters) for x in others):
            continue
        seen.append((one.principle, law))
        found.append(closed)
    return found


def _closed(regime: Regime, offered: Offered) -> Closed | None:
    """None: something that a source brings depends on more than place and time, or formulas grow too long."""
    balance = offered.balance
    parts = balance.amounts if balance.letter else (("", sp.Add(*(e for _, e in balance.amounts))),)
    amounts = tuple((n, simplified(regime.closed(e))) for n, e in parts)
    if any(longer(e, balance.longest) or not regime.told(e) for _, e in amounts) or not any(e for _, e in amounts):
        return None
    functions = []
    for source in balance.sources:
        if source.function is not None:
            found: sp.Expr | None = regime.closed(source.function)
        else:
            rate = regime.closed(source.rate)
            found = potential(rate, regime) if regime.told(rate) else None
        if found is None or found.has(sp.Integral) or longer(found, balance.longest):
            return None
        if found.free_symbols & set(regime.letters) and not _stays(regime, source, found):
            functions.append((source.words, found))
    return Closed(offered, amounts, tuple(functions))


def _stays(regime: Regime, source: Source, function: sp.Expr) -> bool:
    """Do joints that close a loop keep it as it is, as a level rail the height of a slider at the end of two rods?"""
    if len(function.free_symbols & set(regime.letters)) < 2:
        return False
    rate = regime.closed(source.rate)
    return rate == 0 or (not longer(rate, COMPARED) and simplified(rate) == 0)


def balance_equations(course: RegimeSequence, closed: Sequence[Sequence[Closed]], k: int) -> Iterator[Equation]:
    """The equations that end at state k: from the state before it, and from where the law began to hold."""
    if k < 1 or course.is_impulsive(k - 1):
        return
    for principle in dict.fromkeys(c.offered.principle for c in closed[k - 1]):
        own = [c for c in closed[k - 1] if c.offered.principle == principle]
        spans = [(c, _begins(course, closed, c, k)) for c in own]
        for c, _ in spans:
            yield from _equation(course, closed, c, k - 1, k)
        for c, begins in spans:
            if begins < k - 1:
                yield from _equation(course, closed, c, begins, k)


def _begins(course: RegimeSequence, closed: Sequence[Sequence[Closed]], law: Closed, k: int) -> int:
    """The first state from which a law holds up to state k without a break."""
    begins = k - 1
    while begins > 0 and not course.is_impulsive(begins - 1):
        same = course.regimes[begins - 1] is course.regimes[k - 1]
        if law.offered.balance.adds:
            same = _of(closed[begins - 1], law) is not None
        if not same:
            break
        begins -= 1
    return begins


def _of(closed: Sequence[Closed], law: Closed) -> Closed | None:
    """The same law among those of a regime."""
    return next((c for c in closed if c.is_of(law)), None)


def _equation(
    course: RegimeSequence, closed: Sequence[Sequence[Closed]], last: Closed, since: int, k: int
) -> Iterator[Equation]:
    law = last.offered.balance
    ends = list(range(since, k + 1)) if law.adds else [since, k]
    stops = [course.stops[course.states[i].name] for i in ends]
    sums: dict[str, list[sp.Expr]] = {}
    first = last
    for n, (a, b) in enumerate(pairwise(stops)):
        here = _of(closed[ends[n]], last) if law.adds else last
        assert here is not None
        first = here if n == 0 else first
        for words, function in here.functions:
            sums.setdefault(words, []).append(b.at(function) - a.at(function))
    brought = tuple((words, e) for words, parts in sums.items() if (e := simplified(sp.Add(*parts))) != 0)
    start, stop = stops[0], stops[-1]
    amounts = tuple((n, stop.at(e)) for n, e in last.amounts)
    told = StateBalance(law, start, stop, start.at(first.total), stop.at(last.total), brought, amounts)
    residual = told.after - told.before - told.gain
    # What is told in one line is one sum, in which like terms meet.
    residual = residual if law.letter else expanded(residual)
    if law.timeless and residual.free_symbols & {s.t for s in stops}:
        return
    if residual.free_symbols & set(stop.letters.values()):
        extra = NO_MASS if any(b.any_mass for b in course.problem.bodies) else 0.0
        kind = last.offered.principle
        yield Equation(
            residual,
            kind,
            law.words,
            stop.name,
            start.name,
            source=told,
            surcharge=law.cost + extra,
            offered=frozenset((kind,)),
        )
