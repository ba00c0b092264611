"""A result as its own equation gives it at sight, where the formula over one denominator has numbers that nobody would
write: (12 F/13 - 4/5 k s)/m for 4 (15 F - 13 k s)/(65 m).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import sympy as sp

from planar_cli.solve.instant.algebra import Line as SolvedLine
from planar_cli.solve.instant.written import Written


def at_sight(x: SolvedLine, written: Sequence[Written], readable: Callable[[sp.Expr], bool]) -> SolvedLine:
    """The line with the formula that its one equation gives, if only that is readable."""
    own = [w for w in written if w.number in x.equations]
    if len(own) != 1 or readable(x.formula):
        return x
    residual = own[0].residual
    factor = residual.diff(x.symbol)
    if factor == 0 or factor.is_Add or x.symbol in factor.free_symbols:
        return x
    rest = sp.Add(*(t for t in sp.Add.make_args(residual) if x.symbol not in t.free_symbols))
    if (rest + factor * x.symbol).free_symbols != residual.free_symbols:
        return x
    sense = -1 if factor.could_extract_minus_sign() else 1
    above = sp.Add(*(-sense * t for t in sp.Add.make_args(rest)))
    formula = sp.Mul(above, 1 / (sense * factor), evaluate=False) if above.is_Add else above / (sense * factor)
    known = x.formula.free_symbols
    if not formula.free_symbols <= known or not readable(formula):
        return x
    return replace(x, formula=formula)
