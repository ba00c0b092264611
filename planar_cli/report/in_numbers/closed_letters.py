"""Results of an instant in the letters of the file, where lines before have others: α = m g L/(4 I_A) = 12 g/(7 L)."""

from __future__ import annotations

import sympy as sp

from planar_cli.equation.algebra.plain import in_factors, longer
from planar_cli.solve.solution import InstantSolution

LONGEST, MOST = 8, 200
"""A formula of more operations is not told a second time; and one of more is not worked out."""
DEEPEST, LARGEST = 20, 100
"""So often letters are put in; larger numbers in fractions are no easy ones."""


def in_letters(expr: sp.Expr, instant: InstantSolution) -> sp.Expr | None:
    """A formula by the letters of the file alone, where it has others and gets short; else None."""
    ledger = instant.instant.scene.ledger
    formulas = dict(ledger.definitions)
    for stage in instant.stages:
        formulas |= {**stage.algebra.explicit, **stage.algebra.formulas}
    found = expr
    for _ in range(DEEPEST):
        inside = {s: formulas[s] for s in found.free_symbols if s in formulas}
        if not inside:
            break
        found = found.xreplace(inside)
        if longer(found, MOST):
            return None
    if found == expr or not found.free_symbols <= {*ledger.letters, *ledger.values}:
        return None
    found = in_factors(found)
    easy = all(max(abs(n.p), n.q) <= LARGEST for n in found.atoms(sp.Rational))
    return None if found == expr or found.is_Symbol or longer(found, LONGEST) or not easy else found
