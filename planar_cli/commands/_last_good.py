"""The last good page of a file that is watched: on the screen, or in a file that a browser has open."""

from __future__ import annotations

import contextlib
import io
import sys
from abc import ABC, abstractmethod
from collections.abc import Sequence
from html import escape
from typing import TextIO

import click

from planar_cli import cli
from planar_cli.commands._output import write
from planar_cli.problem.nodes.show import harmless
from planar_cli.streams import echo

UTF_8 = "utf-8"
RELOAD = '<meta http-equiv="refresh" content="1">\n'
"""The page asks for itself again each second; this takes no script."""
HEAD, BODY = '<meta charset="utf-8">\n', "<body>\n"
LOOK = "border:2px solid #b3261e;border-radius:6px;padding:.4rem .8rem;white-space:pre-wrap;overflow-x:auto"


class _Held(io.TextIOWrapper):
    """What would be written to a stream. Asked for its letters and its width it answers as the stream does."""

    def __init__(self, stream: TextIO, encoding: str) -> None:
        self.bytes, self.stream = io.BytesIO(), stream
        super().__init__(self.bytes, encoding, errors="backslashreplace", newline="", write_through=True)

    def isatty(self) -> bool:
        return self.stream.isatty()

    def text(self) -> str:
        """What was written."""
        self.flush()
        return self.bytes.getvalue().decode(self.encoding)


def held(line: Sequence[str], encoding: str = "") -> tuple[int, str, str]:
    """Run a command: its status, what it prints, and what it tells on standard error, of which nothing is shown yet.

    `encoding`: of what it prints; "": that of standard output.
    """
    page = _Held(sys.stdout, encoding or sys.stdout.encoding or UTF_8)
    told = _Held(sys.stderr, sys.stderr.encoding or UTF_8)
    with contextlib.redirect_stdout(page), contextlib.redirect_stderr(told):
        status = cli.run(line)
    return status, page.text(), told.text()


class Place(ABC):
    """Where pages go. `stays`: what is to be seen while a file has mistakes."""

    stays = ""

    @abstractmethod
    def run(self, line: Sequence[str]) -> int:
        """Run the command that makes the page, and show what came of it."""

    def close(self) -> None:
        """Nobody watches any more."""
        return


class InFile(Place):
    """A file that the command itself writes, or leaves as it is."""

    def __init__(self, output: str) -> None:
        self.output = output

    def run(self, line: Sequence[str]) -> int:
        return cli.run([*line, "-o", self.output])


class _LastGood(Place):
    """While a file has mistakes the last good page stays, with what is told of them."""

    encoding = ""

    def __init__(self) -> None:
        self.page = ""

    def run(self, line: Sequence[str]) -> int:
        status, page, told = held(line, self.encoding)
        if status == cli.INTERRUPTED:
            return status
        self.page = page or self.page
        self.stays = "the last good page stays" if self.page else ""
        self.show(page, told)
        return status

    @abstractmethod
    def show(self, page: str, told: str) -> None:
        """Show a page ("": there is none now) and what is told."""


class OnScreen(_LastGood):
    """Page and message one below the other; of a pipe each page goes on behind the others."""

    def show(self, page: str, told: str) -> None:
        terminal = sys.stdout.isatty()
        if terminal:
            click.clear()
        echo(self.page if terminal else page, end="")
        echo(told, err=True, end="")


class InBrowser(_LastGood):
    """A page of HTML that loads itself again, with the message at its head; at the end it stays as it is."""

    encoding = UTF_8

    def __init__(self, output: str) -> None:
        super().__init__()
        self.output = output

    def show(self, page: str, told: str) -> None:
        echo(told, err=True, end="")
        if not self.page:
            return
        wrong = told and not page
        said = f'<pre role="status" style="{LOOK}">{escape(harmless(click.unstyle(told)))}</pre>\n' if wrong else ""
        write(self.page.replace(HEAD, HEAD + RELOAD, 1).replace(BODY, BODY + said, 1), self.output)

    def close(self) -> None:
        if self.page:
            write(self.page, self.output)
