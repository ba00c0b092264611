"""A kinetic energy that a balance has told is the same formula where a share of it is asked: T_2 = 1/2 I_C ω_2²."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.report.blocks import Block, Equation, Inline, Line, Math, Name, Value
from planar_cli.report.words import Phrases

ENERGY = "T__"
"""So begins the letter of the kinetic energy at a state."""
ROUNDED = Decimal("1e-3")
"""A formula with a rounded number gives a value that is off by less, in parts of it."""


def as_told(asked: Iterable[Block], way: Sequence[Block], phrases: Phrases) -> Iterator[Block]:
    """What is asked, with energies by the formulas that stand on the way to it: T_2 = 1/2 I_C ω_2² = 9.067 ω_2² there,
    T_2 = 1/2 I_C ω_2² = 9.067 (-1.8964)² = 32.61 J here. Balances of several groups call the energy of each by one
    letter: only that of the same speeds and value is the one that is asked.
    """
    told = {_energy(b): b.sides for b in way if isinstance(b, Equation) and len(b.sides) > 2}
    for b in asked:
        sides = told.get(_energy(b)) if isinstance(b, Equation) and _energy(b) else None
        alike = sides is not None and isinstance(b, Equation) and _is_same(sides, b, phrases)
        numbers = _numbers(sides[2], phrases) if alike and sides is not None else None
        if numbers is not None and sides is not None and isinstance(b, Equation):
            yield replace(b, sides=(b.sides[0], sides[1], numbers, b.sides[-1]))
        else:
            yield b


def _energy(b: Equation) -> str:
    """The name of the energy of a state that an equation gives; empty: it gives none."""
    match b.sides[0]:
        case Math(expr) if expr.is_Symbol:
            found = str(expr.name)
        case (Name(name),):
            found = name
        case _:
            found = ""
    return found if found.startswith(ENERGY) else ""


def _is_same(sides: Sequence[Inline | Line], asked: Equation, phrases: Phrases) -> bool:
    """Is what was told of an energy what is asked: of the same speeds, and of the same value?"""
    match sides[1], sides[2], asked.sides:
        case Math(formula), Math(expr, texts), (_, Math(own), *_, Value() as shown) if texts:
            sizes = {s: Decimal(text) for s, text in texts.items()}
            known = phrases.value.extended(sizes).known(expr)
            near = known is not None and abs(known - shown.number) <= ROUNDED * abs(shown.number)
            return near and _of_states(formula) == _of_states(own)
    return False


def _of_states(formula: sp.Expr) -> set[sp.Symbol]:
    return {s for s in formula.free_symbols if "__" in s.name}


def _numbers(side: Inline | Line, phrases: Phrases) -> Math | None:
    """A formula of which part is a number, with the numbers of all its letters; None: it is none."""
    if not isinstance(side, Math) or not side.values:
        return None
    sizes = {s: Decimal(text) for s, text in side.values.items() if s in side.expr.free_symbols}
    others = {s: phrases.value.known(s) for s in side.expr.free_symbols - sizes.keys()}
    known = {s: x for s, x in others.items() if x is not None}
    return phrases.numbers(side.expr, {**sizes, **known}, turns=False) if len(known) == len(others) else None
