"""Angles in formulas with numbers: in degrees within a sine where the page has them so, and cos(0.6667 rad) else."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp
from sympy.functions.elementary.trigonometric import InverseTrigonometricFunction, TrigonometricFunction

from planar_cli.equation.values.ledger import Ledger


def in_radians(expr: sp.Expr, apart: Mapping[sp.Symbol, sp.Symbol]) -> sp.Expr:
    """Angles outside trigonometric functions by the symbols that are told in radians."""
    if isinstance(expr, TrigonometricFunction | sp.Integral) or not expr.free_symbols & set(apart):
        return expr
    if expr.is_Symbol:
        return apart[expr]
    return expr.func(*(in_radians(a, apart) for a in expr.args))


def turned_angles(expr: sp.Expr, ledger: Ledger) -> tuple[sp.Expr, dict[sp.Symbol, sp.Symbol]]:
    """An angle in radians of which a sine or cosine is taken, by a symbol of its own."""
    functions = [f for f in expr.atoms(TrigonometricFunction) if f.args[0].is_Symbol]
    inside = {f.args[0] for f in functions} & expr.free_symbols  # Over which is integrated stays what it is.
    angles = {s for s in inside if s in ledger.units and ledger.units[s].text == "rad"}
    own = {s: sp.Symbol(f"{s.name} turned", **s.assumptions0) for s in angles}
    found = {f: f.func(own[f.args[0]]) for f in functions if f.args[0] in own}
    return (expr.xreplace(found) if found else expr), own


def right_angles(expr: sp.Expr, told: Mapping[sp.Symbol, str]) -> tuple[sp.Expr, dict[sp.Symbol, str]]:
    """Multiples of π in a sum of angles by symbols with their texts: 203.6° - 90°. None, where `told` has a number in
    other units than degrees: both do not stand in one sum.
    """
    texts: dict[sp.Symbol, str] = {}
    terms = []
    beside = expr.xreplace(dict.fromkeys(expr.atoms(InverseTrigonometricFunction), sp.S.Zero)).free_symbols
    if not all(told.get(s, "").endswith("°") for s in beside):
        return expr, texts
    for term in sp.Add.make_args(sp.expand_mul(expr)):
        degrees = abs(term) * 180 / sp.pi
        own = sp.Symbol(f"{degrees} degrees", positive=True)
        if term.is_number and degrees.is_Integer:
            texts[own] = f"{degrees}°"
        terms.append(term if own not in texts else own if term.is_positive else -own)
    return (sp.Add(*terms), texts) if texts else (expr, texts)
