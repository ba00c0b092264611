"""Equations with the numbers put in: what a page prints where letters would need decimal factors or whole pages.

Every known is a number, and the equation is collected in its unknowns: 24.53 - 0.25 N = 12.5 α, in N·m. All of
them are in the base units of the file, so that the equation is true as it stands.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.in_numbers.order_of_unknowns import in_order
from planar_cli.report.notation.clean import common_dimension
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.units import Dimension, pretty_unit

SMALL = Decimal("1e-30")
"""In parts of the largest term: a term below it is the rounding of sixty digits."""


@record
class Sides:
    """Both sides of an equation in numbers, and what one unit of them is (None: it is not known)."""

    left: Math
    right: Math
    dimension: Dimension | None


def in_numbers(
    left: sp.Expr,
    right: sp.Expr,
    unknowns: Collection[sp.Symbol],
    phrases: Phrases,
    dimension: Dimension | None = None,
    apart: bool = False,
    places: Mapping[sp.Symbol, int] | None = None,
) -> Sides | None:
    """An equation collected in its unknowns, with a number for everything else; None where a known has none, or where
    its unknowns stand in functions. `dimension`: of its sides, where it is known; else that of its terms. `apart`: all
    unknowns on the left, all numbers on the right. `places`: the order of the unknowns, else that of the problem.
    """
    if not all(phrases.has_numbers(s) or s in unknowns for s in (left - right).free_symbols):
        return None
    dimension = dimension or common_dimension(phrases.ledger, left, right)
    writer = Collected(frozenset(unknowns), phrases)
    before, after = writer.terms(left), writer.terms(right)
    if before is None or after is None:
        return None
    if apart:
        before, after = _apart(before, after)
    before, after = (in_order(terms, unknowns, phrases.ledger, places) for terms in (before, after))
    largest = max(map(abs, (*before.values(), *after.values())), default=Decimal(0))
    return Sides(writer.side(before, largest), writer.side(after, largest), dimension)


def amount_in_numbers(expr: sp.Expr, unknowns: Collection[sp.Symbol], phrases: Phrases) -> Math | None:
    """One amount collected in its unknowns; None where `in_numbers` has none."""
    if not all(phrases.has_numbers(s) or s in unknowns for s in expr.free_symbols):
        return None
    writer = Collected(frozenset(unknowns), phrases)
    terms = writer.terms(expr)
    if terms is None:
        return None
    return writer.side(in_order(terms, unknowns, phrases.ledger), max(map(abs, terms.values()), default=Decimal(0)))


def solved_for(
    symbol: sp.Symbol,
    sides: tuple[sp.Expr, sp.Expr],
    unknowns: Collection[sp.Symbol],
    phrases: Phrases,
    balance: bool = False,
) -> Math | None:
    """The numbers that give an unknown, from an equation that is linear in it (or in its square) and in the other
    unknowns, which are known by now: (1.732 - 0.3965 · 2.916)/0.2233. None: it is not, or is a number alone.
    `balance`: of energies, whose sides were told one by one.
    """
    left, right = sides
    if not all(phrases.has_numbers(s) or s in unknowns for s in (left - right).free_symbols):
        return None
    # Of a formula that holds throughout there is no number, and a zero needs none.
    if phrases.value.known(symbol) is None or phrases.value.is_zero(symbol):
        return None
    terms = Collected(frozenset(unknowns), phrases).terms(left - right) or {}
    (power, *more) = [m for m in terms if symbol in m.free_symbols] or (None,)
    if power is None or more:
        return None
    # What is known by now may multiply it.
    beside = sp.S.One if power == symbol**2 else power / symbol
    if symbol in beside.free_symbols:
        return None
    sizes, parts = dict[sp.Symbol, Decimal](), list[sp.Expr]()
    own = terms.pop(power)
    largest = max(map(abs, terms.values()), default=Decimal(0))
    apart = _of_both(sides, unknowns, phrases) if balance and sp.S.One in terms else ()
    rest = [(m, c) for m, c in terms.items() if abs(c) > SMALL * largest and not (apart and m == 1)]
    signed = in_order({m: -c * own for m, c in rest}, unknowns, phrases.ledger)
    for monomial, coefficient in [*((sp.S.One, -c * own) for c in apart), *signed.items()]:
        number = sp.Symbol(f"{NUMBER}{len(sizes)}", positive=True)
        sizes[number] = abs(coefficient / own)
        one = monomial != 1 and significant(sizes[number], phrases.figures) == "1"
        shown = monomial if one else number * monomial
        parts.append(shown if coefficient > 0 else -shown)
    number = sp.Symbol(f"{NUMBER}{len(sizes)}", positive=True)
    sizes[number] = abs(own)
    divided = significant(sizes[number], phrases.figures) != "1"
    alone = len(parts) == 1 and parts[0].as_coeff_Mul()[1].is_Symbol
    if not parts or (alone and not divided and power == symbol):
        return None
    whole = sp.Add(*parts, evaluate=False) if len(parts) > 1 else parts[0]
    below = sp.Mul(*([number] if divided else []), *([] if beside == 1 else [beside]))
    whole = whole if below == 1 else whole / below
    if power == symbol**2:
        whole = sp.sqrt(whole) if phrases.value(symbol) > 0 else -sp.sqrt(whole)
    return phrases.numbers(whole, sizes, turns=False)


def _of_both(sides: tuple[sp.Expr, sp.Expr], unknowns: Collection[sp.Symbol], phrases: Phrases) -> tuple[Decimal, ...]:
    """The numbers without an unknown of both sides, counted on the left: 4.944 and -1.714 of 4.944 = 1.714 + 0.0621 v²,
    whose difference stands nowhere; none where one side has no such number.
    """
    collected = Collected(frozenset(unknowns), phrases)
    left, right = ((collected.terms(side) or {}).get(sp.S.One, Decimal(0)) for side in sides)
    return (left, -right) if left and right else ()


def _apart(
    left: dict[sp.Expr, Decimal], right: dict[sp.Expr, Decimal]
) -> tuple[dict[sp.Expr, Decimal], dict[sp.Expr, Decimal]]:
    """The unknowns on the left, the first of them positive, and the number on the right."""
    whole = dict(left)
    for monomial, coefficient in right.items():
        whole[monomial] = whole.get(monomial, Decimal(0)) - coefficient
    number = -whole.pop(sp.S.One, Decimal(0))
    leading = next((c for c in whole.values() if c), Decimal(1))
    sense = 1 if leading > 0 else -1
    return {m: sense * c for m, c in whole.items()}, {sp.S.One: sense * number}


def unit_note(dimension: Dimension | None, phrases: Phrases) -> Line:
    """In which unit an equation in numbers counts."""
    if dimension is None:
        return ()
    unit = coherent_unit(dimension, us=phrases.ledger.us).text
    return line(f"in {pretty_unit(unit)}") if unit != "1" else ()


class Collected:
    """Sides of one equation in its unknowns."""

    def __init__(self, unknowns: frozenset[sp.Symbol], phrases: Phrases) -> None:
        self.unknowns, self.phrases = unknowns, phrases

    def side(self, terms: dict[sp.Expr, Decimal], largest: Decimal) -> Math:
        """One side as a formula; what is below the rounding of the largest term is left out."""
        texts: dict[sp.Symbol, str] = {}
        parts = []
        for monomial, coefficient in terms.items():
            if abs(coefficient) > SMALL * largest:
                parts.append(self._part(monomial, coefficient, texts))
        return Math(sp.Add(*parts, evaluate=False) if len(parts) > 1 else sp.Add(*parts), texts)

    def _part(self, monomial: sp.Expr, coefficient: Decimal, texts: dict[sp.Symbol, str]) -> sp.Expr:
        """coefficient · monomial, the number behind a symbol that is printed as its text."""
        sign = sp.Integer(-1 if coefficient < 0 else 1)
        shown = significant(abs(coefficient), self.phrases.figures)
        if shown == "1" and monomial != 1:
            return sign * monomial
        number = sp.Symbol(f"{NUMBER}{len(texts)}", positive=True)
        texts[number] = shown
        return sign * number * monomial

    def terms(self, expr: sp.Expr) -> dict[sp.Expr, Decimal] | None:
        """Coefficients by products of unknowns."""
        opened = sp.expand(self._with_rationals(expr)) if expr.free_symbols & self.unknowns else expr
        found: dict[sp.Expr, Decimal] = {}
        for term in sp.Add.make_args(opened) if opened != 0 else ():
            known, monomial = term.as_independent(*self.unknowns, as_Add=False)
            factors = sp.Mul.make_args(monomial)
            if not all(f.is_Symbol or (f.is_Pow and f.base.is_Symbol and f.exp.is_Integer) or f == 1 for f in factors):
                return None
            found[monomial] = found.get(monomial, Decimal(0)) + self.phrases.value(known)
        return found

    def _with_rationals(self, expr: sp.Expr) -> sp.Expr:
        """What holds no unknown as the number that it is."""
        if not expr.free_symbols & self.unknowns:
            return sp.Rational(str(self.phrases.value(expr)))
        if expr.is_Symbol or not (expr.is_Add or expr.is_Mul or expr.is_Pow):
            return expr
        return expr.func(*(self._with_rationals(a) for a in expr.args))


def divides_by_zero(expr: sp.Expr, phrases: Phrases) -> bool:
    """Is a divisor zero but for rounding, as in arctan(v/(x - x_eq)) where x is x_eq? None of that is told."""
    if expr.is_number:
        return False
    powers = (p for p in expr.atoms(sp.Pow) if p.exp.could_extract_minus_sign())
    return any(_vanishes(term, phrases) for p in powers for term in sp.Mul.make_args(p.base) if term.is_Add)


def _vanishes(total: sp.Expr, phrases: Phrases) -> bool:
    """Do the terms of a sum cancel, all but the rounding of sixty digits?"""
    if not all(phrases.has_numbers(s) for s in total.free_symbols):
        return False
    try:
        sizes = [phrases.value(term) for term in total.args]
    except (NoValue, Unvalued):
        return False
    return abs(sum(sizes, Decimal(0))) <= SMALL * max(map(abs, sizes))
