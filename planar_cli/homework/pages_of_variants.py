"""The worked pages of all variants of a set, each made by itself: on several workers, each within the limit of time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from planar_cli.errors import Diagnostic, FileProblem, PlanarError
from planar_cli.homework.paper import Printed
from planar_cli.homework.ready import Prepared, Values
from planar_cli.homework.set_file import HomeworkSet
from planar_cli.homework.worked_problem import plainly_solved
from planar_cli.problem.nodes import read_file
from planar_cli.problem.variations import with_first_values, with_values
from planar_cli.records import record
from planar_cli.solve.solved_problem import Solution

Page = Callable[[Solution], Printed]
"""Prints a worked solution."""
Item = tuple[str, Values, Page]


def with_pages(
    homework_set: HomeworkSet,
    problems: Sequence[Prepared],
    page: Page,
    workers: tuple[int, float],
    counter: Callable[[int], Callable[[int], None]],
) -> list[Prepared]:
    """The problems with their worked pages. `workers`: how many, and the seconds that each page may take; `counter`:
    of a total, hears how many are done. PlanarError: a page was not made in time.
    """
    from planar_cli.homework.supervisor import Supervisor

    jobs, timeout = workers
    # Variant 0 is handed out where there are no others.
    first = min(homework_set.variants, 1)
    items: dict[tuple[str, Values], Item] = {}
    for problem, ready in zip(homework_set.problems, problems, strict=True):
        items |= {(problem.path, v): (problem.path, v, page) for v in ready.values[first:]}
    ended = Supervisor(_page, jobs, timeout, counter(len(items))).run(list(items.values()))
    made = dict(zip(items, ended, strict=True))
    found, wrong = [], []
    for problem, ready in zip(homework_set.problems, problems, strict=True):
        tasks = list(ready.tasks[:first])
        for variant, (task, values) in enumerate(zip(ready.tasks[first:], ready.values[first:], strict=True), first):
            result = made[problem.path, values].result
            if isinstance(result, Made):
                tasks.append(replace(task, worked=result.page))
                continue
            text = f"{problem.path}: the worked page of {f'variant {variant}' if variant else 'the file'}: {result}"
            hint = "`--timeout 0` sets no limit" if made[problem.path, values].verdict == "timeout" else ""
            wrong.append(Diagnostic(problem.mark, "PL803", text, hint))
            break
        found.append(replace(ready, tasks=tuple(tasks)))
    if wrong:
        raise FileProblem(wrong)
    return found


@record
class Made:
    """A page that was made."""

    page: Printed


def _page(item: Item) -> Made | str:
    path, values, page = item
    node = read_file(path)[1]
    assert node is not None
    try:
        return Made(page(plainly_solved(path, with_values(with_first_values(node), dict(values)))))
    except PlanarError as error:
        return str(error)
