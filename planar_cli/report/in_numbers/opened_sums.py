"""What the numbers of an equation are made of: 15 · 9.81 · 0.6343 before 93.34.

Lengths and angles of the figure are one number for each product of forces, masses, speeds and accelerations; every
letter among these that is known has its own.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from decimal import Decimal

import sympy as sp

from planar_cli.records import changing, record
from planar_cli.report.document.blocks import Math
from planar_cli.report.in_numbers.in_numbers import SMALL, Collected
from planar_cli.report.in_numbers.order_of_unknowns import in_order
from planar_cli.report.notation.enough_figures import figures_of
from planar_cli.report.notation.notation import plain
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER, factor_key
from planar_cli.report.words.words import Phrases
from planar_cli.units import LENGTH, PURE

MOST_TERMS, MOST_FACTORS = 12, 28
"""A sum of more terms, or of more numbers in all, says less than its result."""
FEW_TERMS, PARTS = 6, (1, 2, 4)
"""In a longer sum products of the same numbers are gathered, also with arms that are such parts of the first one."""
ROW_TERMS, ROW_FACTORS = 24, 48
"""The same of equations that stand collected further down, where they are solved together."""

WIDEST = 100
"""Numbers of so many characters fill a row and its beginning behind an unknown."""


@record
class Term:
    """A product: its sign, its numbers with their powers, the length or slope last where there is one (`scaled`: and it
    is not alone), what is still unknown, and the size of all its numbers together.
    """

    sign: int
    numbers: tuple[tuple[Decimal, int], ...]
    rest: sp.Expr
    scaled: bool
    size: Decimal

    def turned(self) -> tuple[tuple[Decimal, int], ...]:
        """The numbers with the length first."""
        return (self.numbers[-1], *self.numbers[:-1]) if self.scaled else self.numbers


def opened_sides(
    sides: Sequence[sp.Expr],
    unknowns: Collection[sp.Symbol],
    phrases: Phrases,
    row: bool = False,
    places: Mapping[sp.Symbol, int] | None = None,
) -> tuple[Math, ...]:
    """Both sides of an equation of forces or moments as sums of products of numbers and unknowns, the arm behind the
    force. Empty: no force has an arm or a slope, they would be too long, or their terms cannot be told. `row`: they
    stand collected further down. `places`: as of `Collected`.
    """
    found = [_terms(side, frozenset(unknowns), phrases, places) for side in sides]
    # A side may have no other term than the rounding of cos 90°.
    largest = max((t.size for own in found for t in own or ()), default=Decimal(0))
    found = [own and [t for t in own if t.size > SMALL * largest] for own in found]
    terms = [t for own in found for t in own or ()]
    if any(own is None for own in found) or not _tells(terms, row):
        return ()
    return tuple(_written(own or [], phrases) for own in found)


def opened_number(residual: sp.Expr, unknowns: Collection[sp.Symbol], phrases: Phrases, negative: bool) -> Math | None:
    """The number of a relation, residual = 0, all of whose unknowns stand on the other side, with lengths first: r ω².
    `negative`: that is the sign of it there. None: it says nothing, or cannot be told.
    """
    terms = [t for t in _terms(residual, frozenset(unknowns), phrases) or () if t.rest == 1]
    if not _tells(terms) and not 1 < len(terms) <= MOST_TERMS:
        return None
    turned = (_worked(terms, [n for t in terms for n, _ in t.numbers]) < 0) != negative
    return _written([replace(t, sign=-t.sign if turned else t.sign, numbers=t.turned()) for t in terms], phrases)


def opened_solution(
    symbol: sp.Symbol, sides: tuple[sp.Expr, sp.Expr], unknowns: Collection[sp.Symbol], phrases: Phrases
) -> Math | None:
    """What gives the one unknown that is left of an equation by its terms as they stand in it:
    (0.125 · 41.82 - 1.5 · 9.81 · 0.15)/0.5. None: it is in several of them, or they are too long.
    """
    terms = _terms(sides[0] - sides[1], frozenset(unknowns), phrases) or []
    held = [t for t in terms if symbol in t.rest.free_symbols]
    if len(held) != 1 or held[0].rest != symbol or len(terms) < 2 or phrases.value.is_zero(symbol):
        return None
    (own,) = held
    sizes: dict[sp.Symbol, Decimal] = {}

    def product(t: Term, sign: int) -> sp.Expr:
        start = len(sizes)
        for i, (number, power) in enumerate(t.numbers, start):
            sizes[sp.Symbol(f"{NUMBER}{i}", positive=True)] = abs(number) if power % 2 == 0 else number
        powers = (s**power for s, (_, power) in zip(list(sizes)[start:], t.numbers, strict=True))
        factors = [*([sp.Integer(-1)] if sign < 0 else []), *powers, *([] if t.rest in (1, symbol) else [t.rest])]
        return sp.Mul(*factors, evaluate=False) if len(factors) != 1 else factors[0]

    others = [(t, -t.sign * own.sign) for t in terms if t is not own]
    # What is positive opens the sum.
    opens = next((i for i, (_, sign) in enumerate(others) if sign > 0), 0)
    parts = [product(*other) for other in (others[opens], *others[:opens], *others[opens + 1 :])]
    whole = sp.Add(*parts, evaluate=False) if len(parts) > 1 else parts[0]
    divided = any(significant(number, phrases.figures) != "1" for number, _ in own.numbers)
    told = phrases.numbers(whole / product(own, 1) if divided else whole, sizes, turns=False)
    return told if told is not None and len(plain(told.expr, told.values)) <= WIDEST else None


def _tells(terms: Sequence[Term], row: bool = False) -> bool:
    """Is there a length or a slope beside another number, and are the sums short enough?"""
    counted = sum(len(t.numbers) for t in terms)
    most, factors = (ROW_TERMS, ROW_FACTORS) if row else (MOST_TERMS, MOST_FACTORS)
    return any(t.scaled for t in terms) and len(terms) <= most and counted <= factors


@changing
class _Gathered:
    """Products that differ by their first number alone, or by an arm that is half or a quarter of the first one's."""

    term: Term
    first: list[sp.Expr]
    others: list[sp.Expr]
    texts: tuple[tuple[str, int], ...]
    """The numbers behind the first and before the arm, as they are printed."""

    def part(self, term: Term, texts: tuple[tuple[str, int], ...]) -> int:
        """Of how many such parts the arm of its products consists, where a product is one of them; 0: it is none."""
        same = (term.sign, term.rest, term.scaled, texts) == (
            self.term.sign,
            self.term.rest,
            self.term.scaled,
            self.texts,
        )
        whole, own = (t.numbers[-1][0] for t in (self.term, term))
        return next((n for n in PARTS if same and abs(n * own - whole) <= SMALL * whole), 0)

    def product(self) -> sp.Expr:
        head = [sp.Add(*self.first, evaluate=False)] if len(self.first) > 1 else self.first
        sign = [sp.Integer(-1)] if self.term.sign < 0 else []
        factors = [*sign, *head, *self.others, *([] if self.term.rest == 1 else [self.term.rest])]
        return sp.Mul(*factors, evaluate=False) if len(factors) > 1 else factors[0]


