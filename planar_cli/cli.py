"""The outer command line: finds the commands on their shelf, runs one, and turns what happens into an exit status.

No command is imported before it is run, so that `planar --help` stays quick.
"""

from __future__ import annotations

import contextlib
import errno
import importlib
import io
import os
import sys
from collections.abc import Sequence
from typing import NoReturn

import click

from planar_cli import __version__
from planar_cli.errors import Diagnostic, NoSolution, PlanarError, Undecided
from planar_cli.help_page import ABOUT, commands
from planar_cli.problem.show import harmless
from planar_cli.registry import modules

SOLVED, DISAGREES, BAD, UNDECIDED, FAULT = range(5)
INTERRUPTED = 130
UNWRITABLE = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)
"""How writing to an open stream fails: a full disk, a quota, a limit of its size, a broken device."""


class CommandShelf(click.Group):
    """A group whose commands are the modules of the folder `commands`."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [name.replace("_", "-") for name in modules("commands")]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.list_commands(ctx):
            return None
        module = importlib.import_module(f"planar_cli.commands.{cmd_name.replace('-', '_')}")
        command: click.Command = module.command
        return command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        known = self.list_commands(ctx)
        if args and args[0] not in known and not args[0].startswith("-"):
            from difflib import get_close_matches

            near = get_close_matches(args[0], known, n=1, cutoff=0.5)
            hint = f" Did you mean '{near[0]}'?" if near else f" There are {', '.join(known)}."
            raise click.UsageError(f"There is no command '{args[0]}'.{hint}", ctx)
        return super().resolve_command(ctx, args)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """The commands with the first line of their docstrings, read from the files without importing them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(commands().items()))


@click.group(cls=CommandShelf, context_settings={"help_option_names": ["-h", "--help"]}, help="\n\n".join(ABOUT))
@click.version_option(__version__, prog_name="planar")
def cli() -> None:
    """The group of all commands."""


def run(args: Sequence[str] | None = None) -> int:
    """Run the command line; returns its exit status and never lets a traceback out, unless PLANAR_DEBUG is set."""
    _open_streams()
    try:
        status = cli.main(args=None if args is None else list(args), prog_name="planar", standalone_mode=False)
        return status if isinstance(status, int) else SOLVED
    except click.exceptions.Exit as leave:
        return leave.exit_code
    except click.Abort:
        return INTERRUPTED
    except click.ClickException as error:
        shown = io.StringIO()
        error.show(file=shown)
        click.echo(harmless(shown.getvalue()), err=True, nl=False)
        return BAD
    except PlanarError as error:
        return tell(error)
    except BrokenPipeError:
        # The reader of a pipe has left (`planar list | head`); nobody is there to be told.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return SOLVED
    except OSError as error:
        # Whoever opens a file names it, and tells what fails; writing to what is open already names nothing.
        if error.filename is not None or error.errno not in UNWRITABLE:
            return tell_fault(error)
        say(f"planar: cannot write to standard output: {error.strerror}")
        return BAD
    except Exception as error:
        return tell_fault(error)


def _open_streams() -> None:
    """Standard output and error that can be written to, in any encoding; where a shell closed them nobody looks."""
    for name in ("stdout", "stderr"):
        stream = getattr(sys, name)
        if stream is None:
            setattr(sys, name, io.StringIO())
        elif hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


def main() -> NoReturn:
    """Run the command line and leave with its exit status; what an installed `planar` of an earlier version calls."""
    sys.exit(run())


def tell_fault(error: Exception) -> int:
    """Print that planar itself failed; with PLANAR_DEBUG the traceback goes on."""
    if os.environ.get("PLANAR_DEBUG"):
        raise error
    say(f"planar: a fault of planar itself: {type(error).__name__}: {error}")
    say("Please report it; PLANAR_DEBUG=1 shows where it happened.")
    return FAULT


def say(text: str) -> None:
    """Print a line on standard error, whatever stands in it; where nothing can be written nobody is to be told."""
    with contextlib.suppress(OSError):
        click.echo(harmless(text, kept=""), err=True)


def tell(error: PlanarError) -> int:
    """Print what the user can mend, and choose the exit status."""
    from planar_cli.diagnostics import show_all

    diagnostics: tuple[Diagnostic, ...] = getattr(error, "diagnostics", ())
    if diagnostics:
        show_all(diagnostics)
    else:
        say(f"planar: {error}")
    return status_of(error)


def status_of(error: PlanarError) -> int:
    """The exit status of what the user can mend."""
    match error:
        case NoSolution():
            return DISAGREES
        case Undecided():
            return UNDECIDED
        case _:
            return BAD
