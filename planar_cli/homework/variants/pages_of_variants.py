"""What of the pages of a set rests on the problem alone, its figure and its worked solution, made for each variant by
itself: on several workers, each within the limit of time.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Protocol

from planar_cli.errors import Diagnostic, FileProblem, PlanarError, UndecidedFiles
from planar_cli.homework.sets.paper import Printed
from planar_cli.homework.sets.ready import Prepared, Values
from planar_cli.homework.sets.set_file import HomeworkSet
from planar_cli.homework.variants.marked_solution import plainly_read
from planar_cli.problem.nodes.nodes import read_file
from planar_cli.problem.scene.scene import Problem
from planar_cli.problem.sections.variations import with_first_values, with_values
from planar_cli.records import record
from planar_cli.solve.run import solve_problem
from planar_cli.solve.solved_problem import Solution

Item = tuple[str, Values, "Press"]


class Press(Protocol):
    """Prints the parts of pages."""

    @property
    def solves(self) -> bool:
        """Are worked solutions wanted?"""

    def scene(self, problem: Problem) -> Printed: ...
    def worked(self, solution: Solution) -> Printed: ...


def with_pages(
    homework_set: HomeworkSet,
    problems: Sequence[Prepared],
    press: Press,
    workers: tuple[int, float],
    counter: Callable[[int], Callable[[int], None]],
) -> list[Prepared]:
    """The problems with what is printed of them. `workers`: how many, and the seconds that each page may take;
    `counter`: of a total, hears how many are done. PlanarError: a page was not made in time.
    """
    from planar_cli.homework.tasks.supervisor import Supervisor, demand_no_fault

    jobs, timeout = workers
    # Variant 0 is handed out where there are no others.
    first = min(homework_set.variants, 1)
    items: dict[tuple[str, Values], Item] = {}
    for problem, ready in zip(homework_set.problems, problems, strict=True):
        items |= {(problem.path, v): (problem.path, v, press) for v in ready.values[first:]}
    ended = Supervisor(_page, jobs, timeout, counter(len(items))).run(list(items.values()))
    demand_no_fault(zip((path for path, _ in items), ended, strict=True))
    made = dict(zip(items, ended, strict=True))
    found, wrong, undecided = [], [], False
    for problem, ready in zip(homework_set.problems, problems, strict=True):
        tasks = list(ready.tasks[:first])
        for variant, (task, values) in enumerate(zip(ready.tasks[first:], ready.values[first:], strict=True), first):
            page = made[problem.path, values]
            result = page.result
            if isinstance(result, Made):
                tasks.append(replace(task, scene=result.scene, worked=result.worked))
                continue
            text = f"{problem.path}: the page of {f'variant {variant}' if variant else 'the file'}: {result}"
            hint = "`--timeout 0` sets no limit" if page.verdict == "timeout" else ""
            undecided |= page.verdict != "ok"
            wrong.append(Diagnostic(problem.mark, "PL803", text, hint))
            break
        found.append(replace(ready, tasks=tuple(tasks)))
    if wrong:
        raise UndecidedFiles(wrong) if undecided else FileProblem(wrong)
    return found


@record
class Made:
    """What was printed."""

    scene: Printed
    worked: Printed


def _page(item: Item) -> Made | str:
    path, values, press = item
    node = read_file(path)[1]
    assert node is not None
    try:
        problem = plainly_read(path, with_values(with_first_values(node), dict(values)))
        worked = press.worked(solve_problem(problem, problem.method)) if press.solves else {}
        return Made(press.scene(problem), worked)
    except PlanarError as error:
        return str(error)
