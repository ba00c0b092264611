"""A simple harmonic motion between two states: the motion itself, and when its velocity or its place is what is stated.

x = l cos(ω_0 t),  ẋ = -l ω_0 sin(ω_0 t)
(3)  -l ω_0 sin(ω_0 t_stop) = 0        so that  ω_0 t_stop = π
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from planar_cli.equation.plain import identically_zero, simplified
from planar_cli.records import record
from planar_cli.report.blocks import Block, Equation, Math, Name, line
from planar_cli.report.characteristic import UNDAMPED
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import Relation, Result, RouteStep, RouteTrace

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
    """Tells such motions; a place at a time of which ω_0 t is a number follows by its cosine."""

    def __init__(self, general: Mapping[sp.Symbol, sp.Symbol], phrases: Phrases) -> None:
        self.general, self.phrases = general, phrases
        self._phases: dict[str, tuple[Harmonic, sp.Expr]] = {}

    def blocks(self, e: Relation, leg: RouteStep, route: RouteTrace, number: int) -> list[Block]:
        """The motion in letters, then the equation at the second state; empty of another relation."""
        found = harmonic(e, route, self.general)
        if found is None:
            return []
        t, rate = sp.Symbol("t", real=True), Name(f"{found.coordinate.name}_dot")
        motion = line(Math(found.coordinate), " = ", self.phrases.math(found.place(t)))
        moves = line(*motion, ",  ", rate, " = ", self.phrases.math(found.rate(t)))
        told = found.rate(found.time) if e.kind == "v(t)" else found.place(found.time)
        right = simplified(told.xreplace({NATURAL: sp.sqrt(found.square)}) + e.residual.xreplace(dict(route.plain)))
        phases = [block for r in leg.results for block in self._phase(found, r, e.stop)]
        return [Equation((moves,)), Equation((self.phrases.math(told), self.phrases.math(right)), number), *phases]

    def _phase(self, found: Harmonic, r: Result, state: str) -> list[Block]:
        """ω_0 t = π, before the time itself."""
        if r.formula is None or r.unknown != found.time:
            return []
        number = simplified(r.formula * sp.sqrt(found.square))
        if not number.is_number or number.has(sp.Float):
            return []
        self._phases[state] = (found, number)
        return [Equation((Math(NATURAL * found.time), Math(number)))]

    def place(self, leg: RouteStep, number: int) -> list[Block]:
        """x_stop = l cos(ω_0 t_stop) = l cos π = -l, instead of another law; empty of anything else."""
        (e, *more), (r, *others) = leg.relations, leg.results
        if more or others or e.stop not in self._phases or r.formula is None:
            return []
        found, phase = self._phases[e.stop]
        if self.general.get(r.unknown) != found.coordinate or found.b != 0:
            return []
        if not identically_zero(found.a * sp.cos(phase) - r.formula):
            return []
        put = line(self.phrases.math(found.a), " cos ", Math(phase))
        sides = (self.phrases.math(r.unknown), self.phrases.math(found.place(found.time)), put)
        return [Equation((*sides, self.phrases.math(r.formula)), number)]
