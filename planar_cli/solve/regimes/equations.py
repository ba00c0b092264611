"""The equations of a motion over several states: laws integrated from state to state, links between coordinates, loops,
what is drawn and what is stated. Each knows where it comes from.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.calculus.laws import BY_FACTOR, Moment, Span, relations
from planar_cli.calculus.limits import limit
from planar_cli.calculus.vibrations import in_letters
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import derivative, identically_zero, letters, longer, replaced, simplified
from planar_cli.equation.scene.displacement import Coordinate
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Kind
from planar_cli.errors import NOWHERE, Mark
from planar_cli.problem.language.expression import Name
from planar_cli.records import record
from planar_cli.solve.law import IN_THE_END, Law
from planar_cli.solve.regimes.constraints import fixed_by, start_of
from planar_cli.solve.regimes.costs import BESIDE, COSTS, LAST
from planar_cli.solve.regimes.effort import effort
from planar_cli.solve.regimes.mode_sequence import fixed_time
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.timeline import Demand, Stop

LONGEST = 150
"""A law with more operations has no closed integral, and stays as it is."""

DATA = ("given", "drawn", "start", "turn", "motion", "followed")


@record
class Equation:
    """What must hold: `residual` vanishes."""

    residual: sp.Expr
    kind: str
    """given, drawn, start, motion, link, loop, extreme, that of a span, or followed: in numbers alone."""
    words: str
    stop: str
    """The state at its end."""
    since: str = ""
    """The state at its beginning."""
    span: Span | None = None
    family: tuple[str, ...] = ()
    """Of which only `rank` are independent."""
    rank: int = 9
    mark: Mark = NOWHERE
    law: Law | None = None
    trend: sp.Expr | None = None
    source: Any = None
    """What it was planned from."""
    surcharge: float = 0.0
    """What it costs beside its kind; a balance, whose kind is the word of its principle, costs nothing else."""
    offered: frozenset[str] = frozenset()
    """The principles of which it is a law, by their words; none for data, geometry and blows."""
    told: bool = False
    """Is it told by a line of its own, even where it only gives something another name?"""
    of: sp.Expr | None = None
    """What is largest or smallest in time where it holds, in the letters of the state."""

    @property
    def cost(self) -> float:
        extra = 0.0
        if self.span is not None:
            extra = LAST if self.span.words == BY_FACTOR else 1.0 if self.span.unevaluated else 0.0
        if self.law is not None:
            extra += self.law.effort + (BESIDE if (self.kind, self.law.order) == ("t(q)", 1) else 0.0)
        return COSTS.get(self.kind, 0.0) + extra + self.surcharge


@record
class Link:
    """A coordinate that follows others: its change is Σ factor · change of other + ∫ drift dt."""

    coordinate: Coordinate
    factors: Mapping[sp.Symbol, sp.Expr]
    drift: sp.Expr


@record
class Laws:
    """All that is known of a regime. `loose`: coordinates that only loops, or only numbers, can follow."""

    laws: tuple[Law, ...]
    links: tuple[Link, ...]
    loose: tuple[Coordinate, ...]


def laws_of(regime: Regime) -> Laws:
    """Sort the coordinates of a regime: with a law of their own, linked to others, or loose."""
    masters = _masters(regime)
    varying = set(regime.letters)
    links: list[Link] = []
    laws: list[Law] = []
    loose: list[Coordinate] = []
    driven: list[Coordinate] = []
    rest: list[Coordinate] = []
    for c in regime.coordinates:
        rate = regime.rates[c.symbol]
        if c.symbol in masters.values():
            continue
        if not rate.free_symbols & set(regime.free):
            if rate.free_symbols & varying <= {regime.time, c.symbol}:
                laws.append(Law(c, 1, rate, sp.Dummy("v", real=True)))
            else:
                rest.append(c)
        else:
            driven.append(c)
    for c in (*driven, *rest):
        link = _link(regime, c, masters)
        if link is None:
            loose.append(c)
        else:
            links.append(link)
    for u, symbol in masters.items():
        law = _second_order(regime, u, symbol, links, laws)
        c = next(c for c in regime.coordinates if c.symbol == symbol)
        if law is None:
            loose.append(c)
        else:
            laws.append(law)
    return Laws(tuple(laws), tuple(links), tuple(loose))


def _masters(regime: Regime) -> dict[sp.Symbol, sp.Symbol]:
    """For each free speed the coordinate that grows with it at a constant ratio; ratio 1 first."""
    found: dict[sp.Symbol, tuple[int, sp.Symbol]] = {}
    varying = set(regime.letters)
    for c in regime.coordinates:
        rate = regime.rates[c.symbol]
        for u in regime.free:
            if u not in rate.free_symbols:
                continue
            factor = simplified(rate / u)
            if factor.free_symbols & varying:
                continue
            rank = 0 if factor == 1 else 1
            if u not in found or rank < found[u][0]:
                found[u] = (rank, c.symbol)
    return {u: symbol for u, (_, symbol) in found.items()}


def _link(regime: Regime, c: Coordinate, masters: Mapping[sp.Symbol, sp.Symbol]) -> Link | None:
    """Constant ratios to the rates of the masters, and a drift that depends on time alone."""
    rate = expanded(regime.rates[c.symbol])
    varying = set(regime.letters)
    factors: dict[sp.Symbol, sp.Expr] = {}
    for u in regime.free:
        part = rate.coeff(u)
        if part == 0:
            continue
        if u not in masters:
            return None
        ratio = simplified(part * u / regime.rates[masters[u]])
        if ratio.free_symbols & varying:
            return None
        factors[masters[u]] = ratio
        rate = expanded(rate - part * u)
    if rate.free_symbols & (varying - {regime.time}):
        return None
    return Link(c, factors, simplified(rate))


def _second_order(
    regime: Regime, u: sp.Symbol, symbol: sp.Symbol, links: Iterable[Link], laws: Sequence[Law]
) -> Law | None:
    """q̈ = factor · f(t, q, q̇/factor), coordinates that are linked to q put in."""
    c = next(c for c in regime.coordinates if c.symbol == symbol)
    factor = simplified(regime.rates[symbol] / u)
    f = regime.accelerations[u] * factor
    for link in links:
        other = link.coordinate.symbol
        if other in letters(f) and set(link.factors) == {symbol} and link.drift == 0:
            f = f.subs(other, _linked_place(regime, link, c))
    f = replaced(f, _timed(regime))
    v = sp.Dummy("v", real=True)
    f = replaced(f, {u: v / factor})
    f = f if longer(f, LONGEST) else simplified(f)
    if letters(f) & (set(regime.letters) - {regime.time, symbol}):
        return None
    roles = regime.general.instant.scene.ledger.roles
    if any(roles[s].kind is Kind.ACCELERATION for s in letters(f) if s in roles):
        return None
    return Law(c, 2, f, v, u, factor, effort(regime, f), not letters(f) & set(regime.letters))


def _linked_place(regime: Regime, link: Link, master: Coordinate) -> sp.Expr:
    """A coordinate that follows another: as what joins them now says, else as they were when that took hold, else as
    they are drawn.
    """
    other, symbol = link.coordinate, master.symbol
    pair, own = {other.symbol, symbol}, {s for c in regime.coordinates for s in (c.symbol, c.start)}
    for constraint in regime.general.constraints:
        slope = derivative(constraint.residual, other.symbol)
        if constraint.residual.free_symbols & own == pair and slope != 0 and not slope.free_symbols & own:
            return simplified(other.symbol - constraint.residual / slope)
    taken = any(pair <= k.residual.free_symbols for k in regime.general.kept)
    start = {c.symbol: c.start for c in (other, master)} if taken else start_of(regime.coordinates)
    return start[other.symbol] + link.factors[symbol] * (symbol - start[symbol])


def _timed(regime: Regime) -> dict[sp.Symbol, sp.Expr]:
    """Coordinates that `motion` gives as functions of time, such as that of a shaken base."""
    own, varying = {c.symbol for c in regime.coordinates}, set(regime.letters)
    found: dict[sp.Symbol, sp.Expr] = {}
    for constraint in regime.general.constraints:
        inside = constraint.residual.free_symbols & own
        if constraint.kind != "motion" or len(inside) != 1:
            continue
        (symbol,) = inside
        slope = derivative(constraint.residual, symbol)
        place = simplified(symbol - constraint.residual / slope) if not slope.free_symbols & varying else symbol
        if place.free_symbols & varying <= {regime.time}:
            found[symbol] = place
    return found


# --- equations -------------------------------------------------------------------------------------------------------


def law_equations(laws: Laws, since: Stop, stop: Stop, regime: Regime, value: Valuation) -> Iterator[Equation]:
    """What the laws say between two states of one regime."""
    time = regime.time
    for law in laws.laws:
        q = law.coordinate.symbol
        v0, v1 = sp.Dummy("v_0", real=True), sp.Dummy("v", real=True)
        start = Moment(since.letters[time], since.letters[q], v0)
        end = Moment(stop.letters[time], stop.letters[q], v1)
        named = {v0: _speed(law, since), v1: _speed(law, stop)}
        plain = {k: v for k, v in named.items() if v.is_Symbol}
        start, end = (Moment(m.t, m.q, plain.get(m.v, m.v)) for m in (start, end))
        f = replaced(law.f, {time: end.t, q: end.q, law.v: end.v})
        f = replaced(f, {c.start: since.letters[c.symbol] for c in regime.coordinates})
        others = {k: v for k, v in named.items() if not v.is_Symbol}
        family = ("law", q.name, since.name, stop.name)
        known = value if law.constant is None else value.defining(dict([law.constant]))
        spans = relations(law.order, f, start, end, _signs(known, named, since, regime), lean=True)
        if law.vibration is not None:
            spans = in_letters(spans, law.vibration, time, start, end)
        explicit = any(s.kind == "q(t)" for s in spans)
        begun = {c.start: since.letters[c.symbol] for c in regime.coordinates if c.drawn is not None}
        told = replace(law, f=replaced(law.f, begun))
        for span in spans:
            beside = explicit and span.kind == "t(q)" and (law.order == 2 or span.unevaluated)
            if (law.order == 1 and span.kind.startswith("v")) or beside:
                continue
            shown = _renamed(span, others)
            yield Equation(
                shown.residual, span.kind, span.words, stop.name, since.name, shown, family, law.order, law=told
            )


def _speed(law: Law, stop: Stop) -> sp.Expr:
    if law.speed is None:
        return sp.Dummy("v", real=True)
    return law.factor * stop.letters[law.speed]


def _renamed(span: Span, names: Mapping[sp.Symbol, sp.Expr]) -> Span:
    def put(expr: Any) -> Any:
        return expr.xreplace(dict(names)) if isinstance(expr, sp.Basic) else expr

    return replace(
        span,
        left=put(span.left),
        right=put(span.right),
        residual=put(span.residual),
        explicit=put(span.explicit),
        where=tuple(put(w) for w in span.where),
    )


def _signs(value: Valuation, named: Mapping[sp.Symbol, sp.Expr], since: Stop, regime: Regime) -> Valuation:
    """A valuation that also knows the letters of the start, which it does not know, as they were drawn, for signs."""
    letters = {s: since.letters[s] for s in regime.letters if s in since.letters and s in value.values}
    more = {own: value(s) for s, own in letters.items() if own not in value.values}
    extended = value.extended(more)
    return extended.extended({d: extended(e) for d, e in named.items() if e.free_symbols <= set(extended.values)})


def link_equations(laws: Laws, since: Stop, stop: Stop, regime: Regime) -> Iterator[Equation]:
    """Changes of coordinates that follow others."""
    time = regime.time
    for link in laws.links:
        q = link.coordinate.symbol
        parts = [f * (stop.letters[s] - since.letters[s]) for s, f in link.factors.items()]
        drift: sp.Expr = sp.S.Zero
        if link.drift != 0:
            x = sp.Dummy("t", real=True)
            body = sp.integrate(expanded(link.drift.xreplace({time: x})), x)
            drift = body.xreplace({x: stop.letters[time]}) - body.xreplace({x: since.letters[time]})
        residual = stop.letters[q] - since.letters[q] - sp.Add(*parts) - drift
        words = f"{link.coordinate.words} follows"
        yield Equation(residual, "link", words, stop.name, since.name, family=("link", q.name, stop.name), rank=1)


def loop_equations(regime: Regime, first: Stop, stop: Stop) -> Iterator[Equation]:
    """Positions that close loops, at one state."""
    start = {c.start: first.letters[c.symbol] for c in regime.coordinates if c.drawn is None}
    for n, c in enumerate(regime.general.constraints):
        residual = stop.at(c.residual.xreplace(start))
        if not identically_zero(residual):
            yield Equation(residual, c.kind, c.title, stop.name, family=("loop", str(n), stop.name), rank=1)


def kept_equations(regime: Regime, since: Stop, stop: Stop) -> Iterator[Equation]:
    """What a joint keeps that took hold after the first state."""
    for c in regime.general.kept:
        residual = simplified(_squared(stop.at(c.residual) - since.at(c.residual)))
        if residual != 0:
            yield Equation(residual, "loop", c.title, stop.name, since.name)


def _squared(change: sp.Expr) -> sp.Expr:
    """a² - b² instead of a - b for two square roots (lengths), which vanishes with it."""
    roots = [t for t in sp.Add.make_args(change) if t.is_Pow and t.exp == sp.S.Half]
    less = [-t for t in sp.Add.make_args(change) if (-t).is_Pow and (-t).exp == sp.S.Half]
    if len(roots) == len(less) == 1 and len(sp.Add.make_args(change)) == 2:
        return roots[0].base - less[0].base
    return change


def drawn_equations(regime: Regime, first: Stop) -> Iterator[Equation]:
    """The first state is as drawn, but for what `motion` places elsewhere."""
    placed = _placed_elsewhere(regime, first)
    for c in regime.coordinates:
        if c.symbol in placed:
            continue
        if c.drawn is not None and not c.drawn.free_symbols & {k.symbol for k in regime.coordinates}:
            residual = first.letters[c.symbol] - c.drawn
            family = ("drawn", c.symbol.name)
            yield Equation(residual, "drawn", "as drawn", first.name, family=family, rank=1, told=c.unit == "rad")


def _placed_elsewhere(regime: Regime, first: Stop) -> frozenset[sp.Symbol]:
    """Coordinates that relations about places fix at the time of the first state, not where they are drawn."""
    constraints = regime.general.constraints
    held = [c for c in constraints if c.kind == "motion"]
    if not held:
        return frozenset()
    symbols = tuple(c.symbol for c in regime.coordinates)
    value = regime.general.instant.scene.valuations[0]
    driven = fixed_by(constraints, symbols, value)
    stated = fixed_time(first.relations)
    if stated is not None or not first.relations:
        side = stated.right if stated is not None and isinstance(stated.left, Name) else getattr(stated, "left", None)
        time = value(regime.general.instant.scene.value(side)) if side is not None else Decimal(0)
        drawn = {c.symbol: value(c.drawn) for c in regime.coordinates if c.drawn is not None}
        there = value.extended({**drawn, regime.time: time})
        if driven <= set(drawn) and all(there.is_zero(c.residual) for c in held):
            return frozenset()
    return driven


def at_limits(equations: list[Equation], infinite: Mapping[sp.Symbol, sp.Expr], value: Valuation) -> list[Equation]:
    """Relations of states at infinity: their limits, where these are finite; and what no longer changes there."""
    found = []
    for e in equations:
        letters = [s for s in infinite if s in e.residual.free_symbols]
        if not letters:
            found.append(e)
            continue
        if e.kind in DATA or e.residual.has(sp.Integral):
            continue
        residual: sp.Expr | None = e.residual
        for letter in letters:
            flipped = (
                residual.xreplace({letter: -letter}) if residual is not None and infinite[letter] < 0 else residual
            )
            residual = None if flipped is None else limit(flipped, letter, value)
        if residual is not None and residual.free_symbols:
            found.append(replace(e, residual=residual, words=f"{e.words}, in the limit"))
    return found


def ending_equations(laws: Laws, stop: Stop, regime: Regime) -> Iterator[Equation]:
    """After a very long time a speed that tends to a limit no longer changes: q̈ = f(v) = 0."""
    for law in laws.laws:
        if law.order != 2 or law.speed is None or law.f.free_symbols & {regime.time, law.coordinate.symbol}:
            continue
        if sp.diff(law.f, law.v) == 0:
            continue
        residual = law.f.xreplace({law.v: _speed(law, stop)})
        yield Equation(residual, "given", IN_THE_END, stop.name)


def stated_equations(demands: Iterable[Demand], kind: str = "given") -> Iterator[Equation]:
    """The equations among what the file states of a state, or (kind "motion") of places at all times."""
    for d in demands:
        if d.kind == "equation":
            yield Equation(d.residual, kind, d.text, d.state, mark=d.mark, trend=d.trend)
