"""What an asked formula is with the letters of its state put in: 2 π h/T² for 2 π h sin(2 π t_a/T)/T² at t_a = T/4."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import simplified
from planar_cli.equation.values.ledger import Kind
from planar_cli.solve.between.trace.trace import MotionTrace

LONGEST = 40
"""The letters of a longer formula are not put in."""


def closed_value(formula: sp.Expr, found: MotionTrace) -> sp.Expr | None:
    """The formula in letters of the file, where a sine or cosine in it becomes a number by that; None: it does not."""
    states = formula.free_symbols & set(found.general)
    if not formula.has(sp.sin, sp.cos) or not states or sp.count_ops(formula) > LONGEST:
        return None
    made = {s: found.route.formulas.get(s) for s in states}
    if any(f is None or f.is_number or f.free_symbols & set(found.general) for f in made.values()):
        return None
    own = simplified(formula.xreplace({s: f for s, f in made.items() if f is not None}))
    return None if own.has(sp.sin, sp.cos) or own.is_number else own


def untold(letter: sp.Symbol, found: MotionTrace) -> sp.Expr | None:
    """The formula of a letter of a state that no step of the way has found, as the file gives it at that time; None:
    it has a line, or is a time.
    """
    role = found.ledger.roles.get(letter)
    if role is None or role.kind is not Kind.STATE or any(letter in leg.unknowns for leg in found.route.steps):
        return None
    general = found.general.get(letter)
    of = found.ledger.roles.get(general) if general is not None else None
    return None if of is None or of.kind is Kind.TIME else found.route.formulas.get(letter)
