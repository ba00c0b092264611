"""Solve a problem file again whenever it is saved, and keep the last good result.

With -o the page is written there each time; an HTML page that is open in a browser loads itself again. Without -o the
page is printed. While the file has mistakes these are told, and the last good page stays. Ends with Ctrl-C.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator

import click

from planar_cli import cli
from planar_cli.commands._last_good import InBrowser, InFile, OnScreen
from planar_cli.errors import PlanarError
from planar_cli.registry import modules
from planar_cli.streams import echo

EVERY = 0.2
"""The file is looked at so often, s."""
Stamp = tuple[int, int]


@click.command(help=__doc__)
@click.argument("file")
@click.option(
    "--format",
    "form",
    type=click.Choice([*modules("formats"), "pdf"]),
    help="How to print.  [default: terminal; with -o: html]",
)
@click.option("-o", "--output", metavar="FILE", help="Write to FILE instead of standard output.")
@click.option("--audience", type=click.Choice(["exam", "student", "lesson"]), default="student", help="As in solve.")
def command(file: str, form: str | None, output: str | None, audience: str) -> int:
    """Solve after each change."""
    if file == "-":
        raise click.UsageError("standard input cannot be watched; name a file")
    output = None if output == "-" else output
    style = form or ("html" if output else "terminal")
    line = ["solve", file, "--audience", audience, "--format", style]
    place = OnScreen() if output is None else InBrowser(output) if style == "html" else InFile(output)
    status = cli.SOLVED
    try:
        for _ in changes(file):
            status = place.run(line)
            if status == cli.INTERRUPTED:
                break
            echo(_told(file, status, output, place.stays), err=True)
    finally:
        place.close()
    return status


def changes(file: str) -> Iterator[Stamp]:
    """Once at first, and again whenever the file is another one than before; while it is not there nothing."""
    before: Stamp | None = None
    first = True
    while True:
        now = _stamp(file)
        if first and now is None:
            raise PlanarError(f"{file}: there is no such file")
        if now is not None and now != before:
            yield now
        first, before = False, now or before
        time.sleep(EVERY)


def _stamp(file: str) -> Stamp | None:
    """What changes when a file is saved; None: it is not there, as while an editor replaces it."""
    try:
        found = os.stat(file)
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def _told(file: str, status: int, output: str | None, stays: str) -> str:
    where = f", written to {output}" if output else ""
    if status == cli.SOLVED:
        return f"planar: solved{where}; waiting for {file} to be saved (Ctrl-C ends)"
    if status == cli.DISAGREES:
        # It is the status of a page that differs from the answers of the file, and that of no page.
        told = "no solution, or not the answers that the file states"
        return f"planar: {told}; waiting for {file} to be saved (Ctrl-C ends)"
    kept = stays or (f"{output} is as before" if output and os.path.exists(output) else "")
    return f"planar: not solved; {kept}{kept and '; '}waiting for {file} to be saved (Ctrl-C ends)"
