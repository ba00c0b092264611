"""Worked solutions as a homework has them."""

from __future__ import annotations

from planar_cli.registry import members
from planar_cli.report.narrate import narrate
from planar_cli.solve.solved_problem import Solution

WIDTH = 100


def page_of(solution: Solution) -> tuple[str, str]:
    """A solution as Markdown, and as plain text with aligned equations."""
    document = narrate(solution)
    formats = members("formats")
    return formats["markdown"]().render(document), formats["terminal"](WIDTH).render(document)
