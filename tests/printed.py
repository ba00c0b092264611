"""The numbers that a page prints: every equation of a document, evaluated as it stands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.equation.values.exact import Valuation
from planar_cli.report.document.blocks import Block, Equation, Math, Text, Value
from planar_cli.units import parse_unit

NEAR, ROUNDING = 1.03, 1e-9
MARKS = re.compile(r"([\[\],/])")
SIGNS = {" + ": 1, " - ": -1}
PLAIN = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")


@dataclass(frozen=True)
class Sum:
    """A side that is written as a sum of formulas, in an order of its own."""

    parts: tuple[Math | Value, ...]
    signs: tuple[int, ...]


@dataclass(frozen=True)
class Quotient:
    """A component of a vector that is written as [a, b]/c."""

    part: Math | Value
    divisor: Math | Value


@dataclass
class Page:
    """Evaluates equations in the units of the page. `value`: numbers of its letters; what the page names itself is
    learnt from the equation in which it stands alone. `us`: it is in feet, slugs and seconds.
    """

    value: Valuation
    us: bool = False
    own: dict[sp.Symbol, float] = field(default_factory=dict)

    def wrong(self, block: Equation, tolerance: float) -> list[str]:
        """Which of its sides differ, in parts of their own terms."""
        found = []
        for sides in _chains(block):
            alone = [s for s in sides if isinstance(s, Math) and s.expr.is_Symbol and not s.values]
            known = [(s, x) for s in sides if (x := self._number(s)) is not None]
            for name in alone:
                if known and self._known(name.expr) is None:
                    self.own[name.expr] = known[-1][1][0]
            for (a, (x, size)), (b, (y, other)) in pairwise(known):
                if abs(x - y) > tolerance * max(size, other):
                    found.append(f"{a} = {x}, {b} = {y}")
        return found

    def _known(self, symbol: sp.Symbol) -> float | None:
        number = self.value.known(symbol)
        return self.own.get(symbol) if number is None else float(number)

    def _number(self, side: Any) -> tuple[float, float] | None:
        """A side, and the size of its terms; None: it holds what has no number here."""
        if isinstance(side, Sum):
            terms = [self._number(part) for part in side.parts]
            told = [t for t in terms if t is not None]
            if len(told) < len(terms):
                return None
            return sum(sign * x for sign, (x, _) in zip(side.signs, told, strict=True)), sum(size for _, size in told)
        if isinstance(side, Quotient):
            above, below = self._number(side.part), self._number(side.divisor)
            return None if above is None or below is None else (above[0] / below[0], above[1] / abs(below[0]))
        if isinstance(side, Value):
            factor = in_base(parse_unit(side.unit), self.us) if side.unit else 1.0
            return float(side.number) * factor, abs(float(side.number) * factor)
        if not isinstance(side, Math) or side.expr.has(sp.Integral, sp.Piecewise):
            return None
        numbers: dict[sp.Symbol, float] = {}
        for s in side.expr.free_symbols:
            text = (side.values or {}).get(s)
            number = self._known(s) if text is None else read_number(text)
            if number is None:
                return None
            numbers[s] = number
        # What is zero beside other numbers is not zero a little beside it.
        here, beside = (_terms(side.expr, {s: x * near for s, x in numbers.items()}) for near in (1, NEAR))
        return sum(here), sum(map(abs, here)) + abs(sum(beside)) + ROUNDING * max(map(abs, numbers.values()), default=0)


def equations(blocks: tuple[Block, ...]) -> Iterator[Equation]:
    """All display equations that say that sides are equal."""
    return (b for b in blocks if isinstance(b, Equation) and b.relation == "=")


def _chains(block: Equation) -> Iterator[list[Any]]:
    """The sides that are equal to each other: one line may hold several equations, separated by commas."""
    vectors = [v for side in block.sides if isinstance(side, tuple) and (v := _components(side))]
    if len(vectors) > 1:
        yield from map(list, zip(*vectors, strict=True))
        return
    chain: list[Any] = []
    for side in block.sides:
        parts = (between,) if (between := _between(side)) else _summed(side) if isinstance(side, tuple) else (side,)
        for i, part in enumerate(parts):
            if isinstance(part, Text) and part.text.strip() == ",":
                yield chain
                chain = []
            # What stands among words is no side: only what they end with.
            elif isinstance(part, Math | Value | Sum) and (i + 1 == len(parts) or _divides(parts[i + 1])):
                chain.append(part)
    yield chain


def _between(side: Any) -> Math | None:
    """What [F(x)] from x = a to b comes to; None: it is another side."""
    texts = [p.text for p in side if isinstance(p, Text)] if isinstance(side, tuple) else []
    if texts != ["[", "] from ", " = ", " to "]:
        return None
    whole, x, low, high = (p.expr for p in side if isinstance(p, Math))
    return Math(whole.xreplace({x: high}) - whole.xreplace({x: low}))


def _components(parts: tuple[Any, ...]) -> list[Any]:
    """The components of [a, b] or [a, b]/c, both pure numbers or formulas; none: it is something else."""
    tokens: list[Any] = []
    for part in parts:
        tokens += [t.strip() for t in MARKS.split(part.text) if t.strip()] if isinstance(part, Text) else [part]
    tokens = [Math(sp.Integer(t)) if isinstance(t, str) and t.isdigit() else t for t in tokens]
    marks = "".join(t if isinstance(t, str) else "x" if isinstance(t, Math | Value) else "?" for t in tokens)
    if marks == "[x,x]":
        return [tokens[1], tokens[3]]
    return [Quotient(tokens[i], tokens[-1]) for i in (1, 3)] if marks == "[x,x]/x" else []


def _summed(parts: tuple[Any, ...]) -> tuple[Any, ...]:
    """The parts of a line, with formulas that a plus or a minus joins as one sum."""
    joined: list[Any] = []
    for part in parts:
        sign = SIGNS.get(joined[-1].text) if joined and isinstance(joined[-1], Text) else None
        if sign and len(joined) > 1 and isinstance(joined[-2], Math | Value | Sum) and isinstance(part, Math | Value):
            before = joined[-2] if isinstance(joined[-2], Sum) else Sum((joined[-2],), (1,))
            joined[-2:] = [Sum((*before.parts, part), (*before.signs, sign))]
        else:
            joined.append(part)
    return tuple(joined)


def _divides(part: Any) -> bool:
    return isinstance(part, Text) and part.text.strip() in (",", "=")


def _terms(expr: sp.Expr, numbers: dict[sp.Symbol, float]) -> list[float]:
    put = {s: sp.Float(x, 30) for s, x in numbers.items()}
    return [
        abs(complex(x)) if not x.is_real else float(x) for x in (sp.N(t.xreplace(put)) for t in sp.Add.make_args(expr))
    ]


def read_number(text: str) -> float:
    """A number as it is printed: 1.5×10⁻⁴, 30°, 3 π/2."""
    text = text.removesuffix(" rad")
    if "π" in text:
        factor, _, divisor = text.partition("π")
        sign = {"": 1.0, "-": -1.0}.get(factor.strip())
        return float(sp.pi) * (float(factor) if sign is None else sign) / float(divisor.removeprefix("/") or 1)
    degrees = text.endswith("°")
    mantissa, _, power = text.rstrip("°").partition("×10")
    number = float(mantissa.translate(PLAIN)) * 10 ** int(power.translate(PLAIN) or 0)
    return number * float(sp.pi) / 180 if degrees else number
