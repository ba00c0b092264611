"""What is largest or smallest in a state that leaves no choice for it.

A state that gives its value, `B: [r(P).mag = r_B, r(P).mag is largest]` with an unknown start: it is so in time, and
its rate vanishes there. A constant in a first state that says only how the motion begins, `throw: [v(ball).mag = v_0,
v_0 is smallest]`: what chooses it are the states that are to be reached, so that it belongs to the last of them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from planar_cli.problem.language.expression import (
    AtRest,
    Extreme,
    Name,
    Number,
    Quantity,
    Relation,
    Side,
    Statement,
    Word,
)
from planar_cli.problem.language.walk import walk, written_alike
from planar_cli.problem.scene.scene import Problem, State

BEGINNING = frozenset(("x", "y", "r", "v", "theta", "omega"))
"""Quantities that tell where and how a motion begins."""


def with_rates(problem: Problem) -> Problem:
    """The problem and its cases with `dot(X) = 0` and the sign of the next rate in the place of such an extreme."""
    cases = tuple(replace(case, problem=with_rates(case.problem)) for case in problem.cases)
    states = tuple(replace(s, relations=tuple(_statements(s))) for s in _chosen_at_the_end(problem))
    return (
        problem if (states, cases) == (problem.states, problem.cases) else replace(problem, states=states, cases=cases)
    )


def _chosen_at_the_end(problem: Problem) -> tuple[State, ...]:
    """The states with what is largest or smallest of a constant in the last one, where the first only begins."""
    if not problem.states[1:]:
        return problem.states
    first, *others = problem.states
    sought = {s.name for s in problem.unknowns}
    moved = [
        r for r in first.relations if isinstance(r, Extreme) and isinstance(r.side, Name) and r.side.name in sought
    ]
    rest = tuple(r for r in first.relations if r not in moved)
    last = others[-1]
    if not moved or not all(map(_begins, rest)) or any(isinstance(r, Extreme) for s in others for r in s.relations):
        return problem.states
    last = replace(last, relations=(*last.relations, *moved))
    return (replace(first, relations=rest), *others[:-1], last)


def _begins(statement: Statement) -> bool:
    """Does a statement only say where something is, how it moves, or when?"""
    if isinstance(statement, AtRest):
        return True
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    words = {n.word for side in (statement.left, statement.right) for n in walk(side) if isinstance(n, Quantity)}
    return words <= BEGINNING and not any(isinstance(n, Word) for n in walk(statement))


def _statements(state: State) -> Iterator[Statement]:
    given = [s for r in state.relations if isinstance(r, Relation) and r.operator == "=" for s in (r.left, r.right)]
    for statement in state.relations:
        if isinstance(statement, Extreme) and any(written_alike(statement.side, side) for side in given):
            mark, text = statement.mark, statement.text
            nothing = Number(Fraction(0), None, 1, mark)
            rate = _rate(statement.side, statement)
            yield Relation(rate, "=", nothing, text, mark)
            yield Relation(_rate(rate, statement), "<" if statement.sense > 0 else ">", nothing, text, mark)
        else:
            yield statement


def _rate(side: Side, extreme: Extreme) -> Quantity:
    return Quantity("dot", (), side, (), None, extreme.mark)
