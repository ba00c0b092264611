"""The components of v_A + ω × r and of a_A + α × r - ω² r with their numbers: [-1.307, -0.7546 + 0.6 (-11.32)]."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from decimal import Decimal

import sympy as sp

from planar_cli.records import record
from planar_cli.report.blocks import Line, Math, line
from planar_cli.report.enough_figures import figures_of
from planar_cli.report.numbers import significant
from planar_cli.report.ordering import NUMBER

MOST_TERMS = 6
"""Two components with more terms together are read off the vectors."""

Power = tuple[Decimal, int]
"""A number inside a product, and how often it stands in it: the ω of ω². Numbers that are only equal stay apart."""

NOTHING = Decimal("1e-12")
"""A sum of which so little is left is zero: it is what the motion keeps."""


@record
class Turned:
    """What a point of a body has beside another: `base` its velocity or acceleration, `turn` ω or α, `arm` the vector
    to the point, `spin` the ω of - ω² r, zero of a velocity; all in the units of the page.
    """

    base: tuple[Decimal, Decimal]
    turn: Decimal
    arm: tuple[Decimal, Decimal]
    spin: Decimal

    def parts(self, axis: int) -> Iterator[tuple[int, tuple[Power, ...]]]:
        """The terms along x (0) or y (1) that are not zero: sign and factors."""
        across, along = self.arm[1 - axis], self.arm[axis]
        if self.base[axis]:
            yield 1, ((self.base[axis], 1),)
        if self.turn and across:
            yield (-1 if axis == 0 else 1), ((across, 1), (self.turn, 1))
        if self.spin and along:
            yield -1, ((along, 1), (self.spin, 2))


def components_told(turned: Turned, figures: int) -> Line:
    """Both components as sums; empty where each is one number, or they are too long."""
    found = [list(turned.parts(axis)) for axis in (0, 1)]
    if all(len(parts) == 0 or (len(parts) == 1 and len(parts[0][1]) == 1) for parts in found):
        return ()
    if sum(map(len, found)) > MOST_TERMS:
        return ()
    x, y = (sum_of_products(parts, figures) for parts in found)
    return line("[", x, ", ", y, "]")


def sum_of_products(parts: Sequence[tuple[int, tuple[Power, ...]]], figures: int) -> Math:
    """A sum of signed products of numbers, with as many figures as its result needs."""
    if not parts:
        return Math(sp.S.Zero)
    numbers = [n for _, factors in parts for n, _ in factors]

    def worked(values: Sequence[Decimal]) -> Decimal:
        left, total = list(values), Decimal(0)
        for sign, factors in parts:
            product = Decimal(sign)
            for _, power in factors:
                product *= left.pop(0) ** power
            total += product
        return total

    total = worked(numbers)
    if abs(total) <= NOTHING * max(map(abs, numbers)):
        return Math(sp.S.Zero)
    enough = figures_of(numbers, worked, figures)
    texts: dict[sp.Symbol, str] = {}
    terms: list[sp.Expr] = []
    for i, (sign, factors) in enumerate(parts):
        own: list[sp.Expr] = []
        for j, (number, power) in enumerate(factors):
            symbol = sp.Symbol(f"{NUMBER}{i}{j}", real=True)
            texts[symbol] = significant(number, enough)
            own.append(symbol**power)
        terms.append(sp.Mul(sign, *own, evaluate=False) if sign < 0 or len(own) > 1 else own[0])
    return Math(sp.Add(*terms, evaluate=False) if len(terms) > 1 else terms[0], texts)
