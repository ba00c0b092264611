"""Formulas for the way in which something goes: |v| and the sign of v written out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from decimal import Decimal

import sympy as sp

from planar_cli.equation.algebra.plain import simplified


def one_way(expr: sp.Expr, ways: Mapping[sp.Symbol, int]) -> sp.Expr:
    """A formula in which signs and sizes of speeds are written for the way in which these go."""
    if not ways:
        return expr
    inside: dict[sp.Expr, sp.Expr] = {}
    for atom in expr.atoms(sp.sign, sp.Abs):
        for u, way in ways.items():
            ratio = simplified(atom.args[0] / u)
            if u not in ratio.free_symbols:
                sign = way * sp.sign(ratio)
                inside[atom] = sign if isinstance(atom, sp.sign) else sign * atom.args[0]
    found = simplified(expr.xreplace(inside)) if inside else expr
    sign, rest = found.as_coeff_Mul()
    # A sum of forces keeps its terms: -m g - c v², not -(m g + c v²).
    return sp.Add(*(-a for a in rest.args)) if inside and sign == -1 and rest.is_Add else found


def sized(expr: sp.Expr, known: Callable[[sp.Expr], Decimal | None]) -> sp.Expr:
    """A formula in which |v| = v of what is known to be positive, and |a - b| = b - a where that is positive."""
    inside: dict[sp.Expr, sp.Expr] = {}
    for size in expr.atoms(sp.Abs):
        (own,), value = size.args, known(size.args[0]) or 0
        if value > 0 or (value < 0 and own.is_Add):
            inside[size] = own if value > 0 else sp.Add(*(-a for a in own.args))
    return expr.xreplace(inside)
