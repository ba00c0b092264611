"""Inequalities of states that alone stand in the way of a motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from decimal import Decimal

from planar_cli.equation.values.exact import Unvalued
from planar_cli.errors import Diagnostic, NoSolution, NoValue, Undecided
from planar_cli.motion.scene.drives import of_forces
from planar_cli.problem.language.expression import Relation
from planar_cli.solve.between.equations.motion_equations import MotionEquations
from planar_cli.solve.diagnosis.words import in_unit, unit_of
from planar_cli.solve.regimes.equations import Equation
from planar_cli.solve.regimes.timeline import Demand

TINY = Decimal("1e-30")


def false_inequality(course: MotionEquations, equations: Sequence[Equation]) -> NoSolution | None:
    """The first inequality that is false where the equations hold; None: these have no root without them either."""
    try:
        branch = next(without_inequalities(course).chain().branches(equations), None)
    except (Undecided, NoValue, Unvalued):
        return None
    if branch is None:
        return None
    value = course.base().extended(branch.values)
    for state in course.states:
        for d in course.demands[state.name]:
            number = value.known(d.residual) if d.kind == "inequality" else None
            slack = Decimal(0) if number is None else TINY * value.size(d.residual)
            if number is not None and (number < -slack or (d.sign and number <= slack)):
                return _told(course, d, number)
    return None


def without_inequalities(course: MotionEquations) -> MotionEquations:
    """The same where any root may be taken."""
    bare = {name: tuple(d for d in demands if d.kind != "inequality") for name, demands in course.demands.items()}
    return replace(course, demands=bare)


def _told(course: MotionEquations, demand: Demand, number: Decimal) -> NoSolution:
    relations = [r for s in course.problem.states if s.name == demand.state for r in s.relations]
    relation = next((r for r in relations if isinstance(r, Relation) and r.mark == demand.mark), None)
    apart = ""
    # Forces are those of modes that were tried last, not of what happens.
    if relation is not None and not course.symbolic and not of_forces(relation):
        unit = unit_of(course.regimes[0].general.instant, relation.left, relation.right)
        off = f"differ by {in_unit(abs(number), unit, course.ledger.us)}" if number else "are equal"
        apart = f": the sides {off}"
    text = f"state {demand.state}: `{demand.text}` does not hold{apart}"
    return NoSolution([Diagnostic(demand.mark, "PL617", text, "leave it out, or change what its sides rest on")])