def _written(terms: Sequence[Term], phrases: Phrases) -> Math:
    """A sum of products; in a long one they are gathered: (1.5 + 2 + 1.2/2) r ω²."""
    enough = _figures([t for t in terms if t.rest == 1], phrases.figures)
    texts: dict[sp.Symbol, str] = {}
    groups: list[_Gathered] = []
    for i, t in enumerate(terms):
        figures = enough if t.rest == 1 else _figures([t], phrases.figures)
        own = []
        for j, (number, power) in enumerate(t.numbers):
            symbol = sp.Symbol(f"{NUMBER}{i}{j}", real=True)
            texts[symbol] = significant(number, figures)
            own.append((symbol, power))
        between = tuple((texts[s], power) for s, power in own[1:-1])
        factors = [s**power for s, power in own]
        gathers = len(terms) > FEW_TERMS and len(own) > 1 and own[0][1] == own[-1][1] == 1
        found = next(((g, n) for g in groups if gathers and g.texts == between and (n := g.part(t, between))), None)
        if found is None:
            groups.append(_Gathered(t, factors[:1], factors[1:], between if gathers else ((str(i), 0),)))
        else:
            group, parts = found
            group.first.append(factors[0] / parts)
    shown = [g.product() for g in groups]
    return Math(sp.Add(*shown, evaluate=False) if len(shown) > 1 else (shown or [sp.S.Zero])[0], texts)


def _terms(
    expr: sp.Expr, unknowns: frozenset[sp.Symbol], phrases: Phrases, places: Mapping[sp.Symbol, int] | None = None
) -> list[Term] | None:
    """The terms of a sum, without those that are the rounding of the largest."""
    ledger = phrases.ledger
    kinds = {s: ledger.units[s].dimension for s in expr.free_symbols if s in ledger.units}
    active = {s for s, kind in kinds.items() if kind not in (PURE, LENGTH)}
    if not all(phrases.has_numbers(s) or s in unknowns for s in expr.free_symbols):
        return None
    found = Collected(unknowns | active, phrases).terms(expr)
    if found is None:
        return None
    found = in_order(found, unknowns, phrases.ledger, places)
    sizes = {m: abs(c) * _size(m, unknowns, phrases) for m, c in found.items()}
    largest = max(sizes.values(), default=Decimal(0))
    terms: list[Term] = []
    for monomial, coefficient in found.items():
        if sizes[monomial] <= SMALL * largest:
            continue
        known, rest = monomial.as_independent(*unknowns, as_Add=False)
        powers_of = sorted(known.as_powers_dict().items(), key=lambda item: factor_key(item[0]))
        numbers = [(phrases.value(b), int(e)) for b, e in powers_of if b != 1]
        plain = significant(abs(coefficient), phrases.figures) == "1"
        scaled = not plain and bool(numbers)
        if not plain or not (numbers or rest != 1):
            numbers.append((abs(coefficient), 1))
        terms.append(Term(-1 if coefficient < 0 else 1, tuple(numbers), rest, scaled, sizes[monomial]))
    return terms


def _size(monomial: sp.Expr, unknowns: frozenset[sp.Symbol], phrases: Phrases) -> Decimal:
    known, _ = monomial.as_independent(*unknowns, as_Add=False)
    return abs(phrases.value(known))


def _figures(terms: Sequence[Term], figures: int) -> int:
    """How many figures the numbers need, so that they give the sum that stands behind them."""
    counted = [n for t in terms for n, _ in t.numbers]
    return figures_of(counted, lambda values: _worked(terms, values), figures) if counted else figures


def _worked(terms: Sequence[Term], values: Sequence[Decimal]) -> Decimal:
    """The sum, with these numbers in their order."""
    left, total = list(values), Decimal(0)
    for t in terms:
        product = Decimal(t.sign)
        for _, power in t.numbers:
            product *= left.pop(0) ** power
        total += product
    return total
