"""Every method held against one problem: which reach the answers, with how many equations."""

from __future__ import annotations

from dataclasses import replace

from planar_cli.errors import FileProblem
from planar_cli.problem.scene.scene import Problem
from planar_cli.records import record
from planar_cli.solve.instant.used import used_blocks
from planar_cli.solve.principled import every_principle, principle_of
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import PartSolution

NOT_REACHED = "PL570"
TOGETHER = "together"
"""No method by itself: any law of any of them."""


@record
class Row:
    """One method: its equations in all parts together, the largest block, the finds it reaches, or why it does not."""

    method: str
    equations: int
    largest_block: int
    answers: tuple[str, ...]
    objection: str


def compare_methods(problem: Problem) -> tuple[Row, ...]:
    """One row for each principle of the shelf, the shortest plan first; before them, where none reaches everything, one
    for their laws together.
    """
    rows = []
    for principle in every_principle():
        objection = principle.objection(problem)
        kind = principle.kind
        rows.append(Row(kind, 0, 0, (), objection) if objection else _row(problem, kind))
    rows = sorted(rows, key=lambda r: (bool(r.objection), r.equations, not principle_of(r.method).usual))
    together = [_row(problem, None)] if problem.method is None and all(r.objection for r in rows) else []
    return (*together, *rows)


def _row(problem: Problem, kind: str | None) -> Row:
    """What one method makes of a problem, or all together; of finds that it does not reach it is said why."""
    try:
        solution = solve_problem(problem, kind)
    except FileProblem as error:
        if kind is None or any(d.code != NOT_REACHED for d in error.diagnostics):
            raise
        return _partly(problem, kind, error.diagnostics[0].message)
    names = tuple(f.name for part in solution.parts for f in part.found)
    efforts = [_effort(part) for part in solution.parts]
    return Row(kind or TOGETHER, sum(n for n, _ in efforts), max((b for _, b in efforts), default=0), names, "")


def _partly(problem: Problem, kind: str, why: str) -> Row:
    """The finds of the file itself that a method reaches one by one."""
    reached: list[str] = []
    equations = largest = 0
    for find in problem.find if len(problem.find) > 1 else ():
        alone = replace(problem, find=(find,), cases=())
        try:
            part = solve_problem(alone, kind).parts[0]
        except FileProblem:
            continue
        count, block = _effort(part)
        reached.append(find.name)
        equations, largest = max(equations, count), max(largest, block)
    return Row(kind, equations, largest, tuple(reached), why)


def _effort(part: PartSolution) -> tuple[int, int]:
    """How many equations a part takes, those between its states among them, and its largest block."""
    if part.motion is None:
        stages = [s for i in part.instants for s in i.stages]
        return sum(s.plan.equations for s in stages), max((s.plan.largest for s in stages), default=0)
    heard = [i for i in part.instants if not i.quiet]
    blocks = [b for i in heard for s in used_blocks(i.stages, part.motion.regime(i).wanted) for b in s.blocks]
    sizes = [len(b.equations) for b in blocks]
    route = part.motion.route
    sizes += [len(step.relations) for step in route.steps if not step.is_datum]
    return sum(sizes), max(sizes, default=0)
