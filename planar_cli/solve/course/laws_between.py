"""The laws of energy and momentum of all regimes of a motion, and their equations between its states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Any

import sympy as sp

from planar_cli.solve.course.equations import Equation
from planar_cli.solve.course.impulse_momentum import (
    Candidate,
    Integrated,
    candidates_of,
    integrated,
    momentum_equations,
)
from planar_cli.solve.course.impulses import impulse_equations
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.regime_sequence import RegimeSequence
from planar_cli.solve.course.timeline import Stop
from planar_cli.solve.course.work_energy import Closed, Energies, closed_energies, energies_of, energy_equations


@dataclass(slots=True)
class LawsBetween:
    """`energies`, `momenta`: of every regime, in the unknowns of its general position, by its id. `closed`,
    `integrated`: the same worked out, stretch by stretch. `impulses`: letters of reactions, by push and states.
    """

    energies: dict[int, Energies | None] = field(default_factory=dict)
    momenta: dict[int, list[Candidate]] = field(default_factory=dict)
    closed: list[Closed | None] = field(default_factory=list)
    integrated: list[list[Integrated]] = field(default_factory=list)
    impulses: dict[tuple[str, str, str], sp.Symbol] = field(default_factory=dict)

    def exprs(self, regime: Regime) -> list[sp.Expr]:
        """What a regime has to work out for them; made once."""
        key = id(regime)
        if key not in self.energies:
            self.energies[key] = energies_of(regime.general)
            self.momenta[key] = candidates_of(regime.general)
        energies = self.energies[key]
        found = [] if energies is None else energies.exprs()
        return [*found, *(e for c in self.momenta[key] for e in (c.momentum, c.rate))]

    def close(self, regimes: Sequence[Regime]) -> None:
        """Closed formulas, once the regimes are worked out; None or nothing where no time passes."""
        self.closed = [closed_energies(r, self.energies.get(id(r))) for r in regimes]
        self.integrated = [integrated(r, self.momenta.get(id(r), [])) for r in regimes]

    def equations(self, course: RegimeSequence, k: int) -> Iterator[Equation]:
        """All that end at state k."""
        yield from energy_equations(course, self.closed, k)
        yield from momentum_equations(course, self.integrated, k)
        if course.problem.method == "momentum":
            yield from impulse_equations(course, partial(self.impulse_letter, course.ledger), k)

    def impulse_letter(self, ledger: Any, push: sp.Symbol, since: Stop, stop: Stop, unit: str) -> sp.Symbol:
        """The letter for the impulse of a reaction between two states."""
        key = (push.name, since.name, stop.name)
        if key not in self.impulses:
            self.impulses[key] = ledger.fresh(f"J_{push.name}__{stop.name}", unit)
        return self.impulses[key]
