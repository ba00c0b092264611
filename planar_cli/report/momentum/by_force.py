"""What a force that stays what it is makes over a span: its impulse F (t_2 - t_1), and itself as its own mean."""

from __future__ import annotations

from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.report.document.blocks import Math
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.span_trace import Piece, SpanIntegral
from planar_cli.solve.between.trace.trace import MotionTrace

SAME = Decimal("1e-12")
"""What a force times the time may differ from its integral, relative to it."""


def by_force(span: SpanIntegral, found: MotionTrace, phrases: Phrases) -> tuple[Any, ...]:
    """The sides between the name of such a find and its value; empty of another one."""
    (piece, *more) = span.pieces or (None,)
    mean = span.quantity.word == "mean"
    if phrases.symbolic or more or piece is None or piece.letter is None:
        return ()
    number = _told_force(piece, found)
    since, until = (found.value.known(t) for t in piece.limits)
    if number is None or since is None or until is None:
        return ()
    if abs(number * (until - since) - piece.number) > SAME * abs(piece.number):
        return ()
    if mean:
        return (phrases.math(piece.letter),)
    zeros = {t: f for t, f in {**found.route.formulas, **found.route.plain}.items() if f == 0}
    time = sp.Add(piece.limits[1], -piece.limits[0], evaluate=False).xreplace(zeros)
    product = sp.Mul(piece.letter, time, evaluate=False)
    (force,) = piece.letter.free_symbols
    sizes = {s: size for s in time.free_symbols if (size := found.value.known(s)) is not None}
    sizes[force] = number if piece.letter == force else -number
    put = phrases.numbers(product, sizes, turns=False) if sizes.keys() == product.free_symbols else None
    return () if put is None else (Math(product), put)


def _told_force(piece: Piece, found: MotionTrace) -> Decimal | None:
    """The number of what is integrated, in base units; None: the page does not tell its letter."""
    assert piece.letter is not None
    (force,) = piece.letter.free_symbols
    regime = next((r for r in found.regimes if any(a == piece.since != b for a, b in r.stretches)), None)
    if regime is None or regime.solution.quiet or force.name not in (regime.wanted or (force.name,)):
        return None
    _, number = regime.constants.get(force, (None, None))
    return number if number is None or piece.letter == force else -number
