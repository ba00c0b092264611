"""Whether a contact sticks at a state of a motion: the friction that this takes, beside its limit there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from planar_cli.equation.system.system import System
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.problem.scene.facts import Test
from planar_cli.report.document.blocks import Block, Equation, Line, Name, line
from planar_cli.report.friction.presses import bounded_in
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, RegimeTrace
from planar_cli.units import FORCE

SHORT = 12
"""A formula with more operations is left out: its value is what is compared."""


def friction_at_states(found: MotionTrace, phrases: Phrases) -> Iterator[Block]:
    """For each contact of which it is asked how it acts at a state, and which sticks there: |F| = value ≤ its limit."""
    for asked in found.requests:
        what = asked.find.found.what
        quantity = what.left if isinstance(what, Relation) else what
        if not isinstance(quantity, Quantity) or quantity.word != "mode" or phrases.symbolic:
            continue
        state = quantity.at
        regime = _from(found, state) if isinstance(state, str) else None
        if regime is None or not isinstance(state, str):
            continue
        system = regime.solution.trial.system
        for joint, mode in system.modes.items():
            named = {joint, system.aliases.get(joint)} & set(quantity.things)
            limits = [t for t in mode.tests if not t.strict and bounded_in(system, t) is not None]
            if named and mode.name == "stick" and limits:
                yield from _compared(asked.find.name, limits[0], _Here(found, regime, state, phrases))


def _from(found: MotionTrace, state: str) -> RegimeTrace | None:
    """The regime that acts from a state on; of the last state that which leads there."""
    regimes = found.regimes
    after = next((r for r in regimes if any(since == state for since, _ in r.stretches)), None)
    return after or next((r for r in regimes if any(stop == state for _, stop in r.stretches)), None)


class _Here:
    """What forces are at a state."""

    def __init__(self, found: MotionTrace, regime: RegimeTrace, state: str, phrases: Phrases) -> None:
        self.system: System = regime.solution.trial.system
        self.phrases = phrases
        self._formulas = {x.symbol: x.formula for s in regime.solution.stages for b in s.blocks for x in b.lines}
        roles = found.ledger.roles
        self._letters: Mapping[sp.Symbol, sp.Symbol] = {
            general: own for own, general in found.general.items() if roles[own].at == state
        }

    def formula(self, push: str) -> sp.Expr:
        """A push in the letters of the state."""
        expr: sp.Expr = self.system.symbols[push]
        for _ in self._formulas:
            expr = expr.xreplace(self._formulas)
        return expr.xreplace(dict(self._letters))


def _compared(name: str, test: Test, here: _Here) -> Iterator[Block]:
    friction = bounded_in(here.system, test)
    assert friction is not None
    acting = here.formula(friction)
    others = [(n, factor) for n, factor in test.pushes if n != friction]
    limit = sp.Add(sp.sympify(test.constant), *(factor * here.formula(n) for n, factor in others))
    shown = sp.Add(sp.sympify(test.constant), *(factor * here.system.symbols[n] for n, factor in others))
    value = here.phrases.value
    size, most = value.known(acting), value.known(limit)
    if size is None or most is None:
        return
    symbol = here.system.symbols[friction]
    formula: Line = ()
    if size and acting.count_ops() <= SHORT:
        formula = line(" = ", here.phrases.math(acting if size > 0 else -acting))
    told = line(
        "|",
        here.phrases.math(symbol),
        "|",
        formula,
        " = ",
        here.phrases.of_dimension(abs(here.phrases.certain(acting)), FORCE),
        " ≤ " if abs(size) <= most else " > ",
        here.phrases.math(shown),
        " = ",
        here.phrases.of_dimension(most, FORCE),
    )
    yield Equation((told,), None, line(Name(name), ":"))
