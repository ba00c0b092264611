"""The regimes of a motion in their order, and the states of the file between which they act, each with its symbols."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import fields
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.kinematics.motion import Edge
from planar_cli.equation.scene.scene import Scene
from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.scene.ordinary import Scales
from planar_cli.problem.scene.scene import Problem, State
from planar_cli.records import record
from planar_cli.solve.regimes.after import asked_after
from planar_cli.solve.regimes.mode_dates import is_dated_by_mode, stated_modes
from planar_cli.solve.regimes.mode_sequence import ModeSequence, Workshop
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.speed_transfer import edges_of
from planar_cli.solve.regimes.timeline import Reader, Stop, stop_of


@record
class RegimeSequence:
    """What acts from state to state along one sequence of modes, before anything that is stated is read."""

    problem: Problem
    """The problem whose states these are."""
    modes: ModeSequence
    """What the file says of time, with one choice of modes for each stretch."""
    workshop: Workshop
    """Where regimes come from; all sequences of one problem share it."""
    regimes: tuple[Regime, ...]
    """`regimes[i]` acts from state i to the next."""
    beyond: Regime | None
    """What acts from the last state on; None: all states stand beside the order."""
    stops: Mapping[str, Stop]
    """The symbols of every state, by its name."""
    readers: Mapping[str, Reader]
    """Who reads what a state states, by its name."""
    tellers: Mapping[str, Reader]
    """Who reads what is asked of a state and may jump there, by its name."""
    told: dict[sp.Symbol, sp.Expr]
    """What stand-ins for quantities about states are; filled in as it is found out, as the readers put it in."""

    @property
    def states(self) -> tuple[State, ...]:
        """The states in their order; not those of equilibrium, which stand beside it."""
        return self.modes.states

    @property
    def first(self) -> Stop:
        return next(iter(self.stops.values()))

    @property
    def scene(self) -> Scene:
        """The scene of the first regime."""
        return next(iter(self.readers.values())).regime.general.instant.scene

    @property
    def ledger(self) -> Ledger:
        """Units and titles of all symbols."""
        return self.scene.ledger

    @property
    def scales(self) -> Scales:
        """Ordinary sizes of the scene."""
        found: Scales = self.ledger.scales
        return found

    def natural(self, letters: Iterable[sp.Symbol]) -> dict[sp.Symbol, Decimal]:
        """An ordinary size of each of these letters."""
        units = self.ledger.units
        return {s: self.scales.exact(units[s].dimension) if s in units else Decimal(1) for s in letters}

    def distinct_readers(self) -> list[Reader]:
        """Every reader once."""
        return list({id(r): r for r in (*self.readers.values(), *self.tellers.values())}.values())

    def distinct_regimes(self) -> list[Regime]:
        return list({id(r): r for r in (*self.regimes, *(r.regime for r in self.distinct_readers()))}.values())

    def edges(self) -> dict[sp.Symbol, Edge]:
        """What the free speeds of all regimes are, by their letters."""
        regimes = self.distinct_regimes()
        return {s: e for r in regimes for s, e in edges_of(r.general.trial.system.tree).items() if s in r.free}

    def running(self) -> list[Regime]:
        """The regimes in which time passes, or in which what is asked of the last state is told."""
        found = [r for i, r in enumerate(self.regimes) if not self.is_impulsive(i)]
        found += [self.workshop.regime(s) for _, s in self.modes.equilibria]
        last = self.states[-1].name if self.states else ""
        if self.beyond is not None and (not self.blows_last or asked_after(self.problem, last)):
            found.append(self.beyond)
        return found

    @property
    def blows_last(self) -> bool:
        """Is the last state just after a blow?"""
        return bool(self.modes.stretches) and self.modes.stretches[-1].blow is not None

    def is_impulsive(self, i: int) -> bool:
        """Does no time pass from state i to the next, only an impact or an impulse?"""
        return self.modes.stretches[i].blow is not None

    def is_dated(self, i: int) -> bool:
        """Is state i, which was put in, where state i + 1 is, which a mode alone tells?"""
        state, stretch = self.states[i + 1], self.modes.stretches[i]
        if not is_dated_by_mode(state) or state.name in self.modes.turnings or self.states[i].relations:
            return False
        chosen = zip(self.workshop.drawn(stretch.span).modes, stretch.choice, strict=True)
        names = {joint.name: modes[k].name for (joint, modes), k in chosen}
        return all(names.get(joint) == mode for joint, mode in stated_modes(state).items())

    def parts(self) -> dict[str, Any]:
        """Every field by its name: the next stage takes them over."""
        return {f.name: getattr(self, f.name) for f in fields(self)}

    def sought(self) -> list[sp.Symbol]:
        """The constants that the file leaves unknown."""
        return [self.ledger.symbols[s.name] for s in self.problem.unknowns if s.name in self.ledger.symbols]

    def given(self) -> Valuation:
        """Numbers of everything that is known: given values, and draws of the letters of the file."""
        drawn: Valuation = self.scene.valuations[0]
        varying = {s for r in self.distinct_regimes() for s in r.letters}
        return drawn.without(varying.union(self.sought()))


def regime_sequence(problem: Problem, modes: ModeSequence, workshop: Workshop) -> RegimeSequence:
    """The regime of every stretch; then the symbols of every state, and who reads it."""
    regimes = tuple(workshop.regime(s) for s in modes.stretches)
    apart = [(state, workshop.regime(s)) for state, s in modes.equilibria]
    beyond = workshop.regime(modes.stretch(len(regimes))) if regimes else None
    every = [*regimes, *(r for _, r in apart), *(r for r in (beyond,) if r is not None)]
    letters = list(dict.fromkeys(s for r in every for s in r.letters))
    ledger = every[0].general.instant.scene.ledger
    for regime in every:
        own = regime.general.instant.scene.ledger
        for s in regime.letters:
            ledger.know(s, own.units[s], own.roles[s])
    stops = {
        state.name: stop_of(state.name, state.relations, state.mark, letters, ledger, workshop.letters)
        for state in (*modes.states, *(s for s, _ in apart))
    }
    readers: dict[str, Reader] = {}
    tellers: dict[str, Reader] = {}
    found = RegimeSequence(problem, modes, workshop, regimes, beyond, stops, readers, tellers, {})
    by_regime: dict[int, Reader] = {}

    def reader_of(regime: Regime) -> Reader:
        made = Reader(problem, regime, stops, readers, tellers, found.told)
        return by_regime.setdefault(id(regime), made)

    for i, state in enumerate(modes.states):
        begins = regimes[i] if i < len(regimes) else beyond
        assert begins is not None
        struck = i > 0 and found.is_impulsive(i - 1)
        readers[state.name] = reader_of(begins if struck else regimes[max(i - 1, 0)])
        tellers[state.name] = reader_of(begins)
    for state, regime in apart:
        readers[state.name] = tellers[state.name] = reader_of(regime)
    return found
