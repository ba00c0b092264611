"""Answers in letters as a key tells them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import sympy as sp

    from planar_cli.homework.variants.told_formula import ToldFormula
    from planar_cli.solve.solved_problem import Solution


def told_formulas(solution: Solution, numbers: Mapping[str, sp.Expr]) -> dict[str, ToldFormula]:
    """By the names of the finds, with `numbers` put in for some letters. Workers find it by its name; what tells a
    formula is loaded there.
    """
    from planar_cli.report.page.key import formulas_told

    return formulas_told(solution, numbers)
