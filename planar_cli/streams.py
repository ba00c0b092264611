"""Writing to standard output and error."""

from __future__ import annotations

import os
import sys

ESCAPE = "\x1b"


def echo(text: str = "", err: bool = False, end: str = "\n", colour: bool | None = None) -> None:
    """Print a text at once. What has colours, or goes where not every character can be written, click sees to.

    `colour`: are colours kept? None: as far as a terminal shows them.
    """
    stream = sys.stderr if err else sys.stdout
    encoding = str(getattr(stream, "encoding", "")).lower()
    if ESCAPE in text or encoding != "utf-8" or os.name != "posix":
        import click

        click.echo(text + end, err=err, nl=False, color=colour)
        return
    stream.write(text + end)
    stream.flush()
