"""What has no moment about a point for the numbers of the file alone: m a of a rod of length l, whose line passes at
the height R - l/4 above the point, with R = 0.3 m and l = 1.2 m.

The equation in letters leaves it out, so that a page has to say why.
"""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.values.exact import Valuation
from planar_cli.equation.values.ledger import Ledger

Part = tuple[sp.Expr, sp.Expr]
"""A force, or m a, and its arm."""
_BESIDE = Decimal("0.01")
"""So far from its number, in parts of it, is a letter moved to see what holds whatever the file gives."""
_NONE = Decimal("1e-20")


def without_arm(parts: Iterable[Part], value: Valuation, ledger: Ledger) -> tuple[Part, ...]:
    """Those of several forces and arms whose arm is a formula of given letters that is zero for their numbers alone."""
    return tuple(p for p in parts if p[0] != 0 and _by_numbers(sp.sympify(p[1]), value, ledger))


def _by_numbers(arm: sp.Expr, value: Valuation, ledger: Ledger) -> bool:
    if not arm.free_symbols or value.known(arm) is None or not value.is_zero(arm):
        return False
    opened = _opened(arm, ledger)
    letters = sorted(opened.free_symbols, key=str)
    if not letters or any(s not in ledger.values for s in letters):
        return False
    moved = {s: value(s) * (1 + _BESIDE / (k + 2)) for k, s in enumerate(letters)}
    beside = Valuation(moved).known(opened)
    return beside is not None and abs(beside) > _NONE


def _opened(expr: sp.Expr, ledger: Ledger) -> sp.Expr:
    """In the letters that the file gives by numbers."""
    while inside := {s: e for s in expr.free_symbols if (e := ledger.behind(s)) != s and not e.is_number}:
        expr = expr.xreplace(inside)
    return expr
