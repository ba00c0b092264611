"""What the mass centre of a body of parts is called: another name than that of any point of the file."""

from __future__ import annotations

from planar_cli.equation.values.ledger import Ledger
from planar_cli.problem.scene.scene import Body, Problem


def new_centre(body: Body, problem: Problem, ledger: Ledger, name: str) -> str:
    """`name`, which is G of the only heavy body; G_half where the file has a point G already."""
    taken = any(point.name == name for point in problem.points)
    return str(ledger.fresh(f"G_{body.name}" if taken else name, "m").name)
