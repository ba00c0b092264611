"""The outer command line by click: help, completion, and all that is unusual or wrong on a line.

No command is imported before it is run.
"""

from __future__ import annotations

import importlib
import math
from typing import Any

import click

from planar_cli import __version__
from planar_cli.help_page import ABOUT, commands
from planar_cli.near import nearest
from planar_cli.options import Argument, Choice, Command, FloatRange, IntRange, Kind, Option
from planar_cli.registry import modules


class CommandShelf(click.Group):
    """A group whose commands are the modules of the folder `commands`."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [name.replace("_", "-") for name in modules("commands")]

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.list_commands(ctx):
            return None
        module = importlib.import_module(f"planar_cli.commands.{cmd_name.replace('-', '_')}")
        command: click.Command | Command = module.command
        return _made(cmd_name, command) if isinstance(command, Command) else command

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        known = self.list_commands(ctx)
        if args and args[0] not in known and not args[0].startswith("-"):
            near = nearest(args[0], known, 0.5)
            hint = f" Did you mean '{near}'?" if near else f" There are {', '.join(known)}."
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


def wrong_usage(name: str, message: str) -> click.UsageError:
    """What is told of a command that was used in the wrong way."""
    outer = click.Context(cli, info_name="planar", **cli.context_settings)
    command = cli.get_command(outer, name)
    assert command is not None
    return click.UsageError(message, click.Context(command, parent=outer, info_name=name))


def _made(name: str, command: Command) -> click.Command:
    """The same command as click has it."""
    made = click.command(name, help=command.page)(command.function)
    made.params = [_option(p) if isinstance(p, Option) else _argument(p) for p in command.parameters]
    return made


def _argument(declared: Argument) -> click.Argument:
    return click.Argument([declared.parameter], nargs=-1, required=declared.required)


def _option(declared: Option) -> click.Option:
    more: dict[str, Any] = {} if declared.default is None else {"default": declared.default}
    if declared.type is not None:
        more["type"] = type_of(declared.type)
    return click.Option(
        [*declared.names, declared.parameter],
        help=declared.help,
        metavar=declared.metavar,
        multiple=declared.multiple,
        is_flag=declared.is_flag,
        show_default=declared.show_default,
        **more,
    )


class Between(click.FloatRange):
    """A number between limits; what is no number lies between none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        number: float = super().convert(value, param, ctx)
        return self.fail(f"{value} is no number.", param, ctx) if math.isnan(number) else number


def type_of(kind: Kind) -> click.ParamType[Any]:
    match kind:
        case Choice(words):
            return click.Choice(words)
        case IntRange(least, most):
            return click.IntRange(least, most)
        case FloatRange(least, most):
            return Between(least, most)
