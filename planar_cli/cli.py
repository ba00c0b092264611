"""The outer command line: finds a command on the shelf, runs it, and turns what happens into an exit status.

What is written as usual is read here (`options.py`), all else by click (`by_click.py`).
"""

from __future__ import annotations

import contextlib
import errno
import importlib
import io
import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, NoReturn

from planar_cli.errors import Diagnostic, Fault, NoSolution, PlanarError, TimeIsUp, Undecided
from planar_cli.options import Command, WrongUsage
from planar_cli.problem.nodes.show import harmless
from planar_cli.registry import modules
from planar_cli.streams import echo

if TYPE_CHECKING:
    import click

SOLVED, DISAGREES, BAD, UNDECIDED, FAULT = range(5)
INTERRUPTED = 130
COMPLETE = "_PLANAR_COMPLETE"
"""Set where a shell asks for completions."""
UNWRITABLE = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO, errno.EBADF)
"""How writing to an open stream fails: a full disk, a quota, a limit of its size, a broken device."""


def run(args: Sequence[str] | None = None) -> int:
    """Run the command line; returns its exit status and never lets a traceback out, unless PLANAR_DEBUG is set."""
    _open_streams()
    line = sys.argv[1:] if args is None else list(args)
    try:
        return _run(line, args is None)
    except WrongUsage as error:
        from planar_cli.by_click import wrong_usage

        return _refused(wrong_usage(line[0], str(error)))
    except PlanarError as error:
        return tell(error)
    except (EOFError, KeyboardInterrupt):
        say("")
        return INTERRUPTED
    except TimeIsUp:
        # It can be up before the work that it limits has begun.
        say("planar: not decided in time; --timeout allows more")
        return UNDECIDED
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


def _run(line: Sequence[str], own: bool) -> int:
    """Run a command; `own`: its line is that of this process."""
    command = _declared(line)
    values = None if command is None else command.read(line[1:])
    if command is None or values is None:
        return _by_click(None if own else line)
    return command(**values)


def _declared(line: Sequence[str]) -> Command | None:
    """The command that a line begins with, if it can be run without click."""
    # Elsewhere click completes file names with wildcards, and a shell may ask how a line goes on.
    if os.name != "posix" or COMPLETE in os.environ:
        return None
    module = {name.replace("_", "-"): name for name in modules("commands")}.get(line[0] if line else "")
    if module is None:
        return None
    command = importlib.import_module(f"planar_cli.commands.{module}").command
    return command if isinstance(command, Command) else None


def _by_click(args: Sequence[str] | None) -> int:
    """Run the line by click."""
    import click

    from planar_cli.by_click import cli

    try:
        status = cli.main(args=None if args is None else list(args), prog_name="planar", standalone_mode=False)
        return status if isinstance(status, int) else SOLVED
    except click.exceptions.Exit as leave:
        return leave.exit_code
    except click.Abort:
        return INTERRUPTED
    except SystemExit:
        # So click leaves where the reader of a pipe has left.
        return SOLVED
    except click.ClickException as error:
        return _refused(error)


def _refused(error: click.ClickException) -> int:
    """Tell what is wrong with a line."""
    shown = io.StringIO()
    error.show(file=shown)
    echo(harmless(shown.getvalue()), err=True, end="")
    return BAD


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
    kind = "" if isinstance(error, Fault) else f"{type(error).__name__}: "
    say(f"planar: a fault of planar itself: {kind}{error}")
    say("Please report it; PLANAR_DEBUG=1 shows where it happened.")
    return FAULT


def say(text: str) -> None:
    """Print a line on standard error, whatever stands in it; where nothing can be written nobody is to be told."""
    with contextlib.suppress(OSError):
        echo(harmless(text, kept=""), err=True)


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
