"""Which unknowns of a block are carried as letters: those with which the others are divided by the least.

a_A = l α sin θ, and α carried, rather than α = a_A/(l sin θ), and a_A carried.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from itertools import combinations

import sympy as sp

from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.form import Nonlinear, linear_form
from planar_cli.records import record

LARGEST = 6
"""Blocks of more equations keep the order of the plan."""
LETTER, FUNCTION = 1, 3
"""The price of a division by one letter, and by each sine or cosine."""
LAST = 2
"""The price of what an equation gives into which the others should be put."""

Coefficients = Sequence[dict[sp.Symbol, sp.Expr]]


@record
class Order:
    """Which equation gives which unknown. `equations`: the places of the equations, those that give letters last;
    `unknowns`: the letters last.
    """

    equations: tuple[int, ...]
    unknowns: tuple[sp.Symbol, ...]
    letters: tuple[sp.Symbol, ...]


def easiest(
    residuals: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    letters: Sequence[sp.Symbol],
    vanishes: Callable[[sp.Expr], bool],
    last: Collection[int] = (),
) -> Order:
    """The order in which the fewest terms are divided by; that of the plan where no other is easier.

    residuals: of the equations, in the order in which they give `unknowns`, of which the last are `letters`.
    `vanishes`: is a factor zero where a state is, so that nothing can be divided by it there? `last`: the places of
    equations into which the others are rather put, as a constraint that joins two accelerations.
    """
    given = Order(tuple(range(len(residuals))), tuple(unknowns), tuple(letters))
    if not letters or len(residuals) > LARGEST:
        return given
    try:
        table = [linear_form(r, set(unknowns)).terms for r in residuals]
    except Nonlinear:
        return given
    chained = len(unknowns) - len(letters)

    def price(i: int, x: sp.Symbol) -> float:
        factor = table[i].get(x)
        found = _price(factor) + (LAST if i in last else 0)
        return float("inf") if found and factor is not None and vanishes(factor) else found

    best, least = given, sum(price(i, x) for i, x in zip(range(chained), unknowns, strict=False))
    for chosen in combinations(unknowns, len(letters)):
        found = _chain(table, unknowns, chosen, price)
        if found is not None and found[1] < least:
            best, least = found
    return best


def _chain(
    table: Coefficients,
    unknowns: Sequence[sp.Symbol],
    letters: tuple[sp.Symbol, ...],
    price_of: Callable[[int, sp.Symbol], float],
) -> tuple[Order, float] | None:
    """The unknowns that are no letters one at a time, each by the equation that divides it by the least."""
    left, equations, order, price = list(range(len(table))), list[int](), list[sp.Symbol](), 0.0
    while len(order) < len(unknowns) - len(letters):
        open_ = {i: [x for x in table[i] if x not in letters and x not in order] for i in left}
        ready = [(price_of(i, xs[0]), i, xs[0]) for i, xs in open_.items() if len(xs) == 1]
        if not ready:
            return None
        own, i, x = min(ready, key=lambda r: r[:2])
        price += own
        left.remove(i)
        equations.append(i)
        order.append(x)
    return Order((*equations, *left), (*order, *letters), letters), price


def _price(factor: sp.Expr | None) -> float:
    """What it takes to divide by a factor."""
    if factor is None:
        return float("inf")
    if factor.is_number:
        return 0.0
    functions = len(factor.atoms(sp.sin, sp.cos, sp.tan))
    return LETTER + operations(factor) + FUNCTION * functions
