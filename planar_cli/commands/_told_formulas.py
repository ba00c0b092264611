"""Answers in letters as a key tells them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from planar_cli.solve.solved_problem import Solution


def told_formulas(solution: Solution) -> dict[str, str]:
    """By the names of the finds. Workers find it by its name; what tells a formula is loaded there."""
    from planar_cli.report.key import formulas_told

    return formulas_told(solution)
