"""A harmonic motion from rest to rest told without the time: half a period, and the mirror about its midpoint.

From 1 to 2, from rest to rest, it goes as far beyond the midpoint as it began before it:
  (5)  x_2 = 2 x_eq - x_1 = 2 · 0.014715 - 0.12 = -0.09057 m
From 1 to 5, 4 half swings of π/ω_n each, with the same ω_n either way:
  (6)  t_5 = 4 π/ω_n = 4 π/10 = 1.257 s
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, RouteStep
from planar_cli.solve.law import AT_MIDPOINT, FROM_REST, HALF_SWINGS

STOPS = "it stops sliding"


class HalfSwingTelling:
    """Tells such steps; what holds for each half swing is said once."""

    def __init__(self, found: MotionTrace, phrases: Phrases) -> None:
        self.found, self.phrases = found, phrases
        self._said = False

    def blocks(self, leg: RouteStep, number: int) -> list[Block]:
        """The line of a step without its law; empty of another one. `number`: of its equation."""
        (e, *more), (r, *others) = leg.relations, leg.results
        if more or others or e.kind not in FROM_REST or r.formula is None:
            return []
        if self.found.ledger.roles[r.unknown].at != e.stop:
            return []
        value = self.phrases.shown(r.unknown, r.value)
        put = self.phrases.substituted(r.formula, value)
        turned = self.phrases.in_radians(r.unknown, r.formula, r.value)
        chain: tuple[Any, ...] = (self.phrases.math(r.unknown), self.phrases.math(r.formula), *put, *turned, value)
        return [*self._words(e), Equation(chain, number)]

    def _words(self, e: Relation) -> Iterator[Block]:
        assert e.law is not None
        assert e.law.vibration is not None
        natural, rest = Math(e.law.vibration.natural), e.law.vibration.rest
        reach = f"From {e.since} to {e.stop}"
        if e.kind == AT_MIDPOINT:
            what = line(f"At {e.stop}, which is the midpoint, its speed is ", natural, " times the amplitude:")
            yield Paragraph(what)
        elif e.kind == HALF_SWINGS:
            yield Paragraph(line(f"{reach}, ", *self._counted(e, natural), ":"))
        elif self._said:
            about = (x for q in rest for x in (", about ", Math(q)))
            yield Paragraph(line(f"{reach} likewise", *about, f"{self._held(e)}:"))
        else:
            self._said = True
            words = ", from rest to rest, it goes as far beyond the midpoint as it began before it"
            yield Paragraph(line(reach, words, f"{self._held(e)}:"))

    def _held(self, e: Relation) -> str:
        """Why it stays there, where friction moves the midpoint: between both it can slide neither way."""
        law, found = e.law, self.found
        ends = (t for t in found.turnings if t.state == e.stop and t.words == STOPS)
        if law is None or not any(not goes_on(found, e.stop, t.expr) for t in ends):
            return ""
        own = (s for s, general in found.general.items() if general == law.coordinate.symbol)
        place = next((found.value.known(s) for s in own if found.ledger.roles[s].at == e.stop), None)
        every = (x.vibration for _, _, laws in found.stretches for x in laws if x.coordinate == law.coordinate)
        known = [v for x in every if x is not None and (v := found.value.known(x.steady)) is not None]
        between = place is not None and bool(known) and min(known) < place < max(known)
        return "; there, between both midpoints, friction holds it" if between else ""

    def _counted(self, e: Relation, natural: Math) -> Line:
        """`4 half swings of π/ω_n each, with the same ω_n either way`."""
        times = [s for s in e.residual.free_symbols if s != natural.expr]
        n = simplified(-e.residual.xreplace(dict.fromkeys(times, sp.S.Zero)) * natural.expr / sp.pi)
        period = Math(sp.pi / natural.expr)
        if n == 1:
            return line("from rest to rest, half a period, ", period)
        told = line(f"{n} half swings of ", period, " each")
        return line(*told, ", with the same ", natural, " either way") if self._changes(e) else told

    def _changes(self, e: Relation) -> bool:
        """Has the motion another midpoint meanwhile?"""
        names = list(self.found.states)
        reach = range(names.index(e.since), names.index(e.stop))
        within = (laws for since, _, laws in self.found.stretches if since in names and names.index(since) in reach)
        own = (law for laws in within for law in laws if e.law is not None and law.coordinate == e.law.coordinate)
        return len({law.f for law in own}) > 1


def ends_a_swing(found: MotionTrace, state: str) -> bool:
    """Is it the rest at the end of a half swing that is told?"""
    steps = found.route.steps
    names = [name for leg in steps for e in leg.relations if e.kind in FROM_REST for name in _rests(found, e)]
    return state in names


def _rests(found: MotionTrace, e: Relation) -> Iterator[str]:
    """The states on the way, the last among them."""
    names = list(found.states)
    yield from names[names.index(e.since) + 1 : names.index(e.stop) + 1]


def goes_on(found: MotionTrace, state: str, speed: sp.Expr) -> bool:
    """Is a coordinate whose speed vanishes there accelerated after it, so that it comes back?"""
    after = (laws for since, _, laws in found.stretches if since == state)
    return any(law.speed in (speed, -speed) and law.order == 2 and law.f != 0 for laws in after for law in laws)
