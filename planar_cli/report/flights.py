"""A throw, and a motion whose acceleration or velocity is given over time, told as functions of the time, once, before
what they are at this or that state.

From launch on, P along x with constant velocity, along y with constant acceleration:
  v_x = v_x,launch,  x = v_x,launch t
  v_y = v_y,launch - g t,  y = v_y,launch t - 1/2 g t²
At B, y = -3/4 x: …

From start on, dy = v dt:
  ∫[y_start → y] dy = ∫[0 → t] 0.6 (1 - cos(π t/4)) dt
  y = -6 + 0.6 t - 0.7639 sin(π t/4)
At one: …
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import Any

import sympy as sp

from planar_cli.equation.plain import simplified
from planar_cli.problem.scene import with_article
from planar_cli.records import changing
from planar_cli.report.blocks import Block, Equation, Math, Paragraph, line
from planar_cli.report.integrals import in_times, plain_integral
from planar_cli.report.laws import integral_note, running
from planar_cli.report.numbers import significant
from planar_cli.report.ordering import NUMBER
from planar_cli.report.origins import calculus, is_explicit, is_steady
from planar_cli.report.spoken import spoken
from planar_cli.report.state_words import at
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import MotionTrace, Relation, Result, RouteStep

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
    put: dict[int, Math] = field(default_factory=dict)
    """Functions with numbers, by their own number."""

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
            elif _is_over_time(e, found) and e.law is not None and e.since in from_zero:
                every[(e.law.coordinate.words, e.since)].append(e)
        return cls(found, phrases, {key: es for key, es in every.items() if _is_flight(es) or _is_used(es)})

    def number(self, e: Relation) -> list[int]:
        """The number of the function that a relation is at a state; none: it is of no flight that was told."""
        key = next((key for key, es in self.flights.items() if any(e is x for x in es)), None)
        own = None if key is None else self.numbers.get((key, _axis(e), e.kind))
        return [] if own is None else [own]

    def before(
        self,
        leg: RouteStep,
        number: Callable[[], int],
        sides: Callable[[Relation], tuple[Any, ...]],
        law: Callable[[Relation], Iterator[Block]],
    ) -> Iterator[Block]:
        """The functions of the flights whose first relation is one of a step, and the state at which they are used, if
        nothing else tells it, with what it is there where it must be solved as a quadratic equation. `number`: the next
        of an equation; `sides`: of a relation; `law`: tells the law of one.
        """
        for key, es in self.flights.items():
            if any(e is es[0] for e in leg.relations):
                yield from self._told(key, number) if _is_flight(es) else (*law(es[0]), *self._integrated(key, number))
        if all(map(self.number, leg.relations)):
            e, *more = leg.relations
            yield Paragraph(line(at(e.stop)))
            if not more and sp.diff(e.residual, leg.unknowns[0], 2) != 0:
                yield Equation(sides(e), None, line(f"({self.number(e)[0]}):"))

    def at_state(self, leg: RouteStep, chain: Callable[[Result], tuple[Any, ...]]) -> list[Block]:
        """A letter that one function gives as it stands; empty of anything else. `chain`: a letter, and what it is."""
        (e, *more) = leg.relations
        number = self.number(e)
        if more or not number or not is_explicit(e, leg, self.found.ledger):
            return []
        sides = chain(leg.results[0])
        told, t = self.put.get(number[0]), next((s for s, g in self._ends(e).items() if g.name == "t"), None)
        if told is not None and t is not None and len(sides) > 1:
            time = sp.Symbol(f"{NUMBER}t", real=True)
            text = significant(self.found.value(t), self.phrases.figures)
            put = told.expr.xreplace({self.found.general[t]: time})
            sides = (sides[0], Math(put, {**(told.values or {}), time: text}), sides[-1])
        return [Equation(sides, None, line(f"({number[0]}):"))]

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

    def _integrated(self, key: Key, number: Callable[[], int]) -> Iterator[Block]:
        """The integrals of a law over time up to any time."""
        for kind in KINDS:
            e = next((r for r in self.flights[key] if r.kind == kind), None)
            if e is None or e.law is None or e.span is None:
                continue
            self.numbers[key, _axis(e), kind] = number()
            names = self.found.ledger.symbols
            yield Paragraph(spoken(f"From {e.since} on, {calculus(e)}:", names))
            ends = self._ends(e)
            route = replace(self.found.route, plain=self._plain(ends))
            moving = {*self.found.varying, *ends.values()}
            if e.span.left is not None and e.span.right is not None:
                sides = [plain_integral(x, e, route, self.found.general) for x in (e.span.left, e.span.right)]
                shown = tuple(running(x.xreplace(ends), moving, self.phrases, e.law) for x in sides)
                yield Equation(shown, None, (), integral_note(e.law, kind, shown, self.phrases))
            assert e.span.explicit is not None
            letter = e.law.coordinate.symbol if kind == "q(t)" else (e.law.speed or e.law.v)
            formula = simplified(e.span.explicit.xreplace(self._plain(ends)).xreplace(ends))
            told = running(sp.expand(formula), moving, self.phrases, e.law)
            number_of = self.numbers[key, _axis(e), kind]
            self.put |= {number_of: told} if told.values else {}
            yield Equation((Math(letter), told), number_of, (), integral_note(e.law, kind, (told,), self.phrases))

    def _ends(self, e: Relation) -> dict[sp.Symbol, sp.Symbol]:
        """The letters at the end of a relation, with those of any time."""
        return {s: g for s, g in self.found.general.items() if self.found.ledger.roles[s].at == e.stop}

    def _plain(self, ends: Collection[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
        """Data that are put in at once, but those at the end: what is given there stands for its letter."""
        return {s: f for s, f in self.found.route.plain.items() if s not in ends}

    def _function(self, e: Relation, number: int) -> Equation:
        assert e.law is not None
        assert e.span is not None
        assert e.span.explicit is not None
        ends = {s: g for s, g in self._ends(e).items() if g.name == "t"}
        formula = simplified(e.span.explicit.xreplace(self._plain(ends)).xreplace(ends))
        letter = e.law.coordinate.symbol if e.kind == "q(t)" else (e.law.speed or e.law.v)
        return Equation((Math(letter), self.phrases.math(in_times(formula, self.found).expand())), number)


def _is_flight(relations: Sequence[Relation]) -> bool:
    """Has it both axes, one of them with an acceleration, and several states?"""
    axes = {_axis(e) for e in relations}
    curved = any(not _is_free(e) for e in relations)
    return axes == set(AXES) and curved and len({e.stop for e in relations}) >= LEAST


def _is_over_time(e: Relation, found: MotionTrace) -> bool:
    """Is it an integral of a law f(t) that is told in a formula?"""
    if e.law is None or e.span is None or e.kind not in KINDS or is_steady(e) or e.law.vibration is not None:
        return False
    whole = e.span.explicit is not None and not e.span.unevaluated and not e.span.explicit.has(sp.Piecewise)
    varying = e.law.f.free_symbols & {*found.varying, e.law.v, e.law.coordinate.symbol}
    return whole and e.law.factor == 1 and {s.name for s in varying} == {"t"}


def _is_used(relations: Sequence[Relation]) -> bool:
    """Is one function of the time needed at several states?"""
    over_time = not any(map(is_steady, relations))
    return over_time and any(len({e.stop for e in relations if e.kind == kind}) >= LEAST for kind in KINDS)


def _axis(e: Relation) -> str:
    assert e.law is not None
    return e.law.coordinate.words.partition(" of ")[0]


def _is_free(e: Relation) -> bool:
    assert e.law is not None
    return bool(e.law.f == 0)
