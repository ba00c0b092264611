"""What a motion tells once it is known: equilibrium states beside it, oscillations, truths about states, spans."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from planar_cli.equation.exact import Valuation
from planar_cli.problem.expression import Quantity
from planar_cli.solve.course.chain import Branch
from planar_cli.solve.course.course import Course
from planar_cli.solve.course.oscillation import check_oscillations, oscillation_at, stability

if TYPE_CHECKING:
    from planar_cli.solve.course.unfold import Unfolded

TRUTHS = ("reached", "stable")


def completed(found: Unfolded) -> Unfolded:
    """The branch with the equilibrium states in it, and whatever is asked about states."""
    course, branch = found.course, found.branch
    still = course.still.branch if course.still is not None else Branch({}, {}, (), ())
    if still is not branch:
        branch = Branch(
            {**still.values, **branch.values},
            {**still.formulas, **branch.formulas},
            (*still.steps, *branch.steps),
            branch.left,
        )
    value = found.value.extended(still.values)
    check_oscillations(course, value)
    return replace(found, branch=branch, value=value)


def is_true(course: Course, q: Quantity, value: Valuation) -> bool:
    """reached(s): is the state part of the motion? stable(s): does a small deviation stay small?"""
    if q.word == "reached":
        return q.things[0] in course.stops
    return stability(oscillation_at(course, q), value).stable
