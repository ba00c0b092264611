"""What is refused where a number must stand, the same for whoever reads a formula."""

from __future__ import annotations

from planar_cli.errors import FileProblem, Mark, refuse
from planar_cli.problem.language.expression import Quantity


def quantity_misplaced(quantity: Quantity) -> FileProblem:
    """Where only numbers and names may stand."""
    text = f"{quantity.word}(…) can not stand here"
    return refuse(quantity.mark, "PL501", text, "write numbers and names of `given` here")


def mode_misplaced(mark: Mark, what: str = "a mode") -> FileProblem:
    """A mode where a number belongs."""
    return refuse(mark, "PL502", f"{what} is no number", "compare it: `mode(C) = stick`")


def state_misplaced(mark: Mark) -> FileProblem:
    """`@ state` in a relation that is at its own instant."""
    return refuse(mark, "PL503", "`@` can not stand here", "leave it out: the relation is at its own instant")
