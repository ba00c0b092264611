"""sin² + cos² = 1 in differences: -m g l sin² β for m g l (cos² β - 1)."""

from __future__ import annotations

from typing import Any

import sympy as sp

OTHER = {sp.sin: sp.cos, sp.cos: sp.sin}


def of_one(expr: sp.Expr) -> sp.Expr:
    """The expression with every a - a cos² x in it as a sin² x, and every a - a sin² x as a cos² x."""
    if not any(p.is_Add and _difference(p) is not None for p in sp.preorder_traversal(expr)):
        return expr
    return expr.replace(lambda p: p.is_Add and _difference(p) is not None, _difference)


def _difference(total: Any) -> sp.Expr | None:
    if len(total.args) != 2:
        return None
    for one, other in (total.args, total.args[::-1]):
        ratio = -other / one
        squared = ratio.is_Pow and ratio.exp == 2 and isinstance(ratio.base, sp.sin | sp.cos)
        if squared and ratio.base.free_symbols:
            return one * OTHER[ratio.base.func](ratio.base.args[0]) ** 2
    return None
