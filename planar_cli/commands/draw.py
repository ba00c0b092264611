"""Draw the figures of problem files: the scene, and the free-body and kinetic diagrams of the solution.

FILES are problem files, or - for standard input. Each figure becomes a file of its own: NAME-scene.svg, NAME-BODY.svg
for the diagrams of a body, NAME-velocities.svg for a polygon, NAME-motion.svg for the curves of a motion that was
followed step by step, with a number where there are several. The same input gives the same bytes. With --format png
they are pictures of dots (needs the extra `pdf`). The exit status is that of `planar solve`, but answers that the file
states are not compared.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from planar_cli import cli
from planar_cli.by_click import type_of
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write_files
from planar_cli.errors import PlanarError
from planar_cli.options import SECONDS

if TYPE_CHECKING:
    from planar_cli.problem.scene import Problem

STANDARD_INPUT = "problem"
"""How figures of a problem from standard input are called."""


@click.command(help=__doc__)
@click.argument("files", nargs=-1, required=True)
@click.option("-o", "--output", default=".", metavar="FOLDER", help="Where the files go.  [default: here]")
@click.option("--format", "form", type=click.Choice(["svg", "png"]), default="svg", help="What kind of files.")
@click.option("--timeout", type=type_of(SECONDS), default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(files: tuple[str, ...], output: str, form: str, timeout: float) -> int:
    """Draw each file; one that fails does not keep the others from being drawn."""
    worst = cli.SOLVED
    for path in files:
        try:
            with limits(timeout):
                made = dict(_figures(path, form))
            write_files(made, output)
            for name in made:
                click.echo(str(Path(output, name)))
            if not made:
                worst = max(worst, cli.UNDECIDED)
                cli.say(f"{path}: nothing to draw: the file does not tell where its bodies are")
        except PlanarError as error:
            worst = max(worst, cli.tell(error))
        except Exception as error:
            worst = max(worst, cli.tell_fault(error))
    return worst


def _figures(path: str, form: str) -> Iterator[tuple[str, bytes]]:
    """The figures of a file, by the names of their own files."""
    from planar_cli.homework.checking import read

    problem: Problem = read(path)
    stem = STANDARD_INPUT if path == "-" else Path(path).stem
    for name, text in _drawings(problem, form):
        safe = re.sub(r"[^\w.-]", "_", f"{stem}-{name}")
        yield f"{safe}.{form}", _png(text) if form == "png" else text.encode()


def _drawings(problem: Problem, form: str) -> Iterator[tuple[str, str]]:
    from planar_cli.figures.illustrated import figures_of, illustrated
    from planar_cli.formats._svg import svg
    from planar_cli.report.narrate import narrate
    from planar_cli.solve.run import solve_problem

    solution = solve_problem(problem, problem.method)
    for name, figure in figures_of(illustrated(narrate(solution), solution)):
        yield name, svg(figure, "print" if form == "png" else "own")


def _png(text: str) -> bytes:
    """A figure as a picture of dots."""
    from planar_cli.typeset import png

    return png(text)
