"""A simple harmonic motion between two states: the motion itself, and when its velocity or its place is what is stated.

x = l cos(ω_0 t),  ẋ = -l ω_0 sin(ω_0 t)
(3)  -l ω_0 sin(ω_0 t_stop) = 0        so that  ω_0 t_stop = π
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import sympy as sp

from planar_cli.equation.algebra.plain import identically_zero, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Math, Name, Paragraph, line
from planar_cli.report.equations.left_out import rejected, tells_of_others
from planar_cli.report.notation.notation import plain
from planar_cli.report.oscillation.at_quarters import date_blocks, is_asked
from planar_cli.report.oscillation.half_swings import HalfSwingTelling
from planar_cli.report.words.characteristic import UNDAMPED
from planar_cli.report.words.origins import head
from planar_cli.report.words.state_words import at
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Relation, Result, RouteStep, RouteTrace

NATURAL = sp.Symbol("omega_0", positive=True)


@record
class Harmonic:
    """x = A cos ω_0 τ + B sin ω_0 τ since a state. `square`: ω_0²; `time`: τ at the second state."""

    coordinate: sp.Symbol
    a: sp.Expr
    b: sp.Expr
    square: sp.Expr
    time: sp.Expr

    def place(self, tau: sp.Expr) -> sp.Expr:
        return self.a * sp.cos(NATURAL * tau) + self.b / NATURAL * sp.sin(NATURAL * tau)

    def rate(self, tau: sp.Expr) -> sp.Expr:
        return self.b * sp.cos(NATURAL * tau) - self.a * NATURAL * sp.sin(NATURAL * tau)


def harmonic(e: Relation, route: RouteTrace, general: Mapping[sp.Symbol, sp.Symbol]) -> Harmonic | None:
    """The motion that a relation is of, about x = 0 and since the time zero; None: it is another one."""
    law = e.law
    if e.span is None or law is None or law.vibration is not None or not e.span.words.startswith(UNDAMPED):
        return None
    q, square = law.coordinate.symbol, simplified(-sp.diff(law.f, law.coordinate.symbol))
    speed = law.speed if law.speed is not None else law.v
    if square.has(q) or not identically_zero(law.f + square * q) or law.factor != 1 or e.kind not in ("v(t)", "q(t)"):
        return None
    ends = {}
    for own, placed in general.items():
        if placed in (q, speed) or placed.name == "t":
            ends[(placed, own.name.rpartition("__")[2])] = own
    begun = [route.plain.get(ends[(s, e.since)], ends[(s, e.since)]) for s in (q, speed) if (s, e.since) in ends]
    times = [s for (placed, state), s in ends.items() if placed.name == "t" and state == e.stop]
    start = [route.plain.get(s, s) for (placed, state), s in ends.items() if placed.name == "t" and state == e.since]
    if len(begun) != 2 or len(times) != 1 or start not in ([sp.S.Zero], []):
        return None
    found = Harmonic(q, begun[0], begun[1], square, times[0])
    told = found.rate(found.time) if e.kind == "v(t)" else found.place(found.time)
    own = next((s for (placed, state), s in ends.items() if state == e.stop and placed in (q, speed)
                and placed == (speed if e.kind == "v(t)" else q)), None)  # fmt: skip
    whole = told.xreplace({NATURAL: sp.sqrt(square)})
    same = own is not None and identically_zero(
        e.residual.xreplace(dict(route.plain)) - route.plain.get(own, own) + whole
    )
    return found if same else None


class HarmonicTelling:
    """Tells such motions, each once; what they reach at a time of which ω_0 t is a number follows by its cosine. `law`:
    the blocks of the law of which a relation is an integral.
    """

    def __init__(self, found: MotionTrace, phrases: Phrases, law: Callable[[Relation], Iterator[Block]]) -> None:
        self.found, self.phrases, self.law = found, phrases, law
        self._phases: dict[str, tuple[Harmonic, sp.Expr]] = {}
        self._told: list[Harmonic] = []
        self._halves = HalfSwingTelling(found, phrases)

    def by_phase(self, leg: RouteStep, number: int) -> list[Block]:
        """What follows by the phase at a state, without another law or a time that nothing asks for; empty of anything
        else.
        """
        if told := self._reached(leg, number):
            return told
        (e, *more), (r, *_) = leg.relations, leg.results
        if halves := self._halves.blocks(leg, number):
            return [*self.law(e), *halves]
        if dated := date_blocks(leg, self.found, self.phrases, number):
            return [*self.law(e), *dated]
        if more or is_asked(leg, self.found, self._hangs_on_phase):
            return []
        motion = self.blocks(e, leg, self.found.route, number)
        phase = self._phases.get(e.stop)
        if not motion or phase is None or r.unknown != phase[0].time:
            return []
        heads = [Paragraph(head(e, self.found.ledger.symbols))] if len(motion) > 2 else []
        return [*self.law(e), *heads, *self._with_reason(r, motion)]

    def _with_reason(self, r: Result, motion: list[Block]) -> list[Block]:
        """With why this phase is taken beside it, as no line tells the time itself."""
        *before, last = motion
        why = [b for b in rejected(self.found, r, self.phrases, ()) if isinstance(b, Paragraph) and tells_of_others(b)]
        return [*before, replace(last, note=why[0].line)] if why and isinstance(last, Equation) else motion

    def head(self, e: Relation, told: list[Block]) -> Paragraph | None:
        """`At stop, ẋ = 0:` over an equation of a motion that was told before; None: it is no such equation."""
        first = told[0] if told else None
        if not isinstance(first, Equation) or first.number is None:
            return None
        nil = first.sides[-1] == Math(sp.S.Zero)
        name = f"{e.law.coordinate.symbol.name}_dot" if e.law is not None and e.kind == "v(t)" else ""
        told_zero = line(", ", Name(name), " = 0:") if nil and name else line(":")
        return Paragraph(line(at(e.stop).removesuffix(":"), *told_zero))

    def _hangs_on_phase(self, step: RouteStep, route: RouteTrace) -> bool:
        (e, *more) = step.relations
        return not more and harmonic(e, route, self.found.general) is not None

    def blocks(self, e: Relation, leg: RouteStep, route: RouteTrace, number: int) -> list[Block]:
        """The motion in letters, then the equation at the second state; empty of another relation."""
        found = harmonic(e, route, self.found.general)
        if found is None:
            return []
        told = found.rate(found.time) if e.kind == "v(t)" else found.place(found.time)
        right = simplified(told.xreplace({NATURAL: sp.sqrt(found.square)}) + e.residual.xreplace(dict(route.plain)))
        phases = [block for r in leg.results for block in self._phase(found, r, e.stop)]
        own = Equation((self.phrases.math(told), self.phrases.math(right)), number)
        return [*self._motion(found), own, *phases]

    def _motion(self, found: Harmonic) -> list[Block]:
        """x and ẋ over time, with what it begins with."""
        every = replace(found, time=sp.S.Zero)
        if every in self._told:
            return []
        self._told.append(every)
        t, rate = sp.Symbol("t", real=True), Name(f"{found.coordinate.name}_dot")
        motion = line(Math(found.coordinate), " = ", self.phrases.math(found.place(t)))
        moves = line(*motion, ",  ", rate, " = ", self.phrases.math(found.rate(t)))
        return [*self._in_general(found, t), Equation((moves,))]

    def _in_general(self, found: Harmonic, t: sp.Symbol) -> Iterator[Block]:
        """x = A cos ω_0 t + B sin ω_0 t, and what the start makes of A and B."""
        problem = self.found.problem
        taken = {str(p.name) for p in problem.points} | {str(b.name) for b in problem.bodies}
        taken |= {s.name for s in self.found.ledger.symbols.values()}
        names = ("A", "B") if not {"A", "B"} & taken else ("C_1", "C_2")
        first, second = (sp.Symbol(n, real=True) for n in names)
        whole = line(Math(first * sp.cos(NATURAL * t)), " + ", Math(second * sp.sin(NATURAL * t)))
        q, rate = Math(found.coordinate), Name(f"{found.coordinate.name}_dot")
        place = line(q, " = ", Math(first), " = ", self.phrases.math(found.a))
        speed = line(rate, " = ", Math(second * NATURAL), " = ", self.phrases.math(found.b))
        note = line("at ", Math(t), " = 0: ", *place, ", ", *speed)
        if found.b != 0:
            note = line(*note, ", ", Math(second), " = ", self.phrases.math(simplified(found.b / NATURAL)))
        yield Equation((line(q, " = ", *whole),), None, (), note)

    def _phase(self, found: Harmonic, r: Result, state: str) -> list[Block]:
        """ω_0 t = π, before the time itself."""
        if r.formula is None or r.unknown != found.time:
            return []
        number = simplified(r.formula * sp.sqrt(found.square))
        if not number.is_number or number.has(sp.Float):
            return []
        self._phases[state] = (found, number)
        return [Equation((Math(NATURAL * found.time), Math(number)))]

    def _reached(self, leg: RouteStep, number: int) -> list[Block]:
        """x_stop = l cos(ω_0 t_stop) = l cos π = -l, instead of another law; ẋ likewise. Empty of anything else."""
        (e, *more), (r, *others) = leg.relations, leg.results
        if more or others or e.stop not in self._phases or r.formula is None:
            return []
        found, phase = self._phases[e.stop]
        at_place = self.found.general.get(r.unknown) == found.coordinate
        if found.b != 0 or not (at_place or (e.kind == "v(t)" and harmonic(e, self.found.route, self.found.general))):
            return []
        factor, wave = (found.a, sp.cos) if at_place else (-found.a * NATURAL, sp.sin)
        result = (factor * wave(phase)).xreplace({NATURAL: sp.sqrt(found.square)})
        if not identically_zero(result - r.formula):
            return []
        angle = sp.Symbol("phase", real=True)
        put = Math(self.phrases.math(factor * wave(angle)).expr, {angle: plain(phase)})
        told = found.place(found.time) if at_place else found.rate(found.time)
        sides = (self.phrases.math(r.unknown), self.phrases.math(told), put)
        return [Equation((*sides, self.phrases.math(r.formula)), number)]
