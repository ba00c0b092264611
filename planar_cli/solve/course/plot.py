"""The motion of one problem as a sequence of states with the regimes between them, and its equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from decimal import Decimal
from typing import Any

import sympy as sp

from planar_cli.equation.exact import Valuation
from planar_cli.equation.setup import has_quantity, names_in
from planar_cli.equation.system import mode_of
from planar_cli.errors import NOWHERE, Mark
from planar_cli.problem.expression import Extreme, Name, Relation, Statement
from planar_cli.problem.scene import Problem, State
from planar_cli.solve.course.chain import Chain
from planar_cli.solve.course.equations import (
    Equation,
    Laws,
    drawn_equations,
    law_equations,
    laws_of,
    link_equations,
    loop_equations,
    stated_equations,
)
from planar_cli.solve.course.general import drawn_instant, make_general
from planar_cli.solve.course.regime import Regime
from planar_cli.solve.course.timeline import Demand, Reader, Stop, stop_of
from planar_cli.solve.instant import Instant


@dataclass(frozen=True, slots=True)
class Span:
    """From one state to the next: what acts meanwhile. `key` tells spans apart in which different things act."""

    since: str
    until: str
    problem: Problem
    always: tuple[Statement, ...]

    @property
    def key(self) -> tuple[Any, ...]:
        return (
            tuple(id(s) for s in self.always),
            tuple(id(j) for j in self.problem.joints),
            tuple(id(x) for x in self.problem.loads),
        )


def spans_of(problem: Problem, states: tuple[State, ...]) -> list[Span]:
    """The spans between states in their order, each with the laws, joints and loads that act in it."""
    order = {s.name: i for i, s in enumerate(states)}

    def acts(during: tuple[str, str] | None, i: int) -> bool:
        return during is None or order[during[0]] <= i < order[during[1]]

    found = []
    for i in range(max(len(states) - 1, 1)):
        always = tuple(law.statement for law in problem.motion if acts(law.during, i))
        joints = tuple(j for j in problem.joints if acts(j.during, i))
        loads = tuple(x for x in problem.loads if acts(x.during, i))
        until = states[i + 1].name if i + 1 < len(states) else ""
        since = states[i].name if states else ""
        found.append(Span(since, until, replace(problem, joints=joints, loads=loads), always))
    return found


def fixed_time(relations: tuple[Statement, ...]) -> bool:
    """Does a state say at which time it is?"""
    for s in relations:
        if isinstance(s, Relation) and s.operator == "=":
            for one, other in ((s.left, s.right), (s.right, s.left)):
                if isinstance(one, Name) and one.name == "t" and not has_quantity(other) and "t" not in names_in(other):
                    return True
    return False
