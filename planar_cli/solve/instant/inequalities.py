"""Inequalities that a file states of an instant: they reject modes and roots that make them false."""

from __future__ import annotations

from collections.abc import Iterable
from decimal import Decimal

import sympy as sp

from planar_cli.equation.kinematics.quantities import Quantities
from planar_cli.equation.values.exact import Valuation
from planar_cli.problem.language.expression import Relation
from planar_cli.records import record


@record
class Broken:
    """An inequality that does not hold, with the values of its sides in SI units."""

    relation: Relation
    left: Decimal
    right: Decimal

    @property
    def words(self) -> str:
        return f"{self.relation.text} does not hold"


def broken(relations: Iterable[Relation], quantities: Quantities, value: Valuation) -> Broken | None:
    """The first of the relations that does not hold. `value`: numbers of everything."""
    for relation in relations:
        left, right = (sp.sympify(quantities.evaluator.value(s)) for s in (relation.left, relation.right))
        if not holds(relation.operator, left - right, value):
            return Broken(relation, value(left), value(right))
    return None


def holds(operator: str, difference: sp.Expr, value: Valuation) -> bool:
    """Does `difference` stand to zero as the sign says? A zero is decided exactly."""
    if difference == 0 or value.is_zero(difference):
        return operator in ("<=", ">=", "=")
    number = value(difference)
    return number < 0 if operator in ("<", "<=") else number > 0 if operator in (">", ">=") else False
