"""Exports by their names."""

from __future__ import annotations

from typing import Any

from planar_cli.errors import PlanarError
from planar_cli.near import nearest
from planar_cli.problem.nodes.show import visible

SHELF = "homework.exports"


def export_of(name: str, takes: str) -> Any:
    """An export that takes papers, or results. PlanarError: there is none of that name."""
    from planar_cli.registry import members

    fit = {kind: member for kind, member in members(SHELF).items() if getattr(member, "takes", "") == takes}
    if name in fit:
        return fit[name]()
    near = nearest(name, fit, 0.5)
    hint = f"did you mean '{near}'?" if near else f"there are {', '.join(fit)}"
    raise PlanarError(f"there is no export '{visible(name)}' of {takes}; {hint}")
