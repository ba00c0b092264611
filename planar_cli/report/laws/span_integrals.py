"""Quantities over spans as blocks: the integral as it is written, its formula, its numbers and its value."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.system.setup import ANGULAR_IMPULSE
from planar_cli.equation.values.ledger import Kind, display
from planar_cli.problem.language.dimensions import Lookup, dimension_of
from planar_cli.problem.language.expression import Quantity, Relation
from planar_cli.records import record
from planar_cli.report.document.blocks import Block, Equation, Line, Math, Paragraph, Result, Text, Value, line
from planar_cli.report.in_numbers.put_in import Writer
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.words.spoken import spoken
from planar_cli.report.words.words import Phrases
from planar_cli.solve.between.trace.span_trace import Piece, SpanIntegral
from planar_cli.units import ANGULAR_MOMENTUM, TIME, Dimension, default_unit, parse_unit

NUMERICAL = {
    "quadrature": line("by numerical integration"),
    "flow": line("by numerical integration, with the motion"),
}
SHORT = 16
"""A longer integrand is printed with its numbers."""
MOST = 6
"""So many times of what is counted are listed, and the last."""
FEW = 2
"""So many integrals stand in one line."""


@record
class SpanTelling:
    """Tells quantities over spans. `lookup`: kinds of names, for units; `varying`: letters that run in an integral."""

    lookup: Lookup
    phrases: Phrases
    varying: Collection[sp.Symbol]

    def blocks(self, found: SpanIntegral) -> Iterator[Block]:
        """How one came about that is no answer by itself. Of one impulse of a blow, and of none, all was said there."""
        (first, *more) = found.pieces
        told = first.how == "blow" and not more and found.duration == 1
        if told and (first.integrand == 0 or _is_letter(first.integrand)):
            return
        q = found.quantity
        assert isinstance(q.at, tuple)
        about = "/".join(q.things)
        named = f"{q.word}({about})" if about else q.word
        said = spoken(named, ())
        if said and isinstance(said[0], Text):
            said = (Text(said[0].text[:1].upper() + said[0].text[1:]), *said[1:])
        yield Paragraph(line(*said, f" from state {q.at[0]} to state {q.at[1]}:"))
        if q.word == "count":
            yield from _events(found, ())
            return
        axis = f", {q.parts[0].kind}" if q.parts else ""
        blows = [p for p in found.pieces if p.how == "blow"]
        lead: Line = ()
        if blows and len(found.pieces) == 1:
            lead = line(f"in the blow from {blows[0].since} to {blows[0].until}{axis}:")
        elif axis:
            lead = line(f"{q.parts[0].kind}:")
        if found.duration != 1:
            lead = line("mean (the sum divided by ", self.phrases.math(found.duration), "):")
        yield from self.lines(found, lead, ())

    def lines(self, found: SpanIntegral, lead: Line, last: tuple[Any, ...]) -> Iterator[Block]:
        """The integral or integrals, then `last`: formula, numbers and value of an answer (none: its own value)."""
        if found.quantity.word == "count":
            yield from _events(found, last)
            return
        pieces = [p for p in found.pieces if p.integrand != 0] or list(found.pieces[:1])
        pieces = _counted_positive(pieces) if any(p.turns for p in pieces) else _joined(pieces)
        shown = [self._integral(p) for p in pieces]
        note = next((NUMERICAL[p.how] for p in pieces if p.how in NUMERICAL), ())
        turns = tuple(t for p in pieces for t in p.turns)
        last = last or self._last(found)
        name, *rest = last if isinstance(last[0], tuple) else ((), *last)
        whole = None if turns or any(p.how == "blow" for p in pieces) else self._whole(found, shown)
        first = () if whole is None else (whole,)
        told = any(isinstance(side, Math) and not side.values for side in rest)
        changes = whole is not None and all(p.how == "change" for p in pieces)
        if changes or (told and len(last) > 1 and len(pieces) == 1 and self._is_steady(pieces[0])):
            # A constant force times the way, a constant rate times the time; several parts are told by their integrals.
            first, note = (), _changed(found.quantity) if changes else note
        elif whole is None and len(pieces) > 1:
            for piece, math in zip(pieces, shown, strict=True):
                yield Equation((math, self._number(found, piece)))
        if turns:
            lead = line("the parts between the turning points, each counted positive:")
            first = (shown[0],) if len(pieces) == 1 else ()
            rest = rest[-1:]
        sides = (*((name,) if name else ()), *first, *rest)
        yield Equation(sides, None, lead, note)
        if turns and found.dated:
            yield Result(line("it turns at ", *_times(turns)))

    def _is_steady(self, piece: Piece) -> bool:
        """Is the integrand constant, or a velocity times a constant?"""
        if piece.how == "blow" or piece.turns or piece.formula is None:
            return False
        roles, time = self.phrases.ledger.roles, sp.Symbol("t", real=True)
        moving = {time, *self.varying}
        speeds = [s for s in piece.integrand.free_symbols & moving if s in roles and roles[s].kind is Kind.SPEED]
        rates = [sp.diff(piece.integrand, s) for s in speeds]
        rest = piece.integrand.xreplace(dict.fromkeys(speeds, sp.S.Zero))
        steady = not any(e.free_symbols & moving for e in (*rates, rest))
        return steady and len(speeds) <= 1 and not (speeds and rest)

    def _whole(self, found: SpanIntegral, shown: list[Math]) -> Math | None:
        """The few integrals in one formula."""
        if len(shown) > FEW:
            return None
        texts = {s: t for m in shown for s, t in (m.values or {}).items()}
        expr = sp.Add(*(m.expr for m in shown), evaluate=False) if len(shown) > 1 else shown[0].expr
        return Math(expr if found.duration == 1 else sp.Mul(1 / found.duration, expr, evaluate=False), texts)

    def _integral(self, piece: Piece) -> Math:
        """One integral over time; a long integrand with its numbers."""
        if piece.how == "blow":
            return self.phrases.math(piece.integrand)
        time = sp.Symbol("t", real=True)
        integrand = piece.over_time if piece.over_time is not None and piece.how != "flow" else piece.integrand
        letters = Math(integrand) if self.phrases.symbolic else None
        if letters is None and (longer(integrand, SHORT) or not is_clean(self.phrases.ledger, integrand)):
            writer = Writer({*self.varying, time}, self.phrases)
            written = writer.written(integrand)
            letters = None if written is None else Math(written, writer.texts)
        math = letters or self.phrases.math(integrand)
        return Math(sp.Integral(math.expr, (time, *piece.limits)), math.values)

    def named(self, found: SpanIntegral, value: Value) -> Value:
        """A value with the usual name of its unit: newton metre second for an angular impulse."""
        text = self._value(found, Decimal(0), summed=False).unit
        return replace(value, unit=text) if text == ANGULAR_IMPULSE and not self.phrases.ledger.us else value

    # --- values ------------------------------------------------------------------------------------------------------

    def _last(self, found: SpanIntegral) -> tuple[Any, ...]:
        """The formula of a quantity where it is short, and its value."""
        formula = found.formula
        short = formula is not None and not longer(formula, 2 * SHORT)
        formula = factor_terms(formula) if short else formula
        kind = dimension_of(found.quantity, self.lookup)
        clean = short and (self.phrases.symbolic or is_clean(self.phrases.ledger, formula, dimension=kind.dimension))
        shown = (self.phrases.math(formula),) if clean else ()
        if self.phrases.symbolic:
            return shown
        value = self._value(found, found.number, found.quantity.word == "mean" and found.duration == 1)
        return (*shown, *(self.phrases.substituted(formula, value) if short else ()), value)

    def _number(self, found: SpanIntegral, piece: Piece) -> Any:
        if self.phrases.symbolic:
            return self.phrases.math(sp.S.Zero if piece.formula is None else piece.formula)
        return self._value(found, piece.number, found.quantity.word == "mean")

    def _value(self, found: SpanIntegral, number: Decimal, summed: bool) -> Value:
        """A number in the units of the page. `summed`: of a mean the sum, not yet divided by the time."""
        kind = dimension_of(found.quantity, self.lookup)
        dimension = kind.dimension * TIME if summed and kind.dimension is not None else kind.dimension
        text = _unit(found.quantity, dimension, kind.angle)
        if not text or text == "1" or kind.angle:
            return Value(number, text, self.phrases.figures)
        own = self.phrases.page_unit(parse_unit(text))
        shown = text if not self.phrases.ledger.us else own.text
        return Value(display(number, own, self.phrases.ledger.us), shown, self.phrases.figures)


def _changed(q: Quantity) -> Line:
    """What the impulse of everything changes."""
    return line("change of momentum" if q.parts else f"change of angular momentum about {q.things[1]}")


def _joined(pieces: list[Piece]) -> list[Piece]:
    """Neighbours with one integrand as one."""
    found: list[Piece] = []
    for p in pieces:
        last = found[-1] if found else None
        same = last is not None and last.integrand == p.integrand and last.until == p.since and last.how == p.how
        if last is not None and same and p.how in ("difference", "change") and not (p.turns or last.turns):
            limits, number = (last.limits[0], p.limits[1]), last.number + p.number
            found[-1] = replace(p, since=last.since, limits=limits, number=number, formula=None)
        else:
            found.append(p)
    return found


def _counted_positive(pieces: list[Piece]) -> list[Piece]:
    """The size of the velocity instead of itself; neighbours with one integrand as one."""
    found: list[Piece] = []
    for p in pieces:
        size, last = abs(p.integrand), found[-1] if found else None
        if last is not None and last.integrand == size and last.until == p.since:
            limits, turns = (last.limits[0], p.limits[1]), last.turns + p.turns
            found[-1] = replace(last, until=p.until, limits=limits, turns=turns, over_time=None)
        else:
            found.append(replace(p, integrand=size, over_time=None if p.over_time is None else abs(p.over_time)))
    return found


def _unit(q: Quantity, dimension: Dimension | None, angle: bool) -> str:
    """The SI unit of a quantity over a span: joule for work and heat, newton metre second for an angular impulse."""
    if dimension is None:
        return ""
    if q.word in ("work", "heat"):
        return "J"
    if q.word == "impulse" and dimension == ANGULAR_MOMENTUM:
        return ANGULAR_IMPULSE
    return default_unit(dimension, angle).text


def _events(found: SpanIntegral, last: tuple[Any, ...]) -> Iterator[Block]:
    """What is counted, when it happens and how often. `last`: the sides of an answer, its name first."""
    counted = found.quantity.argument
    what = spoken(counted.text, ()) if isinstance(counted, Relation) else line("it")
    number = len(found.events)
    how_often = line(*last[:1], f" = {number}") if last else line(f"{number} times")
    when = line(" at ", *_times(found.events)) if found.events and found.dated else ()
    yield Result(line(*what, *when, ": ", *how_often))


def _times(times: tuple[Decimal, ...]) -> list[Any]:
    """t_1, t_2 and so on; of many the first ones and the last."""
    shown: list[Any] = []
    for n, t in enumerate(times[:MOST] if len(times) > MOST else times):
        shown += [", "] if n else []
        shown.append(Value(t, "s"))
    return [*shown, ", …, ", Value(times[-1], "s")] if len(times) > MOST else shown


def _is_letter(expr: sp.Expr) -> bool:
    return bool(expr.is_Symbol or (-expr).is_Symbol)
