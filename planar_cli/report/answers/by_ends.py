"""What is asked of a span in a word: a mean acceleration by the velocities at both ends, (v_1 - v_0)/t_1; the work of
all that does work by the kinetic energies, T_1 - T_0; a length of path by the ways from turn to turn, and the heat of a
constant friction by that length.
"""

from __future__ import annotations

from decimal import Decimal
from itertools import groupby, takewhile
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import Kind
from planar_cli.report.document.blocks import Math, Name, Value, line
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.span_trace import SpanIntegral
from planar_cli.solve.between.trace.trace import BalanceTrace, MotionTrace
from planar_cli.units import LENGTH


def by_ends(span: SpanIntegral, found: MotionTrace, phrases: Phrases, value: Value) -> tuple[Any, ...]:
    """The sides between the name of such a find and its value; empty of another one."""
    if phrases.symbolic:
        return ()
    told = _mean(span, found, phrases) or _work(span, found, phrases, value)
    return told or _ways(span, found, phrases, value) or _along_the_way(span, found, phrases)


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


def _ways(span: SpanIntegral, found: MotionTrace, phrases: Phrases, value: Value) -> tuple[Any, ...]:
    """Of a length of path with several parts: (x_1 - x_2) + (x_3 - x_2), then the numbers of these; one way, where it
    never turns.
    """
    pieces = [p for p in span.pieces if p.integrand != 0]
    if span.quantity.word != "path_length" or len(pieces) < 2 or any(p.turns or p.formula is None for p in pieces):
        return ()
    parts = [[*same] for _, same in groupby(pieces, key=lambda p: p.integrand)]
    told = [sp.Add(*(p.formula for p in same if p.formula is not None)) for same in parts]
    numbers = [phrases.of_dimension(sum((p.number for p in same), Decimal(0)), LENGTH) for same in parts]
    if any(not f.is_Add or len(f.args) != 2 or longer(f, 2) for f in told) or any(n.number <= 0 for n in numbers):
        return ()
    if len(told) == 1:
        way = told[0].xreplace({s: f for s, f in found.route.formulas.items() if f == 0})
        return phrases.math(way), *phrases.substituted(way, value)
    ways = (x for f in told for x in (" + ", "(", phrases.math(f), ")"))
    sum_of = (x for n in numbers for x in (" + ", significant(n.number, n.figures)))
    return tuple(line(*list(sides)[1:]) for sides in (ways, sum_of))


def _along_the_way(span: SpanIntegral, found: MotionTrace, phrases: Phrases) -> tuple[Any, ...]:
    """Of the heat of a friction that stays the same, where the length of the path was asked before: F s."""
    if span.quantity.word != "heat" or span.formula is None or len(span.pieces) < 2:
        return ()
    ways = {w.symbol: w for w in found.spans if w.quantity.word == "path_length" and w.quantity.at == span.quantity.at}
    for asked in takewhile(lambda r: r.find.found.what != span.quantity, found.requests):
        way = next((w for part in asked.parts for s, w in ways.items() if part in (s, w.formula)), None)
        if way is None or way.formula is None:
            continue
        force, known = simplified(span.formula / way.formula), found.value.known(way.formula)
        if known is None or longer(force, 4) or force.free_symbols & set(found.general):
            continue
        name = sp.Symbol(asked.find.name, positive=True)
        product = sp.Mul(force, name, evaluate=False)
        sizes = {s: size for s in force.free_symbols if (size := found.value.known(s)) is not None}
        put = phrases.numbers(product, {**sizes, name: known}, turns=False)
        return Math(product), *(() if put is None else (put,))
    return ()
