"""Quantities over spans as a file asks for them: what is integrated, and what they are where they fix a state."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.errors import Undecided
from planar_cli.problem.language.expression import Quantity, Statement
from planar_cli.records import record
from planar_cli.solve.between.equations.span_rates import changed_by, rates_of
from planar_cli.solve.impulsive.impact import Blow
from planar_cli.solve.impulsive.spans import over_blow
from planar_cli.solve.regimes.gains import gained
from planar_cli.solve.regimes.potential import signed_speed
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

SOON = Decimal("1e-20")
"""So long after the first state, in seconds, a speed that is zero there has the sign that it keeps."""


@record
class SpanQuantity:
    """A quantity over a span: what is integrated, by the regime that acts (closed later, when that is worked out).

    `changes`: nothing is integrated, as it is the change of a momentum, which stands there.
    """

    quantity: Quantity
    rates: Mapping[int, tuple[sp.Expr, ...]]
    changes: bool = False

    @property
    def span(self) -> tuple[str, str]:
        at = self.quantity.at
        assert isinstance(at, tuple)
        return at


def ask_spans(course: RegimeSequence) -> dict[sp.Symbol, SpanQuantity]:
    """Everything that is asked over spans; what it needs is put on the lists of what regimes work out."""
    found: dict[sp.Symbol, SpanQuantity] = {}
    readers = course.distinct_readers()
    moving = {id(r) for r in course.regimes}
    used = set().union(*(e.free_symbols for r in readers for e in map(sp.sympify, r.exprs)))
    for reader in readers:
        for symbol, q in list(reader.spans.items()):
            if not isinstance(q.at, tuple) or symbol not in used:
                continue
            rates: dict[int, tuple[sp.Expr, ...]] = {}
            changes = bool(changed_by(q, reader.quantities()))
            for other in readers:
                if id(other.regime) in moving and id(other.regime) not in rates:
                    rates[id(other.regime)] = rates_of(q, other)
                    other.exprs += rates[id(other.regime)] if _acts_in(course, other.regime, q.at) else ()
            found[symbol] = SpanQuantity(q, rates, changes)
    return found


def _acts_in(course: RegimeSequence, regime: Regime, span: tuple[str, str]) -> bool:
    """Does a regime act in a span for some time, so that something is integrated in it? Over a blow nothing is."""
    order = {s.name: i for i, s in enumerate(course.states)}
    since, until = (order.get(name) for name in span)
    if since is None or until is None or since >= until:
        return True
    inside = zip(course.regimes, course.modes.stretches, strict=True)
    return any(r is regime and stretch.blow is None for r, stretch in list(inside)[since:until])


def tell_spans(
    course: RegimeSequence,
    spanned: Mapping[sp.Symbol, SpanQuantity],
    blows: Mapping[int, Blow],
    raw: Mapping[str, list[tuple[Statement, tuple[Any, ...]]]],
) -> None:
    """What stand-ins that stand in states are, as differences between states; they must have one regime."""
    parts = [p for found in raw.values() for _, ps in found for p in ps if isinstance(p, sp.Basic)]
    used = set().union(*(p.free_symbols for p in parts)) if parts else set()
    first = course.first
    own = [d for d in course.readers[first.name].demands(first, raw[first.name]) if d.kind == "equation"]
    for symbol, asked in spanned.items():
        if symbol in used:
            course.told[symbol] = _difference(course, asked, blows, [d.residual for d in own])


def _difference(
    course: RegimeSequence, asked: SpanQuantity, blows: Mapping[int, Blow], early: list[sp.Expr]
) -> sp.Expr:
    q = asked.quantity
    a, b = (course.stops[n] for n in asked.span)
    g = None
    order = {s.name: i for i, s in enumerate(course.states)}
    since, until = order[a.name], order[b.name]
    if all(i in blows for i in range(since, until)):
        return sp.Add(*(over_blow(blows[i], q) for i in range(since, until)))
    # Which way a path is run is told at the first state alone: there nothing may change on the way.
    passed = range(len(course.regimes)) if q.word == "path_length" else range(since, until)
    acting = {id(course.regimes[i]) for i in passed}
    reader = next((r for r in course.distinct_readers() if acting == {id(r.regime)}), None)
    if reader is not None and q.word != "count" and not any(i in blows for i in passed):
        rates = tuple(reader.closed(e) for e in asked.rates[id(reader.regime)])
        rate = signed_speed(rates[0], rates[1], reader.regime)[0] if q.word == "path_length" else rates[0]
        g = rate if asked.changes else gained(rate, reader.regime)
    if g is None:
        text = f"{q.word}(…) @ {a.name}->{b.name} has no closed form here, so it can not fix a state"
        raise Undecided(f"{q.mark.file}:{q.mark.line}: {text}")
    change = b.at(g) - a.at(g)
    if q.word == "mean":
        return change / (b.t - a.t)
    return change * _sense(course, rate, early) if q.word == "path_length" else change


def _sense(course: RegimeSequence, speed: sp.Expr, early: list[sp.Expr]) -> int:
    """Which way a motion goes that does not turn: as at the first state, of which `early` vanish."""
    first = course.first
    drawn = {first.letters[c.symbol]: c.drawn for c in course.regimes[0].coordinates if c.drawn is not None}
    for residual in (sp.sympify(e.subs(drawn)) for e in early):
        inside = residual.free_symbols & set(first.letters.values())
        if len(inside) == 1:
            own = next(iter(inside))
            letter = next(k for k, v in first.letters.items() if v == own)
            slope = sp.diff(residual, own)
            if letter in speed.free_symbols and not slope.free_symbols & inside:
                begun = course.given().known(-residual.subs(own, 0) / slope)
                if begun == 0:
                    begun = _begins(course, letter)
                number = None if begun is None else course.given().extended({letter: begun}).known(speed)
                if number is not None:
                    return -1 if number < 0 else 1
    return _sense_in_time(course, speed)


def _begins(course: RegimeSequence, letter: sp.Symbol) -> Decimal | None:
    """From rest it goes where it is accelerated: that acceleration, as drawn, or soon after where it is zero."""
    regime = course.regimes[0]
    if letter not in regime.accelerations:
        return None
    known = course.given()
    places = {c.symbol: known.known(c.drawn) for c in regime.coordinates if c.drawn is not None}
    rest = dict.fromkeys(regime.free, Decimal(0))
    start = known.extended({**{s: n for s, n in places.items() if n is not None}, **rest})
    time = known.known(course.first.letters.get(regime.time, regime.time)) or Decimal(0)
    begun = [start.extended({regime.time: t}).known(regime.accelerations[letter]) for t in (time, time + SOON)]
    return begun[0] or begun[1]


def _sense_in_time(course: RegimeSequence, speed: sp.Expr) -> int:
    """The same of a speed that is given as a function of time, as it is soon after the first state."""
    time = course.first.letters.get(course.regimes[0].time, course.regimes[0].time)
    begun = course.given().known(time)
    soon = course.given().extended({course.regimes[0].time: (begun or 0) + SOON})
    number = soon.known(speed)
    return -1 if number is not None and number < 0 else 1
