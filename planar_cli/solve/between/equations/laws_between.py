"""What all principles offer over the stretches of a motion, and their equations between its states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import field
from functools import partial
from typing import Any

import sympy as sp

from planar_cli.principles.base import Balance, Impulses, Integrated
from planar_cli.problem.scene.impulse_letters import of_reaction
from planar_cli.records import changing
from planar_cli.solve.between.equations.balances import Closed, Offered, balance_equations, closed_balances
from planar_cli.solve.between.equations.impulses import impulse_equations
from planar_cli.solve.principled import every_principle, position_of
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.general import General
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence
from planar_cli.solve.regimes.timeline import Stop


@changing
class LawsBetween:
    """What is offered; then the same worked out, stretch by stretch."""

    offered: dict[int, list[Offered]] = field(default_factory=dict)
    """The balances of every regime, by its id."""
    integrating: dict[str, None] = field(default_factory=dict)
    """The principles whose equations of motion are integrated from state to state, by their words."""
    impulsive: dict[str, Impulses] = field(default_factory=dict)
    """The principles that take equations of an instant with the impulses of reactions, by their words."""
    closed: list[list[Closed]] = field(default_factory=list)
    """The balances in closed formulas, stretch by stretch."""
    impulses: dict[tuple[str, str, str], sp.Symbol] = field(default_factory=dict)
    """The letters for impulses of reactions, by push and states."""
    tensions: dict[str, sp.Symbol] = field(default_factory=dict)
    """The tensions that the work on a part tells, by the finds that ask for them."""

    def exprs(self, regime: Regime) -> list[sp.Expr]:
        """What a regime has to work out for them; made once."""
        if id(regime) not in self.offered:
            self.offered[id(regime)] = list(self._ask(regime.general))
        return [e for offered in self.offered[id(regime)] for e in offered.exprs()]

    def _ask(self, general: General) -> Iterator[Offered]:
        system = general.trial.system
        if system.reactions is None:
            return
        position = position_of(system, general.value, general.coordinates)
        method = general.instant.scene.problem.method
        for principle in every_principle():
            for offer in principle.over(position, principle.kind == method):
                match offer:
                    case Balance():
                        yield Offered(principle.kind, offer)
                    case Integrated():
                        self.integrating[principle.kind] = None
                    case Impulses():
                        self.impulsive[principle.kind] = offer

    def close(self, regimes: Sequence[Regime]) -> None:
        """Closed formulas, once the regimes are worked out; nothing where no time passes."""
        self.closed = [closed_balances(r, self.offered.get(id(r), [])) for r in regimes]

    def equations(self, course: RegimeSequence, k: int) -> Iterator[Equation]:
        """All that end at state k."""
        yield from balance_equations(course, self.closed, k)
        for kind, offer in self.impulsive.items():
            yield from impulse_equations(course, kind, offer, partial(self.impulse_letter, course.ledger), k)

    def impulse_letter(self, ledger: Any, push: sp.Symbol, since: Stop, stop: Stop, unit: str) -> sp.Symbol:
        """The letter for the impulse of a reaction between two states."""
        key = (push.name, since.name, stop.name)
        if key not in self.impulses:
            self.impulses[key] = ledger.fresh(f"{of_reaction(push.name)}__{stop.name}", unit)
        return self.impulses[key]
