"""What is largest or smallest in a state that gives its value: it is so in time, and its rate vanishes there.

`B: [r(P).mag = r_B, r(P).mag is largest]` with an unknown start: the value is no matter of choice, so that the unknown
is not what makes it largest.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from fractions import Fraction

from planar_cli.problem.expression import Extreme, Number, Quantity, Relation, Side, Statement
from planar_cli.problem.scene import Problem, State


def with_rates(problem: Problem) -> Problem:
    """The problem and its cases with `dot(X) = 0` and the sign of the next rate in the place of such an extreme."""
    cases = tuple(replace(case, problem=with_rates(case.problem)) for case in problem.cases)
    states = tuple(replace(s, relations=tuple(_statements(s))) for s in problem.states)
    return (
        problem if (states, cases) == (problem.states, problem.cases) else replace(problem, states=states, cases=cases)
    )


def _statements(state: State) -> Iterator[Statement]:
    given = [s for r in state.relations if isinstance(r, Relation) and r.operator == "=" for s in (r.left, r.right)]
    for statement in state.relations:
        if isinstance(statement, Extreme) and any(_same(statement.side, side) for side in given):
            mark, text = statement.mark, statement.text
            nothing = Number(Fraction(0), None, 1, mark)
            rate = _rate(statement.side, statement)
            yield Relation(rate, "=", nothing, text, mark)
            yield Relation(_rate(rate, statement), "<" if statement.sense > 0 else ">", nothing, text, mark)
        else:
            yield statement


def _rate(side: Side, extreme: Extreme) -> Quantity:
    return Quantity("dot", (), side, (), None, extreme.mark)


def _same(one: object, other: object) -> bool:
    """Are two sides written alike, wherever they stand?"""
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    if type(one) is not type(other) or not is_dataclass(one):
        return one == other
    return all(_same(getattr(one, f.name), getattr(other, f.name)) for f in fields(one) if f.name != "mark")
