"""Differences of what is alike at states, where a longer sum has them multiplied out: e m_A (v_A,1 - v_B,1), with the
speed at which two bodies meet, for e m_A v_A,1 - e m_A v_B,1.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from typing import Any

import sympy as sp

from planar_cli.equation.values.ledger import Kind, Ledger

MOST = 8
"""Of more terms nobody looks for pairs."""


def with_differences(expr: sp.Expr, ledger: Ledger, sign: Callable[[sp.Expr], int]) -> sp.Expr:
    """The same value. `sign`: of a difference, where it is known; it is told as the positive one."""
    if not any(p.is_Add and 2 < len(p.args) <= MOST for p in sp.preorder_traversal(expr)):
        return expr
    if expr.is_Add:
        return _paired(expr, ledger, sign)
    if not (expr.is_Mul or expr.is_Pow):
        return expr
    parts = [with_differences(a, ledger, sign) for a in expr.args]
    # A number before a sum would go into its terms.
    return expr if all(a is b for a, b in zip(parts, expr.args, strict=True)) else expr.func(*parts)


def _paired(total: sp.Expr, ledger: Ledger, sign: Callable[[sp.Expr], int]) -> sp.Expr:
    """A sum with its only pair of such terms as one; it stays as it is where there are several, or none."""
    if not 2 < len(total.args) <= MOST:
        return total
    pairs = [p for terms in combinations(total.args, 2) if (p := _pair(*terms, ledger)) is not None]
    if len(pairs) != 1:
        return total
    ((factor, x, y, terms),) = pairs
    told = -factor * (y - x) if sign(x - y) < 0 else factor * (x - y)
    return sp.Add(*(t for t in total.args if t not in terms), told)


def _pair(one: sp.Expr, other: sp.Expr, ledger: Ledger) -> tuple[sp.Expr, sp.Symbol, sp.Symbol, tuple[Any, ...]] | None:
    """c, x and y of c x - c y, where x and y are of one kind and of one state, and c is more than a number."""
    states = [[s for s in t.free_symbols if _state(s, ledger) is not None] for t in (one, other)]
    if [len(s) for s in states] != [1, 1]:
        return None
    (x,), (y,) = states
    factor = one / x
    alike = x != y and _state(x, ledger) == _state(y, ledger) and ledger.units.get(x) == ledger.units.get(y)
    told = alike and factor.free_symbols and x not in factor.free_symbols and other == -factor * y
    return (factor, x, y, (one, other)) if told else None


def _state(symbol: sp.Symbol, ledger: Ledger) -> str | None:
    role = ledger.roles.get(symbol)
    return role.at if role is not None and role.kind is Kind.STATE else None
