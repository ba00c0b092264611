"""Show what accuracy costs: errors, estimated errors, work and time of every integrator, scene by scene.

FILES are problem files or folders, or - for standard input. One file gets a table of integrators and tolerances with a
diagram of error over time, and the settings to recommend for 3, 6 and 10 digits; several files get one line each.
Errors are measured against a run at the limit of double precision, which another method checks, and are told in parts
of the scene's own scales. The exit status is 0 when every motion was followed, 1 when one has no start or no unique
continuation, 2 for wrong usage or a bad file, 3 when one could not be followed, 4 for a fault of planar.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from planar_cli import cli
from planar_cli.by_click import type_of
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write, write_bytes
from planar_cli.commands._picture_files import demand_picture, picture_bytes
from planar_cli.errors import FileProblem, PlanarError, Undecided
from planar_cli.options import SECONDS, FloatRange
from planar_cli.registry import modules

if TYPE_CHECKING:
    from planar_cli.problem.scene.scene import Problem
    from planar_cli.simulate.accuracy import Study, Wanted
    from planar_cli.simulate.accuracy_report import Told

FORMS = ("table", "json", "csv", "markdown")
TOLERANCE = type_of(FloatRange(1e-15, 0.1))


@click.command(help=__doc__)
@click.argument("files", nargs=-1, required=True)
@click.option("--format", "form", type=click.Choice(FORMS), default="table", help="How to print.")
@click.option("--integrator", "integrators", multiple=True, type=click.Choice(["auto", *modules("integrators")]))
@click.option("--tolerance", "tolerances", multiple=True, type=TOLERANCE, help="Only these tolerances.")
@click.option("--step", "steps", multiple=True, metavar="TIME", help="Only these steps, of methods with equal ones.")
@click.option("--peers", is_flag=True, help="Compare with SciPy, heyoka, exudyn and MuJoCo, as installed.")
@click.option("--until", metavar="TIME", help="Where the motion ends: `10 s`, `2 min`, or seconds.")
@click.option("--plot", metavar="FILE", help="Draw the diagram into a .svg or .png file.")
@click.option("--budget", type=type_of(SECONDS), default=2, show_default=True, help="Seconds of the longest run.")
@click.option("-o", "--output", metavar="FILE", help="Write to FILE instead of standard output.")
@click.option("--timeout", type=type_of(SECONDS), default=120, show_default=True, help="Seconds a file; 0: none.")
def command(files: tuple[str, ...], form: str, plot: str | None, output: str | None, **options: Any) -> int:
    """Study each file; one that fails does not keep the others from being studied."""
    from planar_cli.problem.nodes.files import problem_files
    from planar_cli.simulate.accuracy_report import Told

    demand_picture(plot)
    paths = list(problem_files(files))
    told, status = [], cli.SOLVED
    for path in paths:
        try:
            with limits(options["timeout"]):
                more, one = _told(path, options, brief=len(paths) > 1)
        except PlanarError as error:
            more, one = cli.tell(error), None
        except click.ClickException:
            raise
        except Exception as error:
            more, one = cli.tell_fault(error), Told(path, failed=f"a fault: {type(error).__name__}: {error}")
        status = max(status, more)
        told += [one] if one is not None else []
    if told:
        from planar_cli.formats._terminals import shown_on

        with shown_on(sys.stdout, output) as width:
            write(_text(told, form, len(paths) > 1, width), output, exact=True)
    if plot is not None:
        status = max(status, _plotted([(one.title, one.study) for one in told if one.study is not None], plot))
    return status


def _plotted(studies: Sequence[tuple[str, Study]], path: str) -> int:
    """The diagram of all as a picture."""
    from planar_cli.figures.accuracy_plot import accuracy_plot

    if not studies:
        return cli.SOLVED
    try:
        write_bytes(picture_bytes(accuracy_plot(studies), path), path)
    except PlanarError as error:
        return cli.tell(error)
    return cli.SOLVED


def _text(told: Sequence[Told], form: str, several: bool, width: int) -> str:
    """All as one output."""
    from planar_cli.simulate.accuracy_report import as_csv, as_data, as_markdown, as_summary, as_text

    if form == "json":
        from planar_cli.formats.json import dumps

        data = [as_data(one) for one in told]
        return dumps({"studies": data} if several else data[0])
    if form == "csv":
        return as_csv(told)
    if form == "markdown":
        return "\n".join(map(as_markdown, told))
    return as_summary(told, width) if several else as_text(told[0], width)


def _told(path: str, options: dict[str, Any], brief: bool) -> tuple[int, Told]:
    """One file; `brief`: as much as a line tells."""
    from planar_cli.homework.checking.solving import solved
    from planar_cli.problem.structure import load
    from planar_cli.simulate.accuracy_report import Told

    problem, wrong, _ = load(path)
    if wrong or problem is None:
        raise FileProblem(wrong)
    title, status, found, failed = problem.title or path, cli.SOLVED, None, ""
    answered = problem.find or any(case.problem.find for case in problem.cases)
    try:
        found = _studied(problem, options, brief)
        if found.ran.refused:
            status = cli.UNDECIDED
    except PlanarError as error:
        status, failed = cli.status_of(error), str(error)
    return status, Told(title, found, solved(problem) if answered and not brief else None, failed)


def _studied(problem: Problem, options: dict[str, Any], brief: bool) -> Study:
    """The motion of a file, or as far as it goes."""
    from planar_cli.simulate.accuracy import study
    from planar_cli.simulate.request import later_time, time_of
    from planar_cli.simulate.subject import SceneSubject

    until = None if options["until"] is None else time_of(options["until"], "--until")
    subject = SceneSubject(_followed(problem), until)
    steps = [later_time(step, "--step") / subject.time_scale for step in options["steps"]]
    return study(subject, _wanted(options, steps, brief))


def _followed(problem: Problem) -> Problem:
    """The motion of a file: its own, or that of its only case."""
    if problem.states or problem.instant is not None or not problem.cases:
        return problem
    if len(problem.cases) == 1:
        return problem.cases[0].problem
    raise Undecided(f"{problem.file} has several cases and no motion of its own")


def _wanted(options: dict[str, Any], steps: Sequence[float], brief: bool) -> Wanted:
    from planar_cli.simulate.accuracy import BRIEF_TOLERANCES, STEPS, TOLERANCES, Wanted

    return Wanted(
        integrators=options["integrators"] or (("auto",) if brief and not options["peers"] else ()),
        peers=options["peers"],
        tolerances=options["tolerances"] or (BRIEF_TOLERANCES if brief else TOLERANCES),
        steps=tuple(steps) or STEPS,
        budget=options["budget"],
        progress=_progress,
    )


def _progress(words: str) -> None:
    """What is tried now, on standard error if somebody looks at it."""
    if sys.stderr.isatty():
        click.echo(f"\r\033[K{words}" if words else "\r\033[K", nl=False, err=True)
