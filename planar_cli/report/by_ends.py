"""What is asked of a span in a word: a mean acceleration by the velocities at both ends, (v_1 - v_0)/t_1, and the work
of all that does work by the kinetic energies, T_1 - T_0.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from planar_cli.equation.ledger import Kind
from planar_cli.report.blocks import Math, Name, Value, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.span_trace import SpanIntegral
from planar_cli.solve.between.trace import BalanceTrace, MotionTrace


def by_ends(span: SpanIntegral, found: MotionTrace, phrases: Phrases, value: Value) -> tuple[Any, ...]:
    """The sides between the name of such a find and its value; empty of another one."""
    if phrases.symbolic:
        return ()
    return _mean(span, found, phrases) or _work(span, found, phrases, value)


def _mean(span: SpanIntegral, found: MotionTrace, phrases: Phrases) -> tuple[Any, ...]:
    """Of an acceleration."""
    if span.quantity.word != "mean" or len(span.pieces) != 1 or span.pieces[0].how != "difference":
        return ()
    (piece,) = span.pieces
    rate_of, roles = piece.antiderivative, found.ledger.roles
    ends = {roles[s].at: s for s, general in found.general.items() if general == rate_of}
    if rate_of is None or rate_of not in roles or roles[rate_of].kind is not Kind.SPEED:
        return ()
    if not {piece.since, piece.until} <= ends.keys():
        return ()
    time = span.duration.xreplace({s: f for s, f in found.route.plain.items() if f == 0})
    change = sp.Add(ends[piece.until], -ends[piece.since], evaluate=False)
    quotient = sp.Mul(change, sp.Pow(time, -1, evaluate=False), evaluate=False)
    sizes = {s: size for s in quotient.free_symbols if (size := found.value.known(s)) is not None}
    put = phrases.numbers(quotient, sizes, turns=False) if sizes.keys() == quotient.free_symbols else None
    return Math(quotient), *(() if put is None else (put,))


def _work(span: SpanIntegral, found: MotionTrace, phrases: Phrases, value: Value) -> tuple[Any, ...]:
    """Of the one source of a balance of energies in which its work held what was sought."""
    q = span.quantity
    if q.word != "work" or span.formula is None:
        return ()
    legs = [(leg, e.source) for leg in found.route.steps for e in leg.relations if isinstance(e.source, BalanceTrace)]
    for leg, b in legs:
        works = [(words, e) for words, e in b.brought if not found.value.is_zero(e)]
        if not b.law.letter or (b.since, b.stop) != q.at or len(works) != 1:
            continue
        ((words, work),) = works
        zeros = {s: f for s, f in found.route.formulas.items() if f == 0}
        change = (b.after - b.before).xreplace(zeros)
        if words.split()[-1:] != list(q.things) or change.free_symbols & set(leg.unknowns):
            continue
        if work.free_symbols & set(leg.unknowns) and found.value.is_zero(work - span.formula):
            energies = line(Name(f"{b.law.letter}__{b.stop}"), " - ", Name(f"{b.law.letter}__{b.since}"))
            told = change.xreplace(dict(found.route.plain))
            first = line(Name(b.law.bring), f" of the {words}")
            return first, energies, phrases.math(told), *phrases.substituted(told, value)
    return ()
