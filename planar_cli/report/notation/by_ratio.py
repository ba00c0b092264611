"""A formula in the data by a ratio that was found above: h_1²/h_0 as e² h_1, so that what the ratio does is seen."""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from planar_cli.equation.algebra.plain import simplified

POWERS = (1, 2, 4)
"""A second rise is e² times the first, a third e⁴ times."""

Ratio = tuple[sp.Symbol, sp.Expr]
"""The letter of a number without unit, and its formula in the data."""


def by_ratio(closed: sp.Expr, ratios: Iterable[Ratio]) -> sp.Expr | None:
    """The formula as a power of such a ratio times one letter of the data; None: it is none, or has no more letters."""
    for letter, formula in ratios:
        if formula.is_Symbol or not formula.free_symbols <= closed.free_symbols:
            continue
        for power in POWERS:
            rest = simplified(closed / formula**power)
            if rest.is_Symbol and rest in closed.free_symbols:
                return letter**power * rest
    return None
