"""Quantities over spans as blocks: the integral as it is written, what it is done by, and its value."""

from __future__ import annotations

from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from planar_cli.problem.dimensions import Lookup, dimension_of
from planar_cli.problem.expression import Quantity
from planar_cli.report.blocks import Block, Equation, Inline, Line, Paragraph, Result, Value, line
from planar_cli.report.words import Phrases
from planar_cli.solve.between.trace import Piece, SpanIntegral
from planar_cli.units import ANGULAR_MOMENTUM, TIME, Dimension, default_unit

ANGULAR_IMPULSE = "N*m*s"
HOW = {
    "difference": "antiderivative",
    "integral": "with the motion as a function of time",
    "quadrature": "with the motion as a function of time, by quadrature",
    "flow": "by numerical integration",
}


def span_blocks(found: SpanIntegral, lookup: Lookup, phrases: Phrases, symbolic: bool) -> Iterator[Block]:
    """How one quantity over a span came about. `lookup`: kinds of names, for the unit. `symbolic`: letters remain, so
    that no numbers are printed.
    """
    q = found.quantity
    assert isinstance(q.at, tuple)
    about = "/".join(q.things)
    named = f"{q.word}({about})" if about else q.word
    yield Paragraph(line(f"{named} from state {q.at[0]} to state {q.at[1]}:"))
    if q.word == "count":
        yield from _events(found)
        return
    kind = dimension_of(q, lookup)
    summed = kind.dimension * TIME if q.word == "mean" and kind.dimension is not None else kind.dimension
    unit = _unit(q, summed, kind.angle)
    for piece in [p for p in found.pieces if p.integrand != 0] or found.pieces[:1]:
        yield from _piece(piece, phrases, symbolic, unit, q.parts[0].kind if q.parts else "")
    if found.duration != 1:
        sides: list[Inline | Line] = [line("mean (the sum divided by ", phrases.math(found.duration), ")")]
        if not symbolic:
            sides.append(Value(found.number, _unit(q, kind.dimension, kind.angle)))
        yield Equation(tuple(sides))
    elif len(found.pieces) > 1 and not symbolic:
        yield Result(line("together ", Value(found.number, unit)))


def _unit(q: Quantity, dimension: Dimension | None, angle: bool) -> str:
    """The SI unit of a quantity over a span: joule for work and heat, newton metre second for an angular impulse."""
    if dimension is None:
        return ""
    if q.word in ("work", "heat"):
        return "J"
    if q.word == "impulse" and dimension == ANGULAR_MOMENTUM:
        return ANGULAR_IMPULSE
    return default_unit(dimension, angle).text


def _piece(piece: Piece, phrases: Phrases, symbolic: bool, unit: str, axis: str) -> Iterator[Block]:
    """One part of a span. `axis`: of which component it is, "" of none."""
    time = sp.Symbol("t", real=True)
    if piece.how == "blow":
        blow: list[Inline | Line] = [phrases.math(piece.integrand)]
        if not symbolic:
            blow.append(Value(piece.number, unit))
        along = f", {axis}" if axis else ""
        yield Equation(tuple(blow), None, line(f"in the blow from {piece.since} to {piece.until}{along}:"))
        return
    integrand = piece.over_time if piece.how in ("integral", "quadrature") else piece.integrand
    shown = sp.Integral(integrand, (time, *piece.limits))
    sides: list[Inline | Line] = [phrases.math(shown)]
    if piece.formula is not None and not piece.turns:
        sides.append(phrases.math(piece.formula))
    if not symbolic:
        sides.append(Value(piece.number, unit))
    lead: Line = line(f"{axis}:") if axis else ()
    if piece.turns:
        lead = line("the parts between the turning points, each counted positive:")
    note = line(HOW[piece.how])
    if piece.how == "difference" and piece.antiderivative is not None:
        note = line(HOW[piece.how], " ", phrases.math(piece.antiderivative))
    yield Equation(tuple(sides), None, lead, note)
    if piece.turns:
        yield Result(line("it turns at ", *_times(piece.turns)))


def _events(found: SpanIntegral) -> Iterator[Block]:
    if found.events:
        yield Result(line(f"it happens {len(found.events)} times: at ", *_times(found.events)))
    else:
        yield Result(line("it does not happen"))


def _times(times: tuple[Decimal, ...]) -> list[str | Inline]:
    shown: list[str | Inline] = []
    for n, t in enumerate(times):
        shown += [", "] if n else []
        shown.append(Value(t, "s"))
    return shown
