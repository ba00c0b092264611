"""`planar check --tolerance-report`: what rounding on the way does to the answers of problem files."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from planar_cli import cli
from planar_cli.commands._limit import limits
from planar_cli.errors import PlanarError
from planar_cli.problem.nodes.show import visible
from planar_cli.streams import echo

if TYPE_CHECKING:
    from planar_cli.homework.sets.rules import Rules
    from planar_cli.homework.sets.set_file import HomeworkSet
    from planar_cli.homework.variants.tolerance_report import Danger


def tolerances_of(files: tuple[str, ...], timeout: float) -> int:
    """A table for each file."""
    from planar_cli.homework.sets.rules import Rules
    from planar_cli.problem.nodes.files import problem_files

    return _all([(path, "problem", 0, 1, Rules()) for path in problem_files(files)], timeout)


def tolerances_of_set(homework: HomeworkSet, timeout: float) -> int:
    """A table for each problem of a set, with its variants and by its rules."""
    of_set = homework.variants, homework.seed, homework.rules
    return _all([(p.path, p.name, *of_set) for p in homework.problems], timeout)


Item = tuple[str, str, int, int, "Rules"]
"""The file, its name in the set, how many variants, their seed, the rules."""


def _all(items: Iterable[Item], timeout: float) -> int:
    worst = cli.SOLVED
    for item in items:
        try:
            with limits(timeout):
                lines = list(_report(*item))
        except PlanarError as error:
            worst = max(worst, cli.tell(error))
            continue
        echo(visible(item[0]))
        for line in lines:
            echo(f"  {line}")
    return worst


def _report(path: str, name: str, number: int, seed: int, rules: Rules) -> Iterator[str]:
    from planar_cli.homework.variants.tolerance_report import tolerance_report
    from planar_cli.homework.variants.variants import variants_of
    from planar_cli.homework.variants.worked_problem import read_and_solve

    solved = read_and_solve(path, name)
    found, left = tolerance_report(solved, rules, variants_of(solved, number, seed).taken if number else ())
    width = max((len(row[0].find) for row in found), default=0)
    for row in found:
        yield from _told(row, width)
    for reason in left:
        yield f"not told: {visible(reason)}"


def _told(row: Sequence[Danger], width: int) -> Iterator[str]:
    """One find. `row`: its danger with the values of the file, and in each variant."""
    from planar_cli.homework.variants.tolerance_report import FIGURES

    worst = max(row, key=lambda d: d.honest)
    wrong = min((d for d in row if d.nearest is not None), key=lambda d: d.nearest or 0.0, default=None)
    nearest = "no wrong model"
    if wrong is not None and wrong.nearest is not None:
        nearest = f"nearest wrong model {_percent(wrong.nearest)} off{_where(row, [wrong])}: {wrong.mistake}"
    honest = f"rounding to {FIGURES} figures: up to {_percent(worst.honest)}{_where(row, [worst])}"
    yield f"{worst.find:<{width}}  {honest}; {nearest}"
    if failing := [d for d in row if d.fails_honest]:
        told = f"{_percent(worst.tolerance)} would fail an honest student{_where(row, failing)}"
        yield f"{'':<{width}}  {told}: allow more, or ask for more figures"
    for mistake in dict.fromkeys(m for d in row for m in d.passes):
        passing = [d for d in row if mistake in d.passes]
        told = f"{_percent(passing[0].tolerance)} would pass a wrong model{_where(row, passing)}: {mistake}"
        yield f"{'':<{width}}  {told}"


def _where(row: Sequence[Danger], some: Sequence[Danger]) -> str:
    """In which variants; "" of a file without any."""
    if len(row) == 1:
        return ""
    places = [k for k, d in enumerate(row) if any(d is s for s in some)]
    variants = [str(k) for k in places if k]
    if len(variants) == len(row) - 1:
        return " in all variants"
    file = [] if 0 not in places else ["with the values of the file"]
    plural = "s"[: len(variants) > 1]
    return " " + " and ".join([*file, *([f"in variant{plural} {', '.join(variants)}"] if variants else [])])


def _percent(part: float) -> str:
    return f"{100 * part:.2g} %"
