"""List the kinds of joints and loads, or the problems of a folder.

Without FOLDERS: the kinds on each shelf, each with the first line of its manual page. With FOLDERS (or files): every
problem with its title and what it asks.
"""

from __future__ import annotations

import json

import click

from planar_cli.manual import kinds

SHELVES = ("joints", "loads", "principles")


@click.command(help=__doc__)
@click.argument("folders", nargs=-1)
@click.option("--format", "form", type=click.Choice(["text", "json"]), default="text", help="How to print.")
def command(folders: tuple[str, ...], form: str) -> int:
    """List kinds or problems."""
    return _problems(folders, form) if folders else _kinds(form)


def _kinds(form: str) -> int:
    if form == "json":
        click.echo(json.dumps({"schema_version": 1, **{shelf: kinds(shelf) for shelf in SHELVES}}, indent=2))
        return 0
    for shelf in SHELVES:
        click.echo(f"{shelf}:")
        for kind, line in kinds(shelf).items():
            click.echo(f"  {kind:<10}{line}")
    click.echo("\n`planar explain KIND` prints the manual page of one.")
    return 0


def _problems(folders: tuple[str, ...], form: str) -> int:
    """All problems that can be read; a bad file is named on standard error and makes the exit status 2."""
    from planar_cli.problem.files import problem_files
    from planar_cli.problem.structure import load

    rows: list[dict[str, object]] = []
    bad = 0
    for path in problem_files(folders):
        problem, wrong, _ = load(path)
        if problem is None:
            bad += 1
            click.echo(f"{path}: {len(wrong)} errors; `planar validate` shows them", err=True)
            continue
        finds = [f.name for p in (problem, *(case.problem for case in problem.cases)) for f in p.find]
        rows.append({"file": path, "title": problem.title, "find": finds})
    if form == "json":
        click.echo(json.dumps({"schema_version": 1, "problems": rows}, ensure_ascii=False, indent=2))
    for row in [] if form == "json" else rows:
        asked = row["find"] if isinstance(row["find"], list) else []
        click.echo(f"{row['file']}  {row['title']}  ({', '.join(asked)})")
    return 2 if bad else 0
