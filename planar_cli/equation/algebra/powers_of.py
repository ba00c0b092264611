"""A polynomial by the powers of one of its letters, as SymPy's `Poly` has them, at a part of its price: `Poly` adds the
terms of a coefficient one by one, each time as a new sum.
"""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from planar_cli.equation.algebra.expansion import expanded

KEPT = 2_000
"""So many are remembered: what lies on several branches of a motion is solved on each."""


@lru_cache(maxsize=KEPT)
def powers_of(expr: sp.Expr, x: sp.Symbol) -> tuple[tuple[int, sp.Expr], ...]:
    """Each power of `x` with what stands before it, multiplied out, the highest first."""
    by: dict[tuple[int], list[sp.Expr]] = {}
    for term in sp.Add.make_args(expanded(expr)):
        before, power = term.as_independent(x, as_Add=False)
        by.setdefault((int(power.as_base_exp()[1]) if power != 1 else 0,), []).append(before)
    poly = sp.Poly.from_dict({power: sp.Add(*terms) for power, terms in by.items()}, x)
    return tuple((m[0], c) for m, c in poly.terms())
