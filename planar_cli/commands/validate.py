"""Read problem files and tell all that is wrong with them, without solving.

FILES are problem files, homework sets (with the problem files that they list), folders (every .yaml and .yml file
below), or - for standard input. The exit status is 0 when all are right, 2 when one is not.
"""

from __future__ import annotations

import os

import click

from planar_cli.commands._output import write
from planar_cli.diagnostics import as_annotation, as_data, show_all
from planar_cli.errors import Diagnostic
from planar_cli.formats.json import dumps
from planar_cli.problem.nodes.show import visible

RIGHT, BAD = 0, 2


@click.command(help=__doc__)
@click.argument("files", nargs=-1, required=True)
@click.option("--format", "form", type=click.Choice(["text", "json", "github"]), default="text", help="How to print.")
def command(files: tuple[str, ...], form: str) -> int:
    """Validate each file and print what is wrong."""
    from planar_cli.homework.sets.set_validity import validated
    from planar_cli.problem.nodes.files import problem_files

    wrong: list[Diagnostic] = []
    warnings: list[str] = []
    read: dict[str, str] = {}
    for one in (v for path in problem_files(files) for v in validated(path)):
        # A folder may hold a set and its problems.
        if os.path.normpath(one.path) in read:
            continue
        read[os.path.normpath(one.path)] = one.path
        wrong += one.wrong
        warnings += [f"{one.path}: {w}" for w in one.warnings]
        if form == "text":
            show_all(one.wrong, {d.mark.file: one.source for d in one.wrong})
    for warning in warnings if form == "text" else ():
        click.echo(visible(f"warning: {warning}"), err=True)
    _report([*read.values()], wrong, warnings, form)
    return BAD if wrong else RIGHT


def _report(read: list[str], wrong: list[Diagnostic], warnings: list[str], form: str) -> None:
    """The whole result for programs, or one closing line for people."""
    if form == "json":
        data = {"files": read, "diagnostics": [as_data(d) for d in wrong]}
        write(dumps(data | ({"warnings": warnings} if warnings else {})), None, exact=True)
    elif form == "github":
        for diagnostic in wrong:
            click.echo(as_annotation(diagnostic))
    else:
        files = "1 file" if len(read) == 1 else f"{len(read)} files"
        bad = len({d.mark.file for d in wrong})
        click.echo(f"{files} read, {f'{bad} with errors' if bad else 'all right'}", err=bool(bad))
