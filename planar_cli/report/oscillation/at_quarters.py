"""A simple harmonic motion a quarter or half a period after it began: its phase is a number, so that place and velocity
follow at sight.

(4)  cos(ω_n t_1) = 0         x_1 = x_eq
          ω_n t_1 = π/2
(5)  ẋ_1 = x_eq ω_n sin(π/2) = x_eq ω_n
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

from planar_cli.calculus.linear_laws import UNDAMPED
from planar_cli.equation.algebra.plain import derivative, simplified
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, line
from planar_cli.report.notation.notation import plain
from planar_cli.report.words.origins import head, is_vibration, letters_of
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.trace import MotionTrace, Result, RouteStep, RouteTrace


@record
class Quarter:
    """The sine or cosine in such a relation, and the number that its angle is."""

    wave: sp.Expr
    number: sp.Expr

    @property
    def angle(self) -> sp.Expr:
        return self.wave.args[0]


def quarter(leg: RouteStep, route: RouteTrace) -> Quarter | None:
    """That of a step; None: it is of another motion, or at another time."""
    (e, *more), (r, *others) = leg.relations, leg.results
    if more or others or r.formula is None or e.span is None or e.span.words != UNDAMPED or not is_vibration(e):
        return None
    waves = e.residual.xreplace(dict(route.plain)).atoms(sp.sin, sp.cos)
    if len(waves) != 1:
        return None
    (wave,) = waves
    number = simplified(wave.args[0].xreplace(dict(route.plain)).xreplace(dict(route.formulas)))
    return Quarter(wave, number) if (2 * number / sp.pi).is_integer else None


def _is_quarter(step: RouteStep, route: RouteTrace) -> bool:
    return quarter(step, route) is not None


def date_blocks(leg: RouteStep, found: MotionTrace, phrases: Phrases, number: int) -> list[Block]:
    """The phase at a state, where the time itself serves nothing else: its sine or cosine, then the phase. Empty: the
    time is told.
    """
    q, route, (x, *_) = quarter(leg, found.route), found.route, leg.unknowns
    if q is None or x not in q.wave.free_symbols or is_asked(leg, found, _is_quarter):
        return []
    wave, residual = sp.Dummy(), leg.relations[0].residual.xreplace(dict(route.plain))
    own = residual.xreplace({q.wave: wave})
    told = q.wave.func(q.number)
    # What is left beside the sine or cosine says where it is: x_1 = x_eq.
    rest = simplified(own.xreplace({wave: told}))
    where: Line = ()
    if rest != 0:
        letter = next((s for s in rest.free_symbols if s in found.general), None)
        if letter is None or len(rest.free_symbols) != 2 or not _plain_sum(rest):
            return []
        where = line(Math(letter), " = ", phrases.math(simplified(letter - rest / derivative(rest, letter))))
    return [
        Paragraph(head(leg.relations[0], found.ledger.symbols)),
        Equation((phrases.math(q.wave), Math(told)), number, (), where),
        Equation((phrases.math(q.angle), Math(q.number))),
    ]


def _plain_sum(rest: sp.Expr) -> bool:
    return all(derivative(rest, s).is_number for s in rest.free_symbols)


def is_asked(leg: RouteStep, found: MotionTrace, spared: Callable[[RouteStep, RouteTrace], bool]) -> bool:
    """Is the unknown of a step asked for, or does anything rest on it but steps that are spared?"""
    (x, *_), routes = leg.unknowns, [found.route, *found.passing.values()]
    others = [(step, route) for route in routes for step in route.steps if step is not leg and x in letters_of(step)]
    if any(not spared(step, route) for step, route in others):
        return True
    asked = {s for r in found.requests for e in (*r.parts, *(f for _, f in r.beside)) for s in e.free_symbols}
    asked |= {s for span in found.spans for piece in span.pieces for s in piece.limits}
    return x in asked


def with_number(leg: RouteStep, chain: Callable[[Result], tuple[Any, ...]], route: RouteTrace, phrases: Phrases) -> Any:
    """The sides of the first result of a step, of such a motion with the number of its phase: x_2 = x_eq cos π."""
    q, (e, *_), r = quarter(leg, route), leg.relations, leg.results[0]
    sides = chain(r)
    if q is None or r.unknown in q.wave.free_symbols:
        return sides
    whole, angle = r.unknown - e.residual.xreplace(dict(route.plain)), sp.Symbol("phase", real=True)
    if r.unknown in whole.free_symbols or whole.xreplace({q.wave: q.wave.func(q.number)}) == 0:
        return sides
    shown = phrases.math(whole.xreplace({q.wave: q.wave.func(angle)}))
    return (sides[0], Math(shown.expr, {**(shown.values or {}), angle: plain(q.number)}), *sides[1:])
