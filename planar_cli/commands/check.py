"""Solve problem files and compare with the answers that they state, or grade submissions against a homework set.

FILES are problem files or folders (every .yaml and .yml file below). Prints one line for each file and what differs; of
a file without `answers`, which is only solved, `no answers`.
With --set FILES are submissions: YAML, JSON or CSV files or folders of them. Each find gets a verdict on value, unit,
sign and precision; a wrong number that a typical mistake gives is told so. See `planar explain homework`.
The exit status is 0 when all agree, 1 when an answer disagrees or a problem has no solution, 2 for a bad file, 3 when
something was not decided in time, 4 for a fault of planar; of several, the highest. A graded class is 0 whatever its
answers are, unless submissions could not be graded within their limits. Ctrl-C and SIGTERM end a run early: what is
done is printed, and the status is 130 or 143.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from planar_cli import cli
from planar_cli.options import SECONDS, Choice, IntRange, WrongUsage, argument, option
from planar_cli.options import command as declared
from planar_cli.streams import echo

if TYPE_CHECKING:
    from planar_cli.homework.checking.checking import Checked

STATUS = {
    "agrees": cli.SOLVED,
    "disagrees": cli.DISAGREES,
    "no solution": cli.DISAGREES,
    "bad file": cli.BAD,
    "undecided": cli.UNDECIDED,
    "fault": cli.FAULT,
}
FORMS = ("terminal", "json", "jsonl", "csv", "junit", "github", "markdown")
ONLY_SET = {
    "--feedback": "feedback",
    "--export": "exports",
    "--output": "output",
    "--student": "for_student",
    "--cluster": "cluster",
    "--false-matches": "matches",
}
"""Options that say something of a set alone."""
COLOURS = {"agrees": "green", "disagrees": "red", "no solution": "red", "bad file": "red"}


@declared(help=__doc__)
@argument("files", required=False)
@option("--set", "homework", metavar="SET", help="A homework set against which FILES are graded.")
@option("--format", "form", type=Choice(FORMS), default="terminal", help="How to print.")
@option("--results", metavar="FILE", help="Lines of JSON as they come; a second run takes up there.")
@option("--export", "exports", multiple=True, metavar="NAME", help="With --set: gradebook, canvas or gradescope.")
@option("--feedback", metavar="FOLDER", help="With --set: a text for each student, with nothing of the key.")
@option("-o", "--output", metavar="FOLDER", help="Where exports are written.")
@option("--student", "for_student", is_flag=True, help="With --set: nothing of the key is printed.")
@option("--shard", metavar="K/N", default="1/1", help="Only the Kth of N parts of the files.")
@option("--cluster", metavar="ADDRESS", help="With --set: grade on a dask cluster: `tcp://host:8786`.")
@option("--tolerance-report", "tolerances", is_flag=True, help="What rounding on the way does to each find.")
@option("--false-matches", "matches", is_flag=True, help="With --set: how often a random wrong number is diagnosed.")
@option("--jobs", type=IntRange(1), help="Worker processes; as many as there are cores.")
@option("--timeout", type=SECONDS, default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(
    files: tuple[str, ...], homework: str | None, form: str, jobs: int | None, timeout: float, **options: Any
) -> int:
    """Check all files and print a table, or grade a class."""
    if "-" in files:
        raise WrongUsage("check reads files and folders; `planar solve -` reads standard input")
    if homework is not None:
        from planar_cli.commands._check_set import checked_set

        return checked_set(homework, files, form, jobs or os.cpu_count() or 1, timeout, options)
    wrong = next((o for o, name in ONLY_SET.items() if options[name] not in (None, (), False, "1/1")), None)
    if wrong is not None:
        raise WrongUsage(f"{wrong} belongs to --set")
    if not files:
        raise WrongUsage("name a problem file or a folder")
    if options["tolerances"]:
        from planar_cli.commands._tolerances import tolerances_of

        return tolerances_of(files, timeout)
    return _checked(files, form, jobs or os.cpu_count() or 1, timeout, options)


def _checked(files: tuple[str, ...], form: str, jobs: int, timeout: float, options: Mapping[str, Any]) -> int:
    from planar_cli.commands._check_formats import HEADS, STREAMED
    from planar_cli.commands._counter import counter
    from planar_cli.homework.checking.checked_files import check_files
    from planar_cli.homework.submissions.batches import in_shard, shard_of
    from planar_cli.problem.nodes.files import problem_files

    shard = shard_of(options["shard"])
    paths = list(dict.fromkeys(p for p in problem_files(files) if in_shard(p, shard)))
    checked: list[Checked] = []

    def hear(one: Checked) -> None:
        checked.append(one)
        if form in STREAMED:
            echo(STREAMED[form](one), end="", exact=True)

    echo(HEADS.get(form, ""), end="", exact=True)
    told = counter(len(paths), "problems checked")
    interrupted = check_files(paths, jobs, timeout, hear, told, options["results"])
    _print(checked, form)
    if interrupted:
        echo(f"interrupted: {len(checked)} of {len(paths)} problems were checked", err=True)
        return 128 + interrupted
    return max((STATUS[c.outcome] for c in checked), default=cli.SOLVED)


def _print(checked: Sequence[Checked], form: str) -> None:
    """All that can be printed only when everything is known."""
    from planar_cli.commands._check_formats import WHOLE

    if form == "json":
        _print_json(checked)
    elif form == "terminal":
        if checked:
            _print_table(checked)
        _print_differences(checked)
        _print_count(checked)
    elif form in WHOLE:
        echo(WHOLE[form](checked), end="", exact=True)


def _row(checked: Checked) -> tuple[str, str, str, str]:
    from planar_cli.commands._check_formats import told

    right = sum(v.agrees for v in checked.verdicts)
    answers = f"{right} of {len(checked.verdicts)}" if checked.verdicts else "-"
    return checked.path, told(checked), answers, f"{checked.seconds:.1f}"


def _print_table(checked: Sequence[Checked]) -> None:
    """With rich on a terminal; else plain columns that other programs can cut."""
    from planar_cli.problem.nodes.show import visible

    rows = [tuple(visible(cell) for cell in _row(c)) for c in checked]
    if sys.stdout.isatty():
        _print_rich(rows)
        return
    widths = [max(len(row[i]) for row in rows) for i in range(4)]
    for path, outcome, answers, seconds in rows:
        echo(f"{path:<{widths[0]}}  {outcome:<{widths[1]}}  {answers:>{widths[2]}}  {seconds:>{widths[3]}} s")


def _print_rich(rows: Sequence[tuple[str, ...]]) -> None:
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table("File", "Outcome", "Answers", "Seconds", box=None)
    for row in rows:
        # Text, not str: a name of a file is no markup.
        table.add_row(Text(row[0]), Text(row[1], style=COLOURS.get(row[1], "yellow")), Text(row[2]), Text(row[3]))
    Console().print(table)


def _print_differences(checked: Sequence[Checked]) -> None:
    """What differs, and why a problem was not solved."""
    from planar_cli.diagnostics import show_all
    from planar_cli.problem.nodes.show import visible

    for one in checked:
        wrong = [v.message for v in one.verdicts if not v.agrees]
        for message in wrong or ([one.message] if one.message and not one.diagnostics else []):
            echo(visible(f"{one.path}: {message}"), err=True)
        show_all(one.diagnostics)


def _print_count(checked: Sequence[Checked]) -> None:
    from planar_cli.commands._check_formats import NO_ANSWERS, told

    outcomes = [told(c) for c in checked]
    counts = ", ".join(f"{outcomes.count(o)} {o}" for o in (*STATUS, NO_ANSWERS) if o in outcomes)
    answers = [v.agrees for c in checked for v in c.verdicts]
    compared = f"{sum(answers)} of {len(answers)} answers agree" if answers else "nothing to compare"
    echo(f"{len(checked)} problem{'s' if len(checked) != 1 else ''}: {counts}; {compared}")


def _print_json(checked: Sequence[Checked]) -> None:
    from planar_cli.commands._check_formats import as_record
    from planar_cli.formats.json import dumps

    echo(dumps({"files": [as_record(c) for c in checked]}), end="", exact=True)
