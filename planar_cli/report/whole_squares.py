"""(v²/R)² for v⁴/R² in a sum: the square of a normal acceleration beside that of a tangential one."""

from __future__ import annotations

from typing import Any

import sympy as sp

FOURTH, BELOW = 4, -2


def whole_square(term: Any) -> Any:
    """The term as such a square, unevaluated; as it is where it is no quotient of these two powers of letters."""
    if not term.is_Mul or len(term.args) != 2:
        return term
    powers = {f.exp: f.base for f in term.args if f.is_Pow and f.base.is_Symbol}
    if powers.keys() != {FOURTH, BELOW}:
        return term
    quotient = sp.Mul(powers[FOURTH] ** 2, 1 / powers[BELOW], evaluate=False)
    return sp.Pow(quotient, 2, evaluate=False)
