"""Follow the motion of scenes step by step, and print it as a table.

FILES are problem files, or - for standard input; a scene without `find` will do. The motion begins in the first state
(or the instant) of the file; later states are looked for on the way. What the file asks is answered with an estimated
error. The exit status is 0 when every motion was followed to its end, 1 when it contradicts itself or has no unique
continuation, 2 for wrong usage or a bad file, 3 when it could not be followed, 4 for a fault of planar.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from planar_cli import cli
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write, write_bytes
from planar_cli.commands._picture_files import PICTURES, demand_picture, picture_bytes
from planar_cli.errors import FileProblem, PlanarError
from planar_cli.options import SECONDS, Choice, FloatRange, IntRange, WrongUsage, argument, option
from planar_cli.options import command as declared
from planar_cli.registry import modules

if TYPE_CHECKING:
    from planar_cli.problem.scene.scene import Problem
    from planar_cli.simulate.report import Motion
    from planar_cli.simulate.request import Request

STATUS = {"followed": cli.SOLVED, "contradicted": cli.DISAGREES, "not followed": cli.UNDECIDED}
OUTPUTS = ("table", "csv", "json", "npz")
MOST_PLOTS = 3
"""In letters below the table."""
PLOTS = ("time", "path", "phase", "energy")
FILMS = (".svg", ".html")


@declared(help=__doc__)
@argument("files")
@option("--until", metavar="TIME", help="Where the motion ends: `10 s`, `2 min`, or seconds.")
@option("--stop", "stops", multiple=True, metavar="RELATION", help="End where this holds: `y(ball) = 0`.")
@option("-q", "--quantity", "quantities", multiple=True, metavar="[NAME=]QUANTITY", help="A column of the table.")
@option("--at", "times", multiple=True, metavar="TIME", help="A row at this time; may be repeated.")
@option("--rows", type=IntRange(2, 1_000_000), help="How many rows; 21 in a table, else 201.")
@option("--tolerance", type=FloatRange(1e-14, 0.1), default=1e-9, show_default=True, help="Of one step.")
@option("--integrator", type=Choice(["auto", *modules("integrators")]), default="auto", help="The method.")
@option("--step", metavar="TIME", help="A fixed step instead of one that follows the tolerance.")
@option("--set", "values", multiple=True, metavar="NAME=VALUE", help="A number for a letter: `m=2 kg`.")
@option("--case", "case", metavar="NAME", help="Only this case of the file.")
@option("--without", multiple=True, metavar="EFFECT", help="Run without it too, and compare: friction, drag ...")
@option("--effects", is_flag=True, help="Print which effects the scene calls for, and what they cost.")
@option("--output", type=Choice(OUTPUTS), default="table", help="How to print.")
@option("--plot", metavar="FILE", help="Draw the motion into a .svg or .png file, beside what is printed.")
@option("--plot-of", "plots", type=Choice(PLOTS), multiple=True, help="What to draw: quantities over time, ways ...")
@option("--animate", metavar="FILE", help="Show the motion in a .svg or .html file, which plays in any browser.")
@option("--speed", type=FloatRange(1e-9, 1e9), help="How many times as fast as it is; left out, 1 if that can be seen.")
@option("-o", "--file", "file", metavar="FILE", help="Write to FILE instead of standard output.")
@option("--timeout", type=SECONDS, default=60, show_default=True, help="Seconds a file; 0: none.")
def command(
    files: tuple[str, ...],
    file: str | None,
    timeout: float,
    plot: str | None,
    plots: tuple[str, ...],
    animate: str | None,
    speed: float | None,
    **options: Any,
) -> int:
    """Simulate each file; one that fails does not keep the others from being followed."""
    from planar_cli.simulate.request import request_of

    if options["output"] == "npz" and (file is None or len(files) > 1):
        raise WrongUsage("npz holds numbers for programs: simulate one file, and write `-o motion.npz`")
    if plots and plot is None:
        raise WrongUsage("--plot-of says what a picture shows: add `--plot motion.svg`")
    if speed is not None and animate is None:
        raise WrongUsage("--speed is that of an animation: add `--animate motion.html`")
    _demand_one(files, plot, PICTURES)
    _demand_one(files, animate, FILMS)
    request = request_of(**options)
    status, pieces = cli.SOLVED, []
    motions: list[Motion] = []
    for path in files:
        try:
            with limits(timeout):
                more, piece = _simulated(path, request, motions, file)
        except PlanarError as error:
            more, piece = cli.tell(error), None
        status = max(status, more)
        if piece is not None:
            pieces.append(piece)
    _put(pieces, request, file)
    for target, drawn in ((plot, partial(_picture, motions, plots)), (animate, partial(_film, motions, speed))):
        if target is None or not motions:
            continue
        try:
            with limits(timeout):
                write_bytes(drawn(target), target)
        except PlanarError as error:
            status = max(status, cli.tell(error))
    return status


def _demand_one(files: tuple[str, ...], path: str | None, endings: tuple[str, ...]) -> None:
    """WrongUsage where no picture of that name can come of these files."""
    demand_picture(path, endings)
    if path is not None and len(files) > 1:
        raise WrongUsage("a picture shows the motion of one file: simulate one file at a time")


def _picture(motions: Sequence[Motion], plots: Sequence[str], path: str) -> bytes:
    """The motions of a file as a picture."""
    from planar_cli.figures.plots import plot

    problem = motions[0].run.problem
    return picture_bytes(plot(motions, plots or ("time",), problem.title or problem.file), path)


def _film(motions: Sequence[Motion], speed: float | None, path: str) -> bytes:
    """The motion of a file, or of its first case, as it goes on."""
    from planar_cli.figures.frames import film
    from planar_cli.formats._animated import animated, page
    from planar_cli.problem.nodes.reading import listed

    others = [m.case for m in motions[1:]]
    if others:
        cases = "case" if len(others) == 1 else "cases"
        cli.say(f"{path} does not show the {cases} {listed(others, 'and')}: `--case {others[0]}` shows that one alone")
    shown = film(motions[0].run, speed)
    return (animated(shown) if path.lower().endswith(".svg") else page(shown)).encode()


def _simulated(path: str, request: Request, motions: list[Motion], file: str | None) -> tuple[int, Any]:
    """One file as text, or as data for JSON and npz."""
    from planar_cli.problem.structure import load
    from planar_cli.simulate.report import Watch, told

    problem, wrong, _ = load(path)
    if wrong or problem is None:
        raise FileProblem(wrong)
    from planar_cli.formats._terminals import shown_on

    with shown_on(sys.stdout, file) as width:
        watch = Watch(_progress(problem), partial(_small_plots, width), motions, width)
        ended, piece = told(problem, request, watch)
    return STATUS[ended], piece


def _small_plots(width: int, motion: Motion) -> list[str]:
    """The first columns of the table that change, as plots in letters."""
    from planar_cli.figures.plots import changing_graphs
    from planar_cli.formats._small_plot import small_plot

    return [line for graph in changing_graphs(motion)[:MOST_PLOTS] for line in ("", *small_plot(graph, width))]


def _progress(problem: Problem) -> Callable[[float, float], None] | None:
    """A bar on standard error for long runs, if somebody looks at it."""
    if not sys.stderr.isatty():
        return None
    from planar_cli.commands._progress import Bar

    return Bar(problem.title or problem.file).show


def _put(pieces: list[Any], request: Request, file: str | None) -> None:
    """All results as one output."""
    if request.output == "npz":
        from planar_cli.simulate.arrays import npz

        if pieces:
            write_bytes(npz(pieces[0]), file or "")
    elif request.output == "json":
        from planar_cli.formats.json import dumps

        if pieces:
            write(dumps(pieces[0] if len(pieces) == 1 else {"simulations": pieces}), file, exact=True)
    elif pieces:
        write("\n".join(pieces), file, exact=True)
