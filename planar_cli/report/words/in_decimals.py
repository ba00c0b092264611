"""A formula in letters whose number is a sum with π in it, by that number in decimals: π √((9 π - 16) R/(2 g)) is
7.783 √(R/g).
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.algebra.plain import longer, simplified
from planar_cli.equation.values.ledger import Ledger
from planar_cli.report.document.blocks import Line, Math, Text
from planar_cli.report.notation.clean import is_clean
from planar_cli.report.notation.numbers import significant
from planar_cli.solve.solution import Found

LONGEST, DIGITS = 40, 30
"""Operations of a formula; digits to which its number is worked out."""


def in_decimals(found: Found, neat: Callable[[Any], Any], ledger: Ledger, figures: int) -> Line:
    """The second form, after the first; empty where the number says enough by itself, letters make a sum, or numbers of
    the file in it have units.
    """
    (formula, *others) = found.expressions or (sp.S.Zero,)
    letters = sorted(formula.free_symbols, key=lambda s: s.name)
    if others or not letters or not formula.has(sp.pi) or longer(formula, LONGEST):
        return ()
    number = formula.xreplace(dict.fromkeys(letters, sp.S.One))
    sums = any(p.is_Add and p.has(sp.pi) for p in sp.preorder_traversal(number))
    if not sums or not number.is_real or not all(s.is_positive for s in letters):
        return ()
    powers = [simplified(s * sp.diff(formula, s) / formula) for s in letters]
    if not all(p.is_Rational for p in powers):
        return ()
    product = sp.Mul(*(s**p for s, p in zip(letters, powers, strict=True)))
    if product == 1 or not is_clean(ledger, product, dimension=found.unit.dimension):
        return ()
    value = Decimal(str(sp.N(number, DIGITS)))
    return (Text(f" = {significant(value, figures)} "), Math(neat(product)))
