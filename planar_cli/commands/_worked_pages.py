"""Worked solutions as a homework has them."""

from __future__ import annotations

from planar_cli.registry import members
from planar_cli.report.narrate import narrate
from planar_cli.solve.solved_problem import Solution


def page_of(solution: Solution) -> str:
    """A solution as Markdown."""
    page: str = members("formats")["markdown"]().render(narrate(solution))
    return page
