"""The distance of a constructed point from where it is measured is what the file gives: c, and not √(y_B² + (d - x_B)²)
by the coordinates that were found with it.
"""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger
from planar_cli.solve.instant.recognised import recognised
from planar_cli.units import LENGTH


def with_given_distances(expr: sp.Expr, ledger: Ledger, value: Valuation) -> sp.Expr:
    """An expression in which c² stands for such a sum of two squares."""
    drawn = {s for s in expr.free_symbols if s in ledger.definitions and ledger.units[s].dimension == LENGTH}
    if not drawn:
        return expr
    sums = [e for e in expr.atoms(sp.Add) if _is_of_squares(e) and e.free_symbols & drawn]
    found = {e: recognised(sp.sqrt(e), ledger, value) for e in sums}
    squares = {e: x**2 for e, x in found.items() if x is not None and x.as_coeff_Mul()[1].is_Symbol}
    return expr.xreplace(squares) if squares else expr


def _is_of_squares(expr: sp.Expr) -> bool:
    return len(expr.args) == 2 and all(a.is_Pow and a.exp == 2 for a in expr.args)
