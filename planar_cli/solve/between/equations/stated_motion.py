"""What a file states of the states of a motion, as equations between their symbols; the regimes worked out for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, derivative
from planar_cli.equation.system.conditions import order
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.language.expression import JustAfter, Relation, Statement
from planar_cli.problem.scene.scene import State
from planar_cli.records import record
from planar_cli.solve.between.equations.equilibria import Equilibria, solve_equilibria
from planar_cli.solve.between.equations.laws_between import LawsBetween
from planar_cli.solve.between.equations.oscillation import Oscillation, oscillations_asked, periods
from planar_cli.solve.between.equations.span_quantities import SpanQuantity, ask_spans, tell_spans
from planar_cli.solve.impulsive.impact import Blow, arriving, make_blow
from planar_cli.solve.regimes.constant_rates import ConstantRates, constant_rates
from planar_cli.solve.regimes.equations import Laws, laws_of
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Demand
from planar_cli.solve.regimes.transfer import transfer_of
from planar_cli.solve.regimes.vibrations import with_vibrations


@record
class StatedMotion(RegimeSequence):
    """The regimes of a sequence of modes, worked out, with all that is stated of its states."""

    laws: tuple[Laws, ...]
    """By regime: how its coordinates move."""
    demands: Mapping[str, Sequence[Demand]]
    """By state: what the file states of it."""
    placed: Mapping[str, Sequence[Demand]]
    """By state: what `motion` says of places all the time."""
    equilibria: Equilibria
    """The equilibrium states, solved."""
    beside: Mapping[str, list[tuple[Statement, tuple[Any, ...]]]]
    """By equilibrium state: what it says, with its expressions in the unknowns of the general position."""
    spanned: Mapping[sp.Symbol, SpanQuantity]
    """Quantities over spans, by what stands for them."""
    swings: Mapping[str, Oscillation]
    """By equilibrium state that is asked about: small oscillations about it."""
    blows: Mapping[int, Blow]
    """`blows[i]`: the impacts and impulses between state i and the next."""
    transfers: Mapping[int, Mapping[sp.Symbol, sp.Expr]]
    """By the id of a regime: the free speeds and places of others in its own motion, not yet closed."""
    said: Mapping[int, tuple[sp.Expr, ...]]
    """By the id of a regime: what the file states and asks in it."""
    between: LawsBetween
    """Laws of energy and momentum between states."""
    rates: ConstantRates
    """Rates that do not change, by letters."""

    def infinite(self) -> dict[sp.Symbol, sp.Expr]:
        """Letters that become infinite in their state, each to the side that is stated."""
        found = {}
        value = self.base()
        for state in self.states:
            for d in self.demands[state.name]:
                if d.kind == "limit":
                    letter = max(
                        by_name(d.residual.free_symbols), key=lambda s: s in self.stops[state.name].letters.values()
                    )
                    found[letter] = sp.oo if value(derivative(d.residual, letter)) > 0 else -sp.oo
        return found

    def is_set(self, state: State) -> bool:
        """Is the time of a state fixed by something else than what is largest there, as that just after a blow?"""
        struck = any(isinstance(r, JustAfter) for r in state.relations)
        return struck or any(d.kind == "equation" for d in self.demands[state.name])

    def transfer(self, regime: Regime) -> dict[sp.Symbol, sp.Expr]:
        """Letters of other regimes as formulas of this one."""
        other = {s for r in self.distinct_regimes() for s in r.letters} - set(regime.letters)
        found = {u: regime.closed(e) for u, e in self.transfers[id(regime)].items()}
        return {u: e for u, e in found.items() if not e.free_symbols & other}

    def base(self) -> Valuation:
        """Numbers of everything that is known, also of the equilibrium states."""
        return self.given().extended(self.equilibria.branch.values).defining(self.rates.formulas)

    def settled(self) -> dict[sp.Symbol, Decimal]:
        """The constants that are sought and that an equilibrium tells."""
        return told_constants(self, self.equilibria)

    def parameters(self) -> set[sp.Symbol]:
        """What has no number of its own: letters of the file, as they were drawn."""
        return set(self.base().drawn)


def stated_motion(motion: RegimeSequence) -> StatedMotion:
    """Read all states, and work out every regime for what they need."""
    states, readers, stops = motion.states, motion.readers, motion.stops
    raw = {s.name: readers[s.name].raw(s.relations) for s in states}
    always = {s.name: readers[s.name].raw(_places(motion, i)) for i, s in enumerate(states)}
    beside = {s.name: readers[s.name].raw(s.relations) for s, _ in motion.modes.equilibria}
    spanned = ask_spans(motion)
    said = {id(r.regime): tuple(r.exprs) for r in motion.distinct_readers()}
    transfers = _ask_transfers(motion)
    between = LawsBetween()
    _work(motion, between)
    placed = {s.name: readers[s.name].demands(stops[s.name], always[s.name]) for s in states}
    blows = _blows(motion, placed)
    between.close(motion.regimes)
    swings = oscillations_asked(motion, beside)
    motion.told.update(periods(motion, swings, beside))
    if spanned:
        tell_spans(motion, spanned, blows, raw)
    demands = {s.name: readers[s.name].demands(stops[s.name], raw[s.name]) for s in states}
    equilibria = solve_equilibria(motion, beside, demands)
    laws = tuple(laws_of(r) if r.runs else Laws((), (), ()) for r in motion.regimes)
    begins = [state.name for state in states][: len(laws)]
    value = motion.given().extended(told_constants(motion, equilibria))
    naming = (motion.regimes, begins, value, motion.ledger, motion.workshop.letters)
    rates = constant_rates(laws, *naming)
    laws, vibrating = with_vibrations(rates.laws, *naming)
    rates = replace(rates, formulas={**rates.formulas, **vibrating})
    return StatedMotion(
        **motion.parts(),
        laws=laws,
        demands=demands,
        placed=placed,
        equilibria=equilibria,
        beside=beside,
        spanned=spanned,
        swings=swings,
        blows=blows,
        transfers=transfers,
        said=said,
        between=between,
        rates=rates,
    )


def told_constants(motion: RegimeSequence, equilibria: Equilibria) -> dict[sp.Symbol, Decimal]:
    """The constants that are sought and that an equilibrium tells."""
    told = equilibria.branch.values
    return {c: told[c] for c in motion.sought() if c in told}


def _ask_transfers(motion: RegimeSequence) -> dict[int, dict[sp.Symbol, sp.Expr]]:
    """Letters of other regimes, and how bodies arrive at blows, are worked out with each regime."""
    transfers = {}
    for reader in motion.distinct_readers():
        transfers[id(reader.regime)] = transfer_of(reader.regime, motion.distinct_regimes())
        reader.exprs += transfers[id(reader.regime)].values()
    for i, stretch in enumerate(motion.modes.stretches):
        for state in motion.states[i : i + 2] if stretch.blow is not None else ():
            reader = motion.readers[state.name]
            reader.exprs += [e for v, spin in arriving(reader.regime).values() for e in (v.x, v.y, spin)]
    return transfers


def _work(motion: RegimeSequence, between: LawsBetween) -> None:
    """Every regime, with all that was asked of it."""
    running = motion.running()
    for regime in running:
        next(r for r in motion.distinct_readers() if r.regime is regime).exprs += between.exprs(regime)
    for regime in motion.distinct_regimes():
        exprs = [e for r in motion.distinct_readers() if r.regime is regime for e in r.exprs]
        regime.work(exprs, any(r is regime for r in running))


def _blows(motion: RegimeSequence, placed: Mapping[str, Sequence[Demand]]) -> dict[int, Blow]:
    """The blows, once the velocities before them are worked out."""
    blows = {}
    for i, stretch in enumerate(motion.modes.stretches):
        if stretch.blow is not None:
            made = make_blow(motion, i, stretch.blow, stretch.blow_choice, bool(placed[motion.first.name]))
            units = made.scene.ledger.units
            motion.ledger.units |= {x: units[x] for x in made.letters if x in units}
            blows[i] = made
    return blows


def _places(motion: RegimeSequence, i: int) -> tuple[Statement, ...]:
    """What `motion` says of places all the time, where state i is reached."""
    stretch = motion.modes.stretches[max(i - 1, 0)]
    names = {c.name for c in motion.problem.coordinates}
    return tuple(s for s in stretch.span.always if isinstance(s, Relation) and order(s, names) == 0)
