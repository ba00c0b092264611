"""Solve problem files on all cores and compare with the answers that they state.

FILES are problem files or folders (every .yaml and .yml file below). Prints one line for each file and what differs; of
a file without `answers`, which is only solved, `no answers`.
The exit status is 0 when all agree, 1 when an answer disagrees or a problem has no solution, 2 for a bad file, 3 when
something was not decided in time, 4 for a fault of planar; of several, the highest.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from planar_cli import cli
from planar_cli.options import SECONDS, Choice, IntRange, WrongUsage, argument, option
from planar_cli.options import command as declared
from planar_cli.streams import echo

if TYPE_CHECKING:
    from planar_cli.homework.checking import Checked

STATUS = {
    "agrees": cli.SOLVED,
    "disagrees": cli.DISAGREES,
    "no solution": cli.DISAGREES,
    "bad file": cli.BAD,
    "undecided": cli.UNDECIDED,
    "fault": cli.FAULT,
}
NO_ANSWERS = "no answers"
COLOURS = {"agrees": "green", "disagrees": "red", "no solution": "red", "bad file": "red"}


@declared(help=__doc__)
@argument("files")
@option("--format", "form", type=Choice(["text", "json"]), default="text", help="How to print.")
@option("--jobs", type=IntRange(1), help="Worker processes; as many as there are cores.")
@option("--timeout", type=SECONDS, default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(files: tuple[str, ...], form: str, jobs: int | None, timeout: float) -> int:
    """Check all files and print a table."""
    from planar_cli.homework.checking import check_files
    from planar_cli.problem.files import problem_files

    if "-" in files:
        raise WrongUsage("check reads files and folders; `planar solve -` reads standard input")
    paths = list(problem_files(files))
    checked = check_files(paths, jobs or os.cpu_count() or 1, timeout, _progress(len(paths)))
    if form == "json":
        _print_json(checked)
    else:
        _print_table(checked)
        _print_differences(checked)
        _print_count(checked)
    return max(STATUS[c.outcome] for c in checked)


def _progress(total: int) -> Callable[[int], None]:
    """A counter on standard error, if somebody looks at it."""

    def told(done: int) -> None:
        if sys.stderr.isatty():
            end = "\r\033[K" if done == total else ""
            echo(f"\r{done} of {total} problems checked{end}", err=True, end="")

    return told


def _row(checked: Checked) -> tuple[str, str, str, str]:
    right = sum(v.agrees for v in checked.verdicts)
    answers = f"{right} of {len(checked.verdicts)}" if checked.verdicts else "-"
    return checked.path, _told(checked), answers, f"{checked.seconds:.1f}"


def _told(checked: Checked) -> str:
    """The outcome in print: what was solved and states no answers agrees with nothing."""
    return NO_ANSWERS if checked.outcome == "agrees" and not checked.verdicts else checked.outcome


def _print_table(checked: Sequence[Checked]) -> None:
    """With rich on a terminal; else plain columns that other programs can cut."""
    from planar_cli.problem.show import visible

    rows = [tuple(visible(cell) for cell in _row(c)) for c in checked]
    if sys.stdout.isatty():
        _print_rich(checked, rows)
        return
    widths = [max(len(row[i]) for row in rows) for i in range(4)]
    for path, outcome, answers, seconds in rows:
        echo(f"{path:<{widths[0]}}  {outcome:<{widths[1]}}  {answers:>{widths[2]}}  {seconds:>{widths[3]}} s")


def _print_rich(checked: Sequence[Checked], rows: Sequence[tuple[str, ...]]) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table("File", "Outcome", "Answers", "Seconds", box=None)
    for one, row in zip(checked, rows, strict=True):
        # Text, not str: a name of a file is no markup.
        table.add_row(Text(row[0]), Text(row[1], style=COLOURS.get(_told(one), "yellow")), Text(row[2]), Text(row[3]))
    Console().print(table)


def _print_differences(checked: Sequence[Checked]) -> None:
    """What differs, and why a problem was not solved."""
    from planar_cli.diagnostics import show_all
    from planar_cli.problem.show import visible

    for one in checked:
        wrong = [v.message for v in one.verdicts if not v.agrees]
        for message in wrong or ([one.message] if one.message and not one.diagnostics else []):
            echo(visible(f"{one.path}: {message}"), err=True)
        show_all(one.diagnostics)


def _print_count(checked: Sequence[Checked]) -> None:
    outcomes = [_told(c) for c in checked]
    counts = ", ".join(f"{outcomes.count(o)} {o}" for o in (*STATUS, NO_ANSWERS) if o in outcomes)
    answers = [v.agrees for c in checked for v in c.verdicts]
    compared = f"{sum(answers)} of {len(answers)} answers agree" if answers else "nothing to compare"
    echo(f"{len(checked)} problem{'s' if len(checked) != 1 else ''}: {counts}; {compared}")


def _print_json(checked: Sequence[Checked]) -> None:
    from planar_cli.diagnostics import as_data
    from planar_cli.formats.json import dumps

    files: list[dict[str, Any]] = []
    for one in checked:
        answers = [
            {"find": v.find, "stated": v.stated, "solved": v.solved, "agrees": v.agrees, "relative_error": v.error}
            for v in one.verdicts
        ]
        files.append(
            {
                "file": one.path,
                "problem": one.title,
                "outcome": one.outcome,
                "answers": answers,
                "message": one.message,
                "diagnostics": [as_data(d) for d in one.diagnostics],
                "seconds": round(one.seconds, 3),
            }
        )
    echo(dumps({"files": files}), end="")
