"""Equations in letters in which a number of the file stands, with its unit: m g (b - 0.45 m), P (3 ft), -5 N·m.

Lengths, forces and moments that no letter names are told so, as a reader would write them into an equation that is
otherwise in letters.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Line, Math, Value
from planar_cli.report.notation.clean import Mixed, common_dimension, dimension_of, is_clean
from planar_cli.report.notation.numbers import quantity
from planar_cli.report.notation.ordering import BEHIND, NUMBER
from planar_cli.report.words.words import Phrases
from planar_cli.solve.instant.written import Written
from planar_cli.units import ACCELERATION, ENERGY, FORCE, LENGTH, PURE, VELOCITY, Dimension

HELD = (LENGTH, FORCE, ENERGY)
"""What a number of the file may be that stands in an equation by itself: an arm, a force, a moment."""
MOST = 4
"""With more such numbers an equation is easier to read in numbers alone."""


def with_units(expr: sp.Expr, dimension: Dimension, phrases: Phrases) -> Math | None:
    """A formula of this dimension with the units that its numbers hold. None: a number holds another unit than that of
    a length, a force or a moment, as a moment of inertia of letters and numbers does, or there are too many of them.
    """
    spelled = _Spelled(phrases)
    try:
        found = spelled.tree(led(expr, phrases.ledger), dimension)
    except Mixed:
        return None
    return Math(found, spelled.texts) if len(spelled.texts) <= MOST else None


def in_units_held(own: sp.Expr, formula: sp.Expr, phrases: Phrases) -> Math:
    """A formula of a letter, or of its square, with the units of the numbers that stand in it by themselves."""
    if not formula.is_number and not is_clean(phrases.ledger, own, formula):
        dimension = common_dimension(phrases.ledger, own)
        found = None if dimension is None else with_units(phrases.neat(formula), dimension, phrases)
        if found is not None:
            return found
    return phrases.math(formula)


def led(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """A formula whose sums begin with a letter alone where a number among their terms holds a unit: 20 (b - 0.45), not
    20 b - 9.
    """
    if expr.is_Add:
        return sp.Add(*(led(e, ledger) for e in expr.args))
    factors = []
    for factor in sp.Mul.make_args(expr):
        base, power = factor.as_base_exp()
        if not base.is_Add or is_clean(ledger, base):
            factors.append(factor)
            continue
        own = led(base, ledger)
        scale = abs(_first(own).as_coeff_Mul()[0])
        factors += [scale**power, sp.Add(*(t / scale for t in sp.Add.make_args(own))) ** power]
    return sp.Mul(*factors)


def _first(total: sp.Expr) -> sp.Expr:
    """A term with letters of a sum, one of letters alone where there is one."""
    lettered = [t for t in sp.Add.make_args(total) if t.free_symbols]
    return min(lettered, key=lambda t: (t.has(sp.Add), str(t)))


class _Spelled:
    """Puts a symbol with a text for every number that holds a unit. Raises Mixed where it cannot be told."""

    def __init__(self, phrases: Phrases) -> None:
        self.phrases, self.ledger = phrases, phrases.ledger
        self.texts: dict[sp.Symbol, str] = {}

    def tree(self, expr: sp.Expr, dimension: Dimension) -> sp.Expr:
        if expr == 0 or (is_clean(self.ledger, expr, dimension=dimension) and expr.free_symbols):
            return expr
        if expr.is_Add:
            return sp.Add(*(self.tree(e, dimension) for e in expr.args))
        if expr.is_Pow and expr.exp == -1:
            return 1 / self.tree(expr.base, PURE / dimension)
        if not (expr.is_Mul or expr.is_number or expr.is_Symbol):
            raise Mixed(expr)
        return self._product(expr, dimension)

    def _product(self, expr: sp.Expr, dimension: Dimension) -> sp.Expr:
        number, *rest = sp.Mul.make_args(expr) if not expr.is_number else (expr,)
        if not number.is_number:
            number, rest = sp.S.One, [number, *rest]
        if any(f.is_number for f in rest):
            raise Mixed(expr)
        factors, missing = [], dimension
        for factor in rest:
            own = self._leading(factor)
            missing = missing / own
            factors.append(self.tree(factor, own))
        if missing == PURE:
            if not is_clean(self.ledger, number):
                raise Mixed(expr)
            return sp.Mul(number, *factors)
        above = [f for f in factors if not f.as_coeff_Mul()[1].as_base_exp()[1].could_extract_minus_sign()]
        return sp.Mul(self._held(number, missing, bool(above), bool(factors) and not above), *factors)

    def _leading(self, expr: sp.Expr) -> Dimension:
        """What the letters of a factor make it; of a sum one of its terms that has letters."""
        base, power = expr.as_base_exp()
        if power not in (1, -1) or not (base.is_Add or base.is_Mul):
            return dimension_of(expr, self.ledger)
        if base.is_Add:
            found = self._leading(_first(base))
        else:
            found = PURE
            for factor in base.args:
                found = found * self._leading(factor)
        return found if power == 1 else PURE / found

    def _held(self, number: sp.Expr, dimension: Dimension, beside: bool, over: bool) -> sp.Expr:
        """A number with its unit; behind the letters that it multiplies, where it is printed in brackets. `over`: it
        stands alone over what divides it.
        """
        if dimension not in HELD:
            raise Mixed(number)
        value = self.phrases.value(number)
        found: Value = self.phrases.of_dimension(abs(value), dimension)
        text = quantity(found.number, found.unit, found.figures)
        own = sp.Symbol(f"{BEHIND if beside else NUMBER}{len(self.texts)}", positive=True)
        self.texts[own] = f"({text})" if over else text
        return -own if value < 0 else own


def as_stated(w: Written, phrases: Phrases) -> tuple[tuple[Math, Value], Line] | None:
    """-2 r_g ω = 1.2 m/s, of a velocity or an acceleration that the file states as a number, which is in letters a
    product of one unknown; None: it is another relation.
    """
    if w.source != "given" or w.times or not w.right.is_number or w.right == 0 or w.left.is_Add or w.left.is_Symbol:
        return None
    dimension = common_dimension(phrases.ledger, w.left)
    if dimension not in (VELOCITY, ACCELERATION) or not is_clean(phrases.ledger, w.left):
        return None
    return (phrases.math(w.left), phrases.of_dimension(phrases.certain(w.right), dimension)), ()
