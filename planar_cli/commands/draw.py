"""Draw the figures of problem files: the scene, and the free-body and kinetic diagrams of the solution.

FILES are problem files, or - for standard input. Each figure becomes a file of its own: NAME-scene.svg, NAME-BODY.svg
for the diagrams of a body, NAME-velocities.svg for a polygon, NAME-centre_of_BODY.svg for an instantaneous centre,
NAME-vectors_of_POINT.svg for components of its velocity and acceleration, NAME-motion.svg for the curves of a motion
that was followed step by step, with a number where there are several. The same input gives the same bytes. Of a scene
in which a long rope, floor or distance would make all else too small to be read, that line is broken, and the figure
says so. With --format png they are pictures of dots (needs the extra `pdf`); with --format terminal (or text) they are
printed in letters, and no file is written. The exit status is that of `planar solve`, but answers that the file states
are not compared.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from planar_cli import cli
from planar_cli.by_click import type_of
from planar_cli.commands._limit import limits
from planar_cli.commands._output import write, write_files
from planar_cli.errors import PlanarError
from planar_cli.options import SECONDS

if TYPE_CHECKING:
    from planar_cli.report.document.blocks import Document

LETTERS = ("terminal", "text")
"""Figures in letters, which are printed; `text` is another name."""
FORMS = ("svg", "png", *LETTERS)
STANDARD_INPUT = "problem"
"""How figures of a problem from standard input are called."""


@click.command(help=__doc__)
@click.argument("files", nargs=-1, required=True)
@click.option("-o", "--output", metavar="FOLDER", help="Where the files go.  [default: here]")
@click.option("--format", "form", type=click.Choice(FORMS), default="svg", help="What kind of files.")
@click.option("--timeout", type=type_of(SECONDS), default=60, show_default=True, help="Seconds a problem; 0: none.")
def command(files: tuple[str, ...], output: str | None, form: str, timeout: float) -> int:
    """Draw each file; one that fails does not keep the others from being drawn."""
    if output is not None and form in LETTERS:
        raise click.UsageError("figures in letters are printed: leave -o out, or write `> FILE` behind the command")
    worst = cli.SOLVED
    for path in files:
        told = ""
        try:
            told = _drawn(path, form, output or ".", timeout)
            status = cli.SOLVED if told else _nothing(path)
        except PlanarError as error:
            status = cli.tell(error)
        except Exception as error:
            status = cli.tell_fault(error)
        worst = max(worst, status)
        if told:
            # Where nobody takes it, that is no failure of this file: the command line sees to it.
            write(told, None, exact=True)
    return worst


def _drawn(path: str, form: str, folder: str, timeout: float) -> str:
    """What is printed of a file: its figures in letters, or the files that they are in; "": it has none."""
    with limits(timeout):
        if form in LETTERS:
            return _in_letters(path)
        made = dict(_figures(path, form))
    write_files(made, folder)
    return "".join(f"{Path(folder, name)}\n" for name in made)


def _nothing(path: str) -> int:
    cli.say(f"{path}: nothing to draw: the file does not tell where its bodies are")
    return cli.UNDECIDED


def _in_letters(path: str) -> str:
    """The figures of a file in letters, one below the other."""
    from textwrap import wrap

    from planar_cli.figures.illustrated import figures_of
    from planar_cli.formats._drawn_small import small_drawing
    from planar_cli.formats._terminals import PIPE_WIDTH, shown_on
    from planar_cli.plain_letters import letters

    found = dict(figures_of(_page(path)))
    with shown_on(sys.stdout, None) as width:
        room = min(width, PIPE_WIDTH)
        drawn = [[*wrap(letters(f.words), room), "", *small_drawing(f, room), ""] for f in found.values()]
    return "\n".join(line for lines in drawn for line in lines)


def _figures(path: str, form: str) -> Iterator[tuple[str, bytes]]:
    """The figures of a file, by the names of their own files."""
    from planar_cli.figures.illustrated import figures_of
    from planar_cli.formats._svg import svg

    stem = STANDARD_INPUT if path == "-" else Path(path).stem
    for name, figure in figures_of(_page(path)):
        safe = re.sub(r"[^\w.-]", "_", f"{stem}-{name}")
        text = svg(figure, "print" if form == "png" else "own")
        yield f"{safe}.{form}", _png(text) if form == "png" else text.encode()


def _page(path: str) -> Document:
    """The worked solution of a file with its figures."""
    from planar_cli.figures.illustrated import illustrated
    from planar_cli.homework.checking.checking import read
    from planar_cli.report.page.narrate import narrate
    from planar_cli.solve.run import solve_problem

    problem = read(path)
    solution = solve_problem(problem, problem.method)
    return illustrated(narrate(solution), solution)


def _png(text: str) -> bytes:
    """A figure as a picture of dots."""
    from planar_cli.typeset import png

    return png(text)
