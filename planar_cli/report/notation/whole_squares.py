"""(v²/R)² for v⁴/R² in a sum: the square of a normal acceleration beside that of a tangential one. And (u + v)² for
(-u - v)².
"""

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


def without_sign(base: Any) -> Any:
    """Of an even power, the base without the sign that all its terms have."""
    if not base.is_Add or not all(term.could_extract_minus_sign() for term in base.args):
        return base
    return sp.Add(*(-term for term in base.args), evaluate=False)
