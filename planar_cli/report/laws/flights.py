"""A throw told as functions of the time, once, before what it is at this or that state.

From launch on, P along x with constant velocity, along y with constant acceleration:
  v_x = v_x,launch,  x = v_x,launch t
  v_y = v_y,launch - g t,  y = v_y,launch t - 1/2 g t²
At B, y = -3/4 x: …
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import field
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.problem.scene.scene import with_article
from planar_cli.records import changing
from planar_cli.report.document.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.laws.integrals import in_times
from planar_cli.report.words.origins import is_explicit, is_steady
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep

AXES = ("x", "y")
KINDS = ("v(t)", "q(t)")
LEAST = 2
"""At fewer states the relations are told one by one."""
Key = tuple[str, str]
"""Whose flight it is, and since which state."""


@changing
class FlightTelling:
    """Tells each flight once. `flights`: the relations of each."""

    found: MotionTrace
    phrases: Phrases
    flights: Mapping[Key, Sequence[Relation]]
    numbers: dict[tuple[Key, str, str], int] = field(default_factory=dict)
    """The numbers of the functions, by flight, axis and kind."""

    @classmethod
    def of(cls, found: MotionTrace, phrases: Phrases) -> FlightTelling:
        """The throws from which several states follow, with a clock that runs from their start."""
        times = {s: found.ledger.roles[s].at for s, general in found.general.items() if general.name == "t"}
        from_zero = {at for s, at in times.items() if found.route.plain.get(s) == 0}
        every: defaultdict[Key, list[Relation]] = defaultdict(list)
        for e in (e for leg in found.route.steps for e in leg.relations):
            if e.law is not None and e.kind in KINDS and is_steady(e) and e.since in from_zero:
                axis, _, thing = e.law.coordinate.words.partition(" of ")
                if axis in AXES and e.law.order == 2 and e.span is not None and e.span.explicit is not None:
                    every[(thing, e.since)].append(e)
        flights = {key: es for key, es in every.items() if _is_flight(es)}
        return cls(found, phrases, flights)

    def number(self, e: Relation) -> list[int]:
        """The number of the function that a relation is at a state; none: it is of no flight that was told."""
        key = next((key for key, es in self.flights.items() if any(e is x for x in es)), None)
        own = None if key is None else self.numbers.get((key, _axis(e), e.kind))
        return [] if own is None else [own]

    def before(
        self, leg: RouteStep, number: Callable[[], int], sides: Callable[[Relation], tuple[Any, ...]]
    ) -> Iterator[Block]:
        """The functions of the flights whose first relation is one of a step, and the state at which they are used, if
        nothing else tells it, with what it is there where it must be solved as a quadratic equation. `number`: the next
        of an equation; `sides`: of a relation.
        """
        for key, es in self.flights.items():
            if any(e is es[0] for e in leg.relations):
                yield from self._told(key, number)
        if all(map(self.number, leg.relations)):
            e, *more = leg.relations
            yield Paragraph(line(at(e.stop)))
            if not more and sp.diff(e.residual, leg.unknowns[0], 2) != 0:
                yield Equation(sides(e), None, line(f"({self.number(e)[0]}):"))

    def at_state(self, leg: RouteStep, chain: Callable[[Result], tuple[Any, ...]]) -> list[Block]:
        """A letter that one function gives as it stands; empty of anything else. `chain`: a letter, and what it is."""
        (e, *more) = leg.relations
        number = self.number(e)
        if more or not number or not is_explicit(e, leg, self.found.route, self.found.ledger):
            return []
        return [Equation(chain(leg.results[0]), None, line(f"({number[0]}):"))]

    def _told(self, key: Key, number: Callable[[], int]) -> Iterator[Block]:
        axes = {_axis(r): r for r in self.flights[key]}
        how = [f"along {a} with constant {'velocity' if _is_free(axes[a]) else 'acceleration'}" for a in AXES]
        yield Paragraph(line(f"From {key[1]} on, {with_article(key[0])} {', '.join(how)}:"))
        for axis in AXES:
            for kind in KINDS:
                told = next((r for r in self.flights[key] if _axis(r) == axis and r.kind == kind), None)
                if told is not None:
                    self.numbers[key, axis, kind] = number()
                    yield self._function(told, self.numbers[key, axis, kind])

    def _function(self, e: Relation, number: int) -> Equation:
        assert e.law is not None
        assert e.span is not None
        assert e.span.explicit is not None
        t = sp.Symbol("t", real=True)
        roles, general = self.found.ledger.roles, self.found.general
        ends = {s: t for s, g in general.items() if g.name == "t" and roles[s].at == e.stop}
        # The time of a state that is given stands for its letter.
        plain = {s: f for s, f in self.found.route.plain.items() if s not in ends}
        formula = simplified(e.span.explicit.xreplace(plain).xreplace(ends))
        letter = e.law.coordinate.symbol if e.kind == "q(t)" else (e.law.speed or e.law.v)
        return Equation((Math(letter), self.phrases.math(in_times(formula, self.found).expand())), number)


def _is_flight(relations: Sequence[Relation]) -> bool:
    """Has it both axes, one of them with an acceleration, and several states?"""
    axes = {_axis(e) for e in relations}
    curved = any(not _is_free(e) for e in relations)
    return axes == set(AXES) and curved and len({e.stop for e in relations}) >= LEAST


def _axis(e: Relation) -> str:
    assert e.law is not None
    return e.law.coordinate.words.partition(" of ")[0]


def _is_free(e: Relation) -> bool:
    assert e.law is not None
    return bool(e.law.f == 0)
