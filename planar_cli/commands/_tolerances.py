"""`planar check --tolerance-report`: what rounding on the way does to the answers of problem files."""

from __future__ import annotations

from collections.abc import Iterable

from planar_cli import cli
from planar_cli.commands._limit import limits
from planar_cli.errors import PlanarError
from planar_cli.problem.show import visible
from planar_cli.streams import echo


def tolerances_of(files: tuple[str, ...], timeout: float) -> int:
    """A table for each file."""
    from planar_cli.problem.files import problem_files

    worst = cli.SOLVED
    for path in problem_files(files):
        try:
            with limits(timeout):
                lines = list(_report(path))
        except PlanarError as error:
            worst = max(worst, cli.tell(error))
            continue
        echo(visible(path))
        for line in lines:
            echo(f"  {line}")
    return worst


def _report(path: str) -> Iterable[str]:
    from planar_cli.homework.tolerance_report import FIGURES, tolerance_report
    from planar_cli.homework.worked_problem import read_and_solve

    found, left = tolerance_report(read_and_solve(path, "problem"))
    width = max((len(d.find) for d in found), default=0)
    for d in found:
        nearest = (
            "no wrong model" if d.nearest is None else f"nearest wrong model {_percent(d.nearest)} off: {d.mistake}"
        )
        told = f"{d.find:<{width}}  rounding to {FIGURES} figures: up to {_percent(d.honest)}; {nearest}"
        yield told
        if d.fails_honest:
            told = f"{_percent(d.tolerance)} would fail an honest student: allow more, or ask for more figures"
            yield f"{'':<{width}}  {told}"
        if d.passes_wrong:
            yield f"{'':<{width}}  {_percent(d.tolerance)} would pass a wrong model: {d.mistake}"
    for reason in left:
        yield f"not told: {visible(reason)}"


def _percent(part: float) -> str:
    return f"{100 * part:.2g} %"
