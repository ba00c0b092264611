"""The numbers that a page prints: every equation of a document, evaluated as it stands."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Any

import sympy as sp

from planar_cli.base_units import in_base
from planar_cli.equation.exact import Valuation
from planar_cli.report.blocks import Block, Equation, Math, Text, Value
from planar_cli.units import parse_unit

NEAR, ROUNDING = 1.03, 1e-9
PLAIN = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--")


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
    chain: list[Any] = []
    for side in block.sides:
        parts = side if isinstance(side, tuple) else (side,)
        for i, part in enumerate(parts):
            if isinstance(part, Text) and part.text.strip() == ",":
                yield chain
                chain = []
            # What stands among words is no side: only what they end with.
            elif isinstance(part, Math | Value) and (i + 1 == len(parts) or _divides(parts[i + 1])):
                chain.append(part)
    yield chain


def _divides(part: Any) -> bool:
    return isinstance(part, Text) and part.text.strip() in (",", "=")


def _terms(expr: sp.Expr, numbers: dict[sp.Symbol, float]) -> list[float]:
    put = {s: sp.Float(x, 30) for s, x in numbers.items()}
    return [
        abs(complex(x)) if not x.is_real else float(x) for x in (sp.N(t.xreplace(put)) for t in sp.Add.make_args(expr))
    ]


def read_number(text: str) -> float:
    """A number as it is printed: 1.5×10⁻⁴, 30°."""
    text = text.removesuffix(" rad")
    degrees = text.endswith("°")
    mantissa, _, power = text.rstrip("°").partition("×10")
    number = float(mantissa.translate(PLAIN)) * 10 ** int(power.translate(PLAIN) or 0)
    return number * float(sp.pi) / 180 if degrees else number
