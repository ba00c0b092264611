"""Stretches in which the finds need an acceleration, such as the tension of a rope that lifts a load faster and faster.
The push of a known force or the normal force of a level floor needs none.
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.values.ledger import Kind
from planar_cli.solve.between.equations.asked_finds import AskedFind
from planar_cli.solve.regimes.regime import Regime
from planar_cli.solve.regimes.regime_sequence import RegimeSequence


def accelerated(course: RegimeSequence, finds: Iterable[AskedFind]) -> frozenset[str]:
    """The states at the ends of such stretches."""
    marked = {id(r): {s: s.as_dummy() for s in _accelerations(r)} for r in course.distinct_regimes()}
    inside = frozenset().union(*(p.free_symbols for asked in finds for p in asked.parts(marked)))
    found = {number for number, letters in marked.items() if inside & set(letters.values())}
    return frozenset(s.name for s, r in zip(course.states[1:], course.regimes, strict=False) if id(r) in found)


def _accelerations(regime: Regime) -> list[sp.Symbol]:
    roles = regime.general.instant.scene.ledger.roles
    return [s for s, role in roles.items() if role.kind is Kind.ACCELERATION]
