"""Small oscillations about an equilibrium state: the equations of motion linearised there.

With s the small deviation that grows with a free speed u (ds/dt = u), and du/dt = f(q, u):

    s̈ + c ṡ + ω₀² s = 0        ω₀² = -Σ ∂f/∂q dq/ds        c = -∂f/∂u        T = 2π/√(ω₀² - c²/4)
    δ = ln(s_n/s_n+1) = c T/2        ζ = c/(2 ω₀)

With several free speeds ω₀² and c are matrices; the roots λ of their characteristic equation tell periods and
stability. SI units.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import mpmath
import sympy as sp

from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.equation.algebra.plain import derivative, identically_zero, simplified
from planar_cli.equation.values.exact import DIGITS, Sample, Unvalued, Valuation
from planar_cli.equation.values.ledger import at_state
from planar_cli.errors import Diagnostic, FileProblem, Mark, NoSolution, NoValue, Undecided, undecided_at
from planar_cli.problem.language.expression import Quantity, Statement
from planar_cli.problem.language.walk import walk
from planar_cli.problem.language.words import OF_SWINGS
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.solve.between.trace.oscillation_trace import Verdict
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Stop

HIGHEST = 5
"""Where the linear term vanishes, terms up to this power of the deviation are looked at."""
SLOW = mpmath.mpf("1e-25")


@record
class Oscillation:
    """The motion near one equilibrium state."""

    stop: Stop
    regime: Regime
    speeds: tuple[sp.Symbol, ...]
    """The free speeds u; a rotation that enters no force is left out, as is what `motion` drives. Where periods alone
    are asked, so is a travel that enters none, like that of a free cart.
    """
    laws: tuple[sp.Expr, ...]
    """du/dt of each, a formula of the general position."""
    stiffness: tuple[tuple[sp.Expr, ...], ...]
    """The entries of ω₀² in letters of the state, row by row."""
    damping: tuple[tuple[sp.Expr, ...], ...]
    """The same of c."""
    places: Mapping[sp.Symbol, sp.Expr]
    """The coordinates that the state tells."""

    @property
    def single(self) -> bool:
        return len(self.speeds) == 1

    @property
    def square(self) -> sp.Expr:
        """ω₀² - c²/4 of one freedom: the square of the circular frequency."""
        w2, c = self.stiffness[0][0], self.damping[0][0]
        return w2 if c == 0 else w2 - c**2 / 4

    @property
    def period(self) -> sp.Expr:
        # A damped one is a difference under the root: its reciprocal would be looked into for signs that nobody knows.
        root = sp.sqrt(1 / self.square) if self.damping[0][0] == 0 else 1 / sp.sqrt(self.square)
        return 2 * sp.pi * root

    @property
    def frequency(self) -> sp.Expr:
        """In Hz."""
        return sp.sqrt(self.square) / (2 * sp.pi)

    def decrement(self, period: sp.Expr | None) -> sp.Expr:
        """ln of the ratio of two deviations a period apart. `period`: what it is stated to be."""
        return self.damping[0][0] * (self.period if period is None else period) / 2

    def damping_ratio(self, period: sp.Expr | None) -> sp.Expr:
        """The damping as a part of the critical one: ζ = c/(2 ω₀), and with a period ζ = δ/√(4π² + δ²)."""
        if period is None:
            return self.damping[0][0] / (2 * sp.sqrt(self.stiffness[0][0]))
        decrement = self.decrement(period)
        return decrement / sp.sqrt(4 * sp.pi**2 + decrement**2)

    def told(self, word: str, period: sp.Expr | None) -> sp.Expr:
        """One of the quantities of a single freedom, by its word."""
        if word in ("period", "frequency"):
            return self.period if word == "period" else self.frequency
        return self.decrement(period) if word == "decrement" else self.damping_ratio(period)


def linearised(regime: Regime, stop: Stop, places: Mapping[sp.Symbol, sp.Expr], travels: bool = True) -> Oscillation:
    """The equations of motion of a regime, linearised about an equilibrium. `places`: coordinates that are known there;
    `travels`: does it matter that something may travel away from there, though no force changes?
    FileProblem: there is nothing to swing.
    """
    speeds = regime.free
    if not speeds:
        text = f"state {stop.name}: nothing is free to move, so nothing can oscillate"
        raise FileProblem([Diagnostic(stop.mark, "PL631", text, "leave a coordinate free of `motion` and of friction")])
    still = dict.fromkeys(speeds, sp.S.Zero)
    rates = {q: {u: simplified(derivative(r, u)) for u in speeds if r.has(u)} for q, r in regime.rates.items()}
    drift = {q: r.xreplace(still) for q, r in regime.rates.items()}
    laws = tuple(regime.accelerations[u] for u in speeds)
    for law in laws:
        _demand_steady(law, drift, regime, stop)

    def at_rest(expr: sp.Expr) -> sp.Expr:
        # Places are put in before anything is simplified: there most terms vanish.
        return stop.at(expr.xreplace({**still, **places}))

    stiffness = [[at_rest(-_slope(law, u, rates)) for u in speeds] for law in laws]
    damping = [[at_rest(-derivative(law, u)) for u in speeds] for law in laws]
    general = regime.general
    driven = general.trial.system.driven() if general.instant.scene.problem.motion else set()
    beside = [not travels or _turns_only(regime, u) or general.rate_of(u) in driven for u in speeds]
    free = [j for j, idle in enumerate(beside) if idle and _enters_nothing(j, stiffness, damping)]
    kept = [j for j in range(len(speeds)) if j not in free] or list(range(len(speeds)))

    def of_kept(rows: list[list[sp.Expr]]) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(tuple(rows[i][j] for j in kept) for i in kept)

    own = tuple(speeds[j] for j in kept), tuple(laws[j] for j in kept)
    return Oscillation(stop, regime, *own, of_kept(stiffness), of_kept(damping), places)


def _stated_places(
    regime: Regime, raw: Iterable[tuple[Statement, tuple[Any, ...]]], known: Container[sp.Symbol]
) -> dict[sp.Symbol, sp.Expr]:
    """The coordinates that relations of a state tell one by one. `raw`: the relations in the general position."""
    own = {c.symbol for c in regime.coordinates}
    told: dict[sp.Symbol, sp.Expr] = {}
    for _, parts in raw:
        try:
            form = linear_form(parts[1], own) if parts[0] == "=" else None
        except Nonlinear:
            continue
        if form is None or len(form.terms) != 1:
            continue
        ((coordinate, factor),) = form.terms.items()
        if factor.is_number and all(s in known for s in form.constant.free_symbols):
            told.setdefault(coordinate, -form.constant / factor)
    return told


def _turns_only(regime: Regime, u: sp.Symbol) -> bool:
    """Is a free speed that of a rotation?"""
    moved = [c for c in regime.coordinates if regime.rates[c.symbol].has(u)]
    return bool(moved) and all(c.unit == "rad" for c in moved)


def _enters_nothing(j: int, stiffness: list[list[sp.Expr]], damping: list[list[sp.Expr]]) -> bool:
    """Does no law change with a deviation of this freedom, or with its speed?"""
    return all(identically_zero(row[j]) for row in (*stiffness, *damping))


def _slope(law: sp.Expr, u: sp.Symbol, rates: dict[sp.Symbol, dict[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """How a law changes with the deviation of a free speed: all coordinates that follow it change."""
    return sp.Add(*(derivative(law, q) * own[u] for q, own in rates.items() if u in own and law.has(q)))


def _demand_steady(law: sp.Expr, drift: dict[sp.Symbol, sp.Expr], regime: Regime, stop: Stop) -> None:
    """The law may depend neither on time nor on what `motion` drives."""
    if law.has(regime.time) or any(law.has(q) and d != 0 for q, d in drift.items()):
        text = f"state {stop.name}: the equation of motion changes with time, so the equilibrium does not last"
        raise FileProblem([Diagnostic(stop.mark, "PL631", text, "an equilibrium needs forces that stay the same")])


# --- quantities about states -----------------------------------------------------------------------------------------


def oscillations_asked(
    course: RegimeSequence, raw: Mapping[str, Iterable[tuple[Statement, tuple[Any, ...]]]]
) -> dict[str, Oscillation]:
    """The oscillations that period(s), decrement(s), stable(s) and the like ask about, by state. `raw`: what the
    equilibrium states say, in the general position.
    """
    found: dict[str, Oscillation] = {}
    for q in _asked(course):
        name = q.things[0]
        if name not in {s.name for s, _ in course.modes.equilibria}:
            text = f"{q.word}({name}): state {name} is no equilibrium"
            raise FileProblem([Diagnostic(q.mark, "PL631", text, f"write `{name}: [equilibrium, …]` in `states`")])
        if name not in found:
            regime, known = course.readers[name].regime, course.given().values
            places = _stated_places(regime, raw[name], known)
            words = {asked.word for asked in _asked(course) if asked.things[0] == name}
            found[name] = linearised(regime, course.stops[name], places, "stable" in words)
    return found


def periods(
    course: RegimeSequence,
    swings: Mapping[str, Oscillation],
    raw: Mapping[str, Iterable[tuple[Statement, tuple[Any, ...]]]],
) -> dict[sp.Symbol, sp.Expr]:
    """What period(s), frequency(s), decrement(s) and damping_ratio(s) of one freedom are, in letters of their states.
    NoSolution: a state gives that of several freedoms. `raw`: what the equilibrium states say.
    """
    told = {}
    stated = {n for state in course.problem.states for r in state.relations for n in walk(r)}
    for reader in course.distinct_readers():
        for symbol, q in reader.spans.items():
            if q.word in OF_SWINGS and swings[q.things[0]].single:
                name = q.things[0]
                period = _stated_period(course, raw[name]) if q in stated else None
                told[symbol] = swings[name].told(q.word, period)
            elif q.word in OF_SWINGS and q in stated:
                count = len(swings[q.things[0]].speeds)
                text = f"about {q.things[0]} there are {count} freedoms, and `{q.word}({q.things[0]})` is of one alone"
                hint = "leave one free to swing: hold the others by `motion`, or draw each body in a case of its own"
                raise NoSolution([Diagnostic(q.mark, "PL632", text, hint)])
    return told


def _stated_period(course: RegimeSequence, raw: Iterable[tuple[Statement, tuple[Any, ...]]]) -> sp.Expr | None:
    """The period that relations of a state give, themselves or by its frequency, in constants of the file; None: none.
    With it what goes with the damping alone stays apart from what goes with the stiffness.
    """
    spans = {symbol: q for reader in course.distinct_readers() for symbol, q in reader.spans.items()}
    varying = {s for regime in course.distinct_regimes() for s in regime.letters}.union(spans)
    for _, parts in raw:
        for symbol in parts[1].free_symbols & spans.keys() if parts[0] == "=" else ():
            try:
                form = linear_form(parts[1], [symbol])
            except Nonlinear:
                continue
            word, factor = spans[symbol].word, form.terms.get(symbol)
            if word in ("period", "frequency") and factor is not None and factor.is_number:
                size = -form.constant / factor
                if not size.free_symbols & varying and size != 0:
                    return size if word == "period" else 1 / size
    return None


def placed(course: RegimeSequence, found: Oscillation) -> Oscillation:
    """With the place of the equilibrium put in."""
    reader = course.readers[found.stop.name]

    def put(rows: tuple[tuple[sp.Expr, ...], ...]) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(tuple(simplified(reader.settled(e)) for e in row) for row in rows)

    return replace(found, stiffness=put(found.stiffness), damping=put(found.damping))


def check_oscillations(course: RegimeSequence, swings: Mapping[str, Oscillation], value: Valuation) -> None:
    """NoSolution: a period that is asked for does not exist, or has to be the only one and is not. Undecided: letters
    leave open whether the equilibrium is stable.
    """
    # What a state says of it may be that it just ceases to oscillate: frequency(s) = 0.
    stated = {n for state in course.problem.states for r in state.relations for n in walk(r)}
    for q in _asked(course):
        found = swings[q.things[0]]
        modes = asked_of_modes(course.problem, found, q)
        if isinstance(value, Sample) and (q.word == "stable" or modes or not _swings(found, value)):
            demand_everywhere(placed(course, found), q, value, course.scene.everywhere())
        if q.word in OF_SWINGS and not modes and not (q in stated and value.is_zero(found.square)):
            _demand_period(swings[q.things[0]], q, value)


def asked_of_modes(problem: Problem, found: Oscillation, q: Quantity) -> bool:
    """Is a period or frequency about an equilibrium with several freedoms asked for by itself, so that each mode
    answers? Inside a formula it would have to be one number.
    """
    if found.single or q.word not in OF_SWINGS:
        return False
    asked = (f.found.what for f in problem.find)
    inside = (n for what in asked for n in walk(what) if n is not what and isinstance(n, Quantity))
    return all((n.word, n.things) != (q.word, q.things) for n in inside)


def periods_asked(course: RegimeSequence) -> set[str]:
    """The equilibrium states about which a period is asked, or what goes with one."""
    return {q.things[0] for q in _asked(course) if q.word in OF_SWINGS}


def _swings(found: Oscillation, value: Valuation) -> bool:
    """Does it oscillate with these numbers?"""
    return not found.single or (stability(found, value).stable and value(found.square) > 0)


def _asked(course: RegimeSequence) -> Iterator[Quantity]:
    spans = (q for reader in course.distinct_readers() for q in reader.spans.values())
    return (q for q in spans if q.word in (*OF_SWINGS, "stable"))


def _demand_period(found: Oscillation, q: Quantity, value: Valuation) -> None:
    state = found.stop.name
    if not found.single:
        text = f"{len(found.speeds)} freedoms have no single period about {state}"
        hint = f"ask `{q.word}({state})` by itself: then each mode has its answer"
        if isinstance(value, Sample):
            raise _no_period(q.mark, text, hint)
        periods = [f"{mpmath.nstr(2 * mpmath.pi / abs(r.imag), 6)} s" for r in roots_of(found, value) if r.imag > SLOW]
        raise _no_period(q.mark, f"{text}: {', '.join(dict.fromkeys(periods)) or 'none'}", hint)
    if not stability(found, value).stable:
        raise _no_period(q.mark, f"the equilibrium {state} is not stable, so nothing oscillates about it")
    square = value(found.square)
    if q.word != "damping_ratio" and (value.is_zero(found.square) or square < 0):
        how = "critically damped" if value.is_zero(found.square) else "overdamped"
        raise _no_period(q.mark, f"{how}: it creeps back to {state} without oscillating")


def _no_period(mark: Mark, text: str, hint: str = "ask `stable(…)` instead") -> NoSolution:
    return NoSolution([Diagnostic(mark, "PL632", text, hint)])


# --- stability -------------------------------------------------------------------------------------------------------


def stability(found: Oscillation, value: Valuation) -> Verdict:
    """Does a small deviation stay small? With a number for every letter; Undecided: letters leave it open."""
    try:
        return _single(found, value) if found.single else _several(found, value)
    except (Unvalued, NoValue) as error:
        why = f"nothing tells {at_state(str(error))}" if isinstance(error, Unvalued) else str(error)
        raise undecided_at(found.stop.mark, f"the stability of {found.stop.name} is not decided: {why}") from error


def demand_everywhere(found: Oscillation, q: Quantity, value: Valuation, draws: Iterable[Valuation]) -> None:
    """Undecided: what becomes of a small deviation depends on letters that have no numbers. `found`: with the place of
    the equilibrium put in.
    """
    entries = [e for rows in (found.stiffness, found.damping) for row in rows for e in row]
    letters = set().union(*(e.free_symbols for e in entries)) & value.drawn
    if not letters:
        return
    kinds = {kind for draw in draws if (kind := _kind(found, draw)) is not None}
    if len(kinds) > 1:
        named = ", ".join(sorted(s.name for s in letters))
        what = f"`{q.word}({found.stop.name})` depends on {named}, which have no numbers"
        square = f": it is stable where {found.stiffness[0][0]} > 0".replace("**", "^") if found.single else ""
        raise Undecided(f"{q.mark.file}:{q.mark.line}: {what}{square}; `assume` says which of them is larger")


def _kind(found: Oscillation, draw: Valuation) -> tuple[int, ...] | None:
    """What kind of motion a small deviation is, by signs; None: with these numbers there is no such place."""
    try:
        if not found.single:
            return (int(_several(found, draw).stable),)
        terms = (found.stiffness[0][0], found.damping[0][0])
        return tuple(0 if draw.is_zero(e) else 1 if draw(e) > 0 else -1 for e in terms)
    except (NoValue, Unvalued):
        return None


def _single(found: Oscillation, value: Valuation) -> Verdict:
    w2, c = found.stiffness[0][0], found.damping[0][0]
    damped = 0 if value.is_zero(c) else 1 if value(c) > 0 else -1
    if damped < 0:
        return Verdict("unstable")
    if not value.is_zero(w2):
        return Verdict("stable" if value(w2) > 0 else "unstable")
    u, law = found.speeds[0], found.laws[0]
    rates = {q: {u: derivative(r, u)} for q, r in found.regime.rates.items() if r.has(u)}
    slope = law.xreplace({u: sp.S.Zero})
    for power in range(1, HIGHEST + 1):
        slope = _slope(slope, u, rates)
        there = found.stop.at(slope)
        if power > 1 and not value.is_zero(there):
            held = power % 2 and value(there) < 0
            return Verdict("stable" if held else "unstable", power)
    return Verdict("indifferent")


def _several(found: Oscillation, value: Valuation) -> Verdict:
    roots = roots_of(found, value)
    size = max(abs(r) for r in roots)
    growth = max(r.real for r in roots)
    if growth > SLOW * size:
        return Verdict("unstable")
    return Verdict("indifferent" if min(abs(r) for r in roots) <= SLOW * size else "stable")


def roots_of(found: Oscillation, value: Valuation) -> list[mpmath.mpc]:
    """The roots λ of the characteristic equation: a motion e^(λt)."""
    n = len(found.speeds)
    with mpmath.workdps(DIGITS):
        matrix = mpmath.zeros(2 * n)
        for i in range(n):
            matrix[i, n + i] = 1
            for j in range(n):
                matrix[n + i, j] = -mpmath.mpf(str(value(found.stiffness[i][j])))
                matrix[n + i, n + j] = -mpmath.mpf(str(value(found.damping[i][j])))
        return sorted(mpmath.eig(matrix, left=False, right=False), key=lambda r: (r.imag, r.real))
