"""List the kinds of joints and loads, or the problems of a folder.

Without FOLDERS: the kinds on each shelf, each with the first line of its manual page. With FOLDERS (or files): every
problem with its title and what it asks.
"""

from __future__ import annotations

import click

from planar_cli.cli import say
from planar_cli.commands._output import write
from planar_cli.formats.json import dumps
from planar_cli.manual import kinds
from planar_cli.problem.nodes.show import harmless

SHELVES = ("joints", "loads", "principles")


@click.command(help=__doc__)
@click.argument("folders", nargs=-1)
@click.option("--format", "form", type=click.Choice(["text", "json"]), default="text", help="How to print.")
def command(folders: tuple[str, ...], form: str) -> int:
    """List kinds or problems."""
    return _problems(folders, form) if folders else _kinds(form)


def _kinds(form: str) -> int:
    if form == "json":
        write(dumps({shelf: kinds(shelf) for shelf in SHELVES}), None, exact=True)
        return 0
    for shelf in SHELVES:
        click.echo(f"{shelf}:")
        for kind, line in kinds(shelf).items():
            click.echo(f"  {kind:<10}{line}")
    click.echo("\n`planar explain KIND` prints the manual page of one.")
    return 0


def _problems(folders: tuple[str, ...], form: str) -> int:
    """All problems that can be read; a bad file is named on standard error and makes the exit status 2."""
    from planar_cli.problem.nodes.files import problem_files
    from planar_cli.problem.structure import load

    rows: list[dict[str, object]] = []
    bad = 0
    for path in problem_files(folders):
        problem, wrong, _ = load(path)
        if problem is None:
            bad += 1
            errors = "1 error" if len(wrong) == 1 else f"{len(wrong)} errors"
            say(f"{path}: {errors}; `planar validate` shows them")
            continue
        finds = [f.name for p in (problem, *(case.problem for case in problem.cases)) for f in p.find]
        rows.append({"file": path, "title": problem.title, "find": finds})
    if form == "json":
        write(dumps({"problems": rows}), None, exact=True)
    for row in [] if form == "json" else rows:
        asked = row["find"] if isinstance(row["find"], list) else []
        line = f"{row['file']}  {row['title']}  ({', '.join(asked)})"
        write(harmless(line, kept="") + "\n", None)
    return 2 if bad else 0
