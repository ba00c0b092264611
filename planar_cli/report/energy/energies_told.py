"""A kinetic energy that a balance has told is the same formula where a share of it is asked, T_2 = 1/2 I_C ω_2²; and a
speed that it has told by the one that was sought is not worked out anew, v_B = v_B,2 = -0.09696 (-12.51) = 1.213 m/s.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.report.document.blocks import Block, Equation, Inline, Line, Math, Name, Value
from planar_cli.report.energy.energy_pieces import STATE
from planar_cli.report.notation.numbers import significant
from planar_cli.report.words.words import Phrases

ENERGY, SPEED = "T__", "v_"
"""So begins the letter of the kinetic energy at a state, and of a speed."""
ROUNDED = Decimal("1e-3")
"""A formula with a rounded number gives a value that is off by less, in parts of it."""


def as_told(asked: Iterable[Block], way: Sequence[Block], phrases: Phrases) -> Iterator[Block]:
    """What is asked, with energies by the formulas that stand on the way to it: T_2 = 1/2 I_C ω_2² = 9.067 ω_2² there,
    T_2 = 1/2 I_C ω_2² = 9.067 (-1.8964)² = 32.61 J here. Balances of several groups call the energy of each by one
    letter: only that of the same speeds and value is the one that is asked.
    """
    told = {_energy(b): b.sides for b in way if isinstance(b, Equation) and len(b.sides) > 2}
    speeds = [b for b in way if isinstance(b, Equation) and _is_speed(b)]
    for b in asked:
        if speeds and isinstance(b, Equation) and (shorter := _by_speed(b, speeds, phrases)):
            yield shorter
            continue
        sides = told.get(_energy(b)) if isinstance(b, Equation) and _energy(b) else None
        alike = sides is not None and isinstance(b, Equation) and _is_same(sides, b, phrases)
        numbers = _numbers(sides[2], phrases) if alike and sides is not None else None
        if numbers is not None and sides is not None and isinstance(b, Equation):
            yield replace(b, sides=(b.sides[0], sides[1], numbers, b.sides[-1]))
        else:
            yield b


def _is_speed(b: Equation) -> bool:
    """Is it `v_B,2 = formula = number times what was sought`?"""
    match b.sides:
        case (Math(own), Math(_, None), Math(times, texts)) if texts and times.is_Mul and own.is_Symbol and not b.lead:
            return str(own.name).startswith(SPEED) and STATE in own.name and all(x.is_Atom for x in times.args)
    return False


def _by_speed(b: Equation, speeds: Sequence[Equation], phrases: Phrases) -> Equation | None:
    """What is asked, by a speed of the same formula or the opposite one; None: there is none."""
    match b.sides:
        case (left, Math(formula, None), *_, Value()):
            values = tuple(s for s in b.sides[2:] if isinstance(s, Value))
        case _:
            return None
    for told in speeds:
        own, whole, shown = (side for side in told.sides if isinstance(side, Math))
        if whole.expr.free_symbols != formula.free_symbols or formula.is_Symbol:
            continue
        sign = next((k for k in (1, -1) if sp.expand(formula - k * whole.expr) == 0), 0)
        numbers = _numbers(Math(sign * shown.expr, shown.values), phrases) if sign else None
        if numbers is not None and _gives(numbers, values[0], phrases):
            return replace(b, sides=(left, phrases.math(sign * own.expr), numbers, *values))
    return None


def _gives(numbers: Math, value: Value, phrases: Phrases) -> bool:
    """Do the numbers as they are printed give the value?"""
    printed = {s: Decimal(text) for s, text in (numbers.values or {}).items() if s in numbers.expr.free_symbols}
    found = phrases.value.extended(printed).known(numbers.expr)
    return found is not None and significant(found, value.figures) == significant(value.number, value.figures)


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
