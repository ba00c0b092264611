"""Every method held against one problem: which reach the answers, with how many equations."""

from __future__ import annotations

from dataclasses import dataclass

from planar_cli.problem.scene import Problem
from planar_cli.registry import members
from planar_cli.solve.run import solve_problem


@dataclass(frozen=True, slots=True)
class Row:
    """One method: its equations in all parts together, the largest block, the finds it reaches, or why it does not."""

    method: str
    equations: int
    largest_block: int
    answers: tuple[str, ...]
    objection: str


def compare_methods(problem: Problem) -> tuple[Row, ...]:
    """One row for each principle of the shelf, the shortest plan first."""
    rows = []
    for kind, principle in members("principles").items():
        objection = principle().objection(problem)
        if objection:
            rows.append(Row(kind, 0, 0, (), objection))
            continue
        solution = solve_problem(problem, kind)
        stages = [s for part in solution.parts for i in part.instants for s in i.stages]
        largest = max((s.plan.largest for s in stages), default=0)
        names = tuple(f.name for part in solution.parts for f in part.found)
        rows.append(Row(kind, sum(s.plan.equations for s in stages), largest, names, ""))
    return tuple(sorted(rows, key=lambda r: (bool(r.objection), r.equations, r.method != "newton")))
