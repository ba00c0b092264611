"""Which component of a vector is asked, and that beside its line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from planar_cli.problem.expression import Quantity
from planar_cli.report.blocks import Block, Equation, line


def axis_of(what: Any) -> str:
    """x or y, where one component is asked; else nothing."""
    kind = what.parts[0].kind if isinstance(what, Quantity) and len(what.parts) == 1 else ""
    return kind if kind in ("x", "y") else ""


def noted(blocks: Iterable[Block], axis: str) -> Iterator[Block]:
    """Lines of one component, the axis beside them."""
    for block in blocks:
        yield replace(block, note=line(f"along {axis}")) if axis and isinstance(block, Equation) else block
