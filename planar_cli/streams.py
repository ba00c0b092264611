"""Writing to standard output and error."""

from __future__ import annotations

import os
import re
import sys

ESCAPE = "\x1b"
LOG_COMMANDS = re.compile(r"(?m)^(\s*:)(?=:)|##(?=\[)")
"""What GitHub Actions obeys in a log: `::` at the head of a line, `##[` anywhere."""


def echo(text: str = "", err: bool = False, end: str = "\n", colour: bool | None = None, exact: bool = False) -> None:
    """Print a text at once. What has colours, or goes where not every character can be written, click sees to.

    `colour`: are colours kept? None: as far as a terminal shows them. `exact`: data for programs keep their letters
    where a stream has none but ASCII. What stands in a file, or is its name, gives no command to GitHub Actions.
    """
    if os.environ.get("GITHUB_ACTIONS"):
        text = LOG_COMMANDS.sub(r"\g<0> ", text)
    stream = sys.stderr if err else sys.stdout
    if not exact and not text.isascii():
        from planar_cli.plain_letters import ascii_of, is_poor

        text = ascii_of(text) if is_poor(stream) else text
    encoding = str(getattr(stream, "encoding", "")).lower()
    if ESCAPE in text or encoding != "utf-8" or os.name != "posix":
        import click

        click.echo(text + end, err=err, nl=False, color=colour)
        return
    stream.write(text + end)
    stream.flush()
