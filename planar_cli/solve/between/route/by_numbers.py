"""Letters of states that only a step method tells, and what may be derived from them: what comes at or after them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

import sympy as sp

from planar_cli.equation.algebra.plain import by_name, longer
from planar_cli.equation.values.exact import Valuation
from planar_cli.records import record
from planar_cli.solve.between.trace.derivation import Edge
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.regime_sequence import RegimeSequence

LONGEST = 60
DEAR = 100.0
"""Where a constant is found by trial, what equations tell with it is told by them."""


@record
class ByNumbers:
    """`equations`: one for each letter; `order`: of the letters of all states, which state they belong to."""

    equations: tuple[Equation, ...] = ()
    order: Mapping[sp.Symbol, int] | None = None

    def edges(self, edges: Iterable[Edge]) -> list[Edge]:
        """The derivations that lead onward in time and can be read, and the numbers."""
        order = self.order or {}
        told = [(e, x) for e in self.equations for x in by_name(e.residual.free_symbols)]
        found = [((e,), (x,), frozenset[sp.Symbol](), e.cost) for e, x in told]
        return [*(e for e in edges if _onward(e, order)), *found]


def _onward(edge: Edge, order: Mapping[sp.Symbol, int]) -> bool:
    equations, unknowns, needs, _ = edge
    first = min((order[x] for x in unknowns if x in order), default=len(order))
    last = max((order[x] for x in needs if x in order), default=0)
    return last <= first and not any(longer(e.residual, LONGEST) for e in equations)


def by_numbers(
    course: RegimeSequence, loose: Collection[sp.Symbol], sought: Collection[sp.Symbol], value: Valuation
) -> ByNumbers:
    """The letters of states, and constants that are `sought`, whose values came from following the motion: they are
    among the `loose` ones, to which no equation led. `value`: their numbers.
    """
    stops = [course.stops[state.name] for state in course.states]
    order = {own: i for i, stop in enumerate(stops) for own in stop.letters.values()}
    told = []
    for constant in sought:
        if constant in loose:
            residual = constant - sp.Rational(str(value(constant)))
            told.append(Equation(residual, "followed", "found by trial, following the motion", course.states[0].name))
    for own, i in order.items():
        if own in loose:
            residual = own - sp.Rational(str(value(own)))
            words, dear = "followed step by step", DEAR if any(c in loose for c in sought) else 0.0
            told.append(Equation(residual, "followed", words, course.states[i].name, surcharge=dear))
    return ByNumbers(tuple(told), order)
