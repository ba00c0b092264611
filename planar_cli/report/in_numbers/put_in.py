"""Formulas with a number for everything that is known, whatever functions their unknowns stand in.

Where an equation is a sum of products of its unknowns, `in_numbers` collects it; here the structure is kept as well:
11.77 (0.065 - 0.15 sin θ) - 200 s² = 0. Angles beside unknown ones are in degrees, all else in the units of the page.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from decimal import Decimal
from math import prod
from typing import Any

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from planar_cli.equation.algebra.common_factors import factor_terms
from planar_cli.equation.algebra.counting import operations
from planar_cli.equation.algebra.expansion import expanded
from planar_cli.equation.algebra.plain import longer
from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import NoValue
from planar_cli.records import record
from planar_cli.report.document.blocks import Line, Math, line
from planar_cli.report.in_numbers.in_numbers import SMALL
from planar_cli.report.in_numbers.sums import sum_of
from planar_cli.report.notation.clean import Mixed, dimension_of, is_clean
from planar_cli.report.notation.enough_figures import DEGREE, figures_of
from planar_cli.report.notation.numbers import significant
from planar_cli.report.notation.ordering import NUMBER
from planar_cli.report.notation.page_units import coherent_unit
from planar_cli.report.words.words import Phrases
from planar_cli.units import ENERGY, PURE, Dimension, pretty_unit

PART = 16
"""A formula of more operations is not told with some of its letters."""
FEW, LONGEST = 12, 45
"""A formula of more operations is told with one number for all that is known; and with no numbers put in at all."""
FEW_PARTS = 4
"""Of so many parts an equation is told by them as they are."""
PLAIN = 2
"""Of no more terms in all a sum is told without its parts."""
OPENED = 150
"""A longer formula is not multiplied out to see whether it gets shorter so."""


@record
class PutIn:
    """Both sides of an equation with numbers, and their unit in print ("" where it is not known)."""

    left: Math
    right: Math
    unit: str
    length: int
    """How many operations they have."""
    total: Math | None = None
    """What the left side makes, where it is a sum of numbers."""

    @property
    def sides(self) -> tuple[Math, ...]:
        """-1.226 + 3.590 = 2.364 = 0.77 ω², so that the number from which a line goes on stands on the page."""
        return (self.left, self.right) if self.total is None else (self.left, self.total, self.right)

    @property
    def gives_value(self) -> bool:
        """Is it one letter and its number, which the line below says too?"""
        return bool(self.left.expr.is_Symbol and self.right.expr.free_symbols <= set(self.right.values or ()))

    @property
    def note(self) -> Line:
        """The unit of both sides, behind the equation."""
        return line(f"in {self.unit}") if self.unit else ()


def put_in(
    left: sp.Expr | Sequence[sp.Expr],
    right: sp.Expr,
    unknowns: Collection[sp.Symbol],
    phrases: Phrases,
    dimension: Dimension | None = None,
    after: Sequence[sp.Expr] = (),
) -> PutIn | None:
    """An equation with numbers for all but its unknowns; None: something known has no number, or no unit can be told.
    `left`: in parts that are told before and are numbers by now, each of which has its number. `dimension`: of its
    sides, where it is known; a number among them may hide a unit. `after`: parts of the right side that were told.
    """
    ending = _told_apart(after, right, unknowns, phrases)
    parts = [left] if isinstance(left, sp.Expr) else list(left)
    *parts, right = _without_rounding([*parts, right], unknowns, phrases)
    left = sp.Add(*parts)
    if left.free_symbols & set(unknowns) or not parts:
        parts = _positive_first(_alike(parts, unknowns), unknowns, phrases) or [left]
    elif phrases.has_numbers(left):
        parts = [e for e in parts if not phrases.value.is_zero(e)] or [sp.S.Zero]
    writer = Writer(unknowns, phrases)
    found = [writer.written(e) for e in parts]
    written = [writer.written(e) for e in ending or [right]]
    if any(e is None for e in written) or any(e is None for e in found):
        return None
    if len(found) > 1 and left.free_symbols & set(unknowns) and not _each_one_term(found):
        whole = writer.written(left)
        found = writer.one_number(found) if whole is None or len(sp.Add.make_args(whole)) > PLAIN else [whole]
    before = sp.Add(*found, evaluate=False) if len(found) > 1 else found[0]
    last = sp.Add(*written, evaluate=False) if len(written) > 1 else written[0]
    shown = (Math(before, writer.texts), Math(last, writer.texts))
    sums = len(parts) > 1 and not left.free_symbols & set(unknowns) and bool(right.free_symbols & set(unknowns))
    summed = writer.written(left) if sums else None
    total = None if summed is None or summed.is_Add else Math(summed, writer.texts)
    if total is not None:
        shown = (_added_up(parts, phrases), shown[1])
    return PutIn(*shown, _unit(phrases, dimension, left, right), operations(before) + operations(last), total)


def _told_apart(
    parts: Sequence[sp.Expr], whole: sp.Expr, unknowns: Collection[sp.Symbol], phrases: Phrases
) -> list[sp.Expr]:
    """Several numbers that make the right side; none where an unknown stands in it."""
    kept = [e for e in parts if e != 0]
    known = all(phrases.has_numbers(s) and s not in unknowns for e in (*kept, whole) for s in e.free_symbols)
    return kept if 1 < len(kept) <= FEW_PARTS and known else []


def _each_one_term(parts: Sequence[sp.Expr | None]) -> bool:
    """Is every part one number, or one with an unknown, so that a student finds each of them above?"""
    return len(parts) <= FEW_PARTS and not any(e is None or e.is_Add or e.has(sp.Add) for e in parts)


def _added_up(parts: Sequence[sp.Expr], phrases: Phrases) -> Math:
    """A sum of numbers, with so many figures that it gives what is printed behind it: 17167.5 - 3433.5 = 13734."""
    figures = figures_of([phrases.value(e) for e in parts], sum_of, phrases.figures)
    writer = Writer((), replace(phrases, figures=figures))
    return Math(sp.Add(*(writer.number(e) for e in parts), evaluate=False), writer.texts)


def _without_rounding(amounts: Sequence[sp.Expr], unknowns: Collection[sp.Symbol], phrases: Phrases) -> list[sp.Expr]:
    """Amounts of an equation without the terms that are the rounding of sixty digits: ẋ cos 90°."""
    if not all(phrases.has_numbers(s) for e in amounts for s in e.free_symbols - set(unknowns)):
        return list(amounts)
    terms = [[t.as_independent(*unknowns, as_Add=False) for t in sp.Add.make_args(e)] for e in amounts]
    try:
        sizes = [[abs(phrases.value(known)) for known, _ in own] for own in terms]
    except (NoValue, Unvalued):
        return list(amounts)
    least = SMALL * max((size for own in sizes for size in own), default=Decimal(0))
    found = []
    for e, own, around in zip(amounts, terms, sizes, strict=True):
        kept = [known * rest for (known, rest), size in zip(own, around, strict=True) if size > least]
        found.append(e if len(kept) == len(own) else sp.Add(*kept))
    return found


def _alike(parts: Sequence[sp.Expr], unknowns: Collection[sp.Symbol]) -> list[sp.Expr]:
    """Parts that are the same but for a known factor as one; none where they are many."""
    found: dict[sp.Expr, list[tuple[sp.Expr, sp.Expr]]] = {}
    for part in parts:
        known, rest = factor_terms(part).as_independent(*unknowns, as_Add=False)
        # Each number was told by itself, and is found again in the sum.
        found.setdefault(part if rest == 1 else rest, []).append((part, known))
    if len(parts) < 2 or len(found) > FEW_PARTS:
        return []
    own = [(rest, *group) for rest, group in found.items()]
    return [first[0] if not more else sp.Add(first[1], *(k for _, k in more)) * rest for rest, first, *more in own]


def _positive_first(parts: list[sp.Expr], unknowns: Collection[sp.Symbol], phrases: Phrases) -> list[sp.Expr]:
    """Parts as they were told, but no negative number leads: 0.225 F - 235.4 - 150."""
    if not parts or parts[0].free_symbols & set(unknowns) or phrases.value(parts[0]) >= 0:
        return parts
    lead = next((e for e in parts if phrases.has_numbers(e) and phrases.value(e) > 0), parts[0])
    return [lead, *(e for e in parts if e is not lead)]


def partly(expr: sp.Expr, letters: Collection[sp.Symbol], phrases: Phrases, constant: bool = False) -> Math | None:
    """A formula in which some letters stay and all else is a number, where that makes a short one; None: it does not.
    Of integrals what stands under them. `constant`: it may be a number alone.
    """
    writer = Writer(letters, phrases)
    written: dict[sp.Expr, sp.Expr] = {}
    for integral in sorted(expr.atoms(sp.Integral), key=sp.default_sort_key):
        inside = Writer({*letters, *integral.variables}, phrases, writer.texts).written(integral.function)
        if inside is None:
            return None
        written[integral] = sp.Integral(inside, *integral.limits)
    if written:
        return Math(expr.xreplace(written), writer.texts)
    found = writer.written(expr)
    short = found is not None and not longer(found, PART) and (constant or bool(found.free_symbols & set(letters)))
    return Math(found, writer.texts) if short else None


def in_known(
    expr: sp.Expr, letters: Collection[sp.Symbol], value: Any, phrases: Phrases, most: int = LONGEST
) -> list[Math]:
    """A formula whose numbers hide units, with a number for every letter; where that would not give its value in so few
    figures, `letters` stay. What is known beside them is one number, unless few names of the file stand in it. `most`:
    of more operations not every letter gets a number of its own.
    """
    inside = expr.free_symbols & set(letters)
    named = bool(expr.free_symbols - inside) and not longer(expr, FEW)
    whole = [] if longer(expr, most) else phrases.substituted(expr, value)
    if whole and named:
        return whole
    part = _together(expr, inside, phrases)
    if part is not None:
        return [part]
    found = None if whole else partly(expr, inside, phrases)
    return whole or ([] if found is None else [found])


def _together(expr: sp.Expr, letters: Collection[sp.Symbol], phrases: Phrases) -> Math | None:
    """A formula with one number for all that is known beside some letters, and the numbers of these."""
    writer = Writer(letters, phrases)
    found = writer.written(expr)
    if found is None or longer(found, PART) or not found.free_symbols & set(letters):
        return None
    return phrases.numbers(found, writer.sizes)


def _unit(phrases: Phrases, dimension: Dimension | None, *sides: sp.Expr) -> str:
    """The unit of a page in which the sides of an equation are."""
    ledger = phrases.ledger
    if dimension is None:
        sides = tuple(e for e in sides if e != 0)
        if not sides or not is_clean(ledger, *sides):
            return ""
        dimension = dimension_of(sides[0], ledger)
    text = coherent_unit(dimension, us=ledger.us).text
    return "" if dimension == PURE else pretty_unit("J" if dimension == ENERGY and not ledger.us else text)


class Writer:
    """Writes numbers into formulas. `texts`: of the symbols that stand for numbers in what it has written."""

    def __init__(
        self, unknowns: Collection[sp.Symbol], phrases: Phrases, texts: dict[sp.Symbol, str] | None = None
    ) -> None:
        self.unknowns, self.phrases = frozenset(unknowns), phrases
        self.texts: dict[sp.Symbol, str] = {} if texts is None else texts
        self.sizes: dict[sp.Symbol, Decimal] = {}

    def written(self, expr: sp.Expr) -> sp.Expr | None:
        """The formula with numbers for all that is known, in the shorter of two forms; None: that is not possible."""
        expr = sp.sympify(expr)
        if not all(self.phrases.has_numbers(s) for s in expr.free_symbols - self.unknowns):
            return None
        forms = [expr]
        if expr.free_symbols & self.unknowns and not longer(expr, OPENED):
            forms.append(expanded(expr))
        try:
            found = [self._tree(self.phrases.met(f)) for f in forms]
        except (Mixed, NoValue, Unvalued):
            return None
        return min(found, key=operations)

    def one_number(self, parts: Sequence[sp.Expr]) -> list[sp.Expr]:
        """Written parts of a sum with one number for all that are numbers among its terms, or come from products of a
        number and a difference: 6.195 - 2.354 sin θ for 2.354 (0.866 - sin θ) + 4.156.
        """
        terms = [t for part in parts for t in sp.Add.make_args(part)]
        opened = [t for term in terms for t in self._opened(term)]
        numbers = [t for t in opened if self._is_number(t)]
        if len(numbers) < 2:
            return terms
        terms = opened
        whole = sum((self._size(t) for t in numbers), Decimal(0))
        rest = [t for t in terms if t not in numbers]
        if abs(whole) <= SMALL * max(abs(self._size(t)) for t in numbers):
            return rest or [sp.S.Zero]
        return [self._text(significant(abs(whole), self.phrases.figures), abs(whole), whole < 0), *rest]

    def _opened(self, term: sp.Expr) -> list[sp.Expr]:
        """number (number ± f) multiplied out; any other term as it is."""
        known = [f for f in sp.Mul.make_args(term) if self._is_number(f)]
        others = [f for f in sp.Mul.make_args(term) if f not in known]
        inside = others[0].args if len(others) == 1 and others[0].is_Add else ()
        if len(inside) != 2 or [self._is_number(t) for t in inside].count(True) != 1:
            return [term]
        factor = prod(map(self._size, known), start=Decimal(1))
        found = []
        for part in sorted(inside, key=self._is_number, reverse=True):
            numbers = [f for f in sp.Mul.make_args(part) if self._is_number(f)]
            size = factor * prod(map(self._size, numbers), start=Decimal(1))
            shown = self._text(significant(abs(size), self.phrases.figures), abs(size), size < 0)
            found.append(sp.Mul(shown, *(f for f in sp.Mul.make_args(part) if f not in numbers)))
        return found

    def _is_number(self, term: sp.Expr) -> bool:
        return bool(term.is_Integer or term.as_coeff_Mul()[1] in self.sizes)

    def _size(self, term: sp.Expr) -> Decimal:
        factor, number = term.as_coeff_Mul()
        return Decimal(int(factor)) * self.sizes.get(number, Decimal(1))

    def _tree(self, expr: sp.Expr) -> sp.Expr:
        if not expr.free_symbols & self.unknowns:
            return self.number(expr)
        if expr.is_Symbol:
            return expr
        if expr.is_Add:
            return self._sum(expr)
        if expr.is_Mul:
            known, rest = expr.as_independent(*self.unknowns, as_Add=False)
            return self._product(known, rest)
        if expr.is_Pow and not expr.exp.free_symbols:
            return sp.Pow(self._tree(expr.base), expr.exp)
        if isinstance(expr, TrigonometricFunction):
            return expr.func(self._angle(expr.args[0]))
        if isinstance(expr, sp.Function) and not isinstance(expr, sp.Piecewise):
            return expr.func(*(self._tree(a) for a in expr.args), evaluate=False)
        raise Mixed(expr)

    def _sum(self, expr: sp.Expr) -> sp.Expr:
        """Like terms together, one number for all that is known."""
        terms: dict[sp.Expr, list[sp.Expr]] = {}
        for term in expr.args:
            known, rest = term.as_independent(*self.unknowns, as_Add=False)
            terms.setdefault(rest, []).append(known)
        sums = {rest: sp.Add(*known) for rest, known in terms.items()}
        sizes = {rest: abs(self.phrases.value(known)) for rest, known in sums.items()}
        largest = max(sizes.values(), default=Decimal(0))
        kept = [(known, rest) for rest, known in sums.items() if sizes[rest] > SMALL * largest]
        return _added(self._product(known, rest) if rest != 1 else self.number(known) for known, rest in kept)

    def _product(self, known: sp.Expr, rest: sp.Expr) -> sp.Expr:
        if rest == 1:
            return self.number(known)
        factors = [self._tree(f) for f in sp.Mul.make_args(rest)]
        number = self.number(known) if known not in (1, -1) else known
        return sp.Mul(number, *factors)

    def number(self, known: sp.Expr) -> sp.Expr:
        """A number behind a symbol that is printed as its text, its sign before it."""
        value = self.phrases.value(known)
        if known.is_Integer and abs(int(known)) < 10:
            return known
        size = abs(value)
        return self._text(significant(size, self.phrases.figures), size, value < 0)

    def _text(self, text: str, size: Decimal, negative: bool = False) -> sp.Expr:
        if text in ("0", "1"):
            return sp.Integer(-int(text) if negative else int(text))
        # Each has a symbol of its own: two numbers that round to the same text do not cancel.
        number = sp.Symbol(f"{NUMBER}{len(self.texts)}", positive=True)
        self.texts[number], self.sizes[number] = text, size
        return -number if negative else number

    def _angle(self, expr: sp.Expr) -> sp.Expr:
        """The argument of a trigonometric function; a known angle beside unknown ones in degrees."""
        known, rest = expr.as_independent(*self.unknowns, as_Add=True)
        if known == 0 or not expr.is_Add:
            factor, rest = expr.as_independent(*self.unknowns, as_Add=False)
            turns = factor / sp.pi
            # π t/4 stays as it is, no 0.7854 t.
            exact = turns.is_Rational and max(abs(turns.p), turns.q) <= FEW
            return factor * self._tree(rest) if exact else self._tree(expr)
        if (known / sp.pi).is_Rational:
            return sp.Add(self._tree(rest), known)
        degrees = self.phrases.value(known * 180 / sp.pi)
        shown = self._text(significant(abs(degrees), self.phrases.figures) + "°", abs(degrees) * DEGREE, degrees < 0)
        return sp.Add(self._tree(rest), shown)


def _added(terms: Iterable[sp.Expr]) -> sp.Expr:
    return sp.Add(*terms)
