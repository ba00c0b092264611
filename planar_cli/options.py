"""What a command may be told on the command line: declared once, read without click where nothing is unusual.

    @command(help=__doc__)
    @argument("files")
    @option("--rows", type=IntRange(2, 100), help="How many rows.")
    def command(files: tuple[str, ...], rows: int | None) -> int: ...

`Command.read` takes command lines in which every option is written in full with a value that is in order. Anything else
(help, abbreviations, what is wrong) it leaves to click, which `by_click` makes the same command for: importing click
takes as long as starting Python.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from planar_cli.records import record


class WrongUsage(Exception):
    """A command is told what it can not do; the message says what to write instead."""


@record
class Choice:
    """One of some words."""

    words: Sequence[str]

    def read(self, text: str) -> str:
        """The word. ValueError: there is none like that."""
        if text not in self.words:
            raise ValueError(text)
        return text


@record
class IntRange:
    """A whole number between limits, both of them included."""

    least: int
    most: int | None = None

    def read(self, text: str) -> int:
        """The number. ValueError: it is none, or beyond the limits."""
        return int(_within(int(text), self.least, self.most))


@record
class FloatRange:
    """A number between limits, both of them included."""

    least: float
    most: float | None = None

    def read(self, text: str) -> float:
        """The number. ValueError: it is none, or beyond the limits."""
        return _within(float(text), self.least, self.most)


def _within(number: float, least: float, most: float | None) -> float:
    """The number. ValueError: it is beyond the limits, or no number."""
    if not least <= number or (most is not None and number > most):
        raise ValueError(number)
    return number


Kind = Choice | IntRange | FloatRange
SECONDS = FloatRange(0, 1_000_000)
"""A limit of time; clocks know no longer ones than some."""


@record
class Option:
    """One option of a command."""

    names: tuple[str, ...]
    """As they are written: `-o`, `--output`."""
    parameter: str
    """Of the command's function."""
    help: str
    type: Kind | None = None
    """None: any text."""
    default: Any = None
    metavar: str | None = None
    multiple: bool = False
    """May it be repeated? Then all values are given, as a tuple."""
    is_flag: bool = False
    show_default: bool = False

    def read(self, text: str) -> Any:
        """A value as written. ValueError: it is not in order."""
        return text if self.type is None else self.type.read(text)

    @property
    def unwritten(self) -> Any:
        """What the function is given where the option is not written."""
        if self.multiple or self.is_flag:
            return () if self.multiple else False
        return None if self.default is None else self.read(str(self.default))


@record
class Argument:
    """What stands on the line beside options: one or more texts, or none where it is not `required`."""

    parameter: str
    required: bool = True


Function = Callable[..., int]


class Command:
    """A function with what it may be told."""

    def __init__(self, function: Function, parameters: Sequence[Option | Argument], page: str) -> None:
        self.function, self.parameters, self.page = function, tuple(parameters), page

    def __call__(self, **values: Any) -> int:
        return self.function(**values)

    def read(self, args: Sequence[str]) -> Mapping[str, Any] | None:
        """The function's parameters; None: the line is not as usual, and click has to look at it."""
        options = [p for p in self.parameters if isinstance(p, Option)]
        by_name = {name: o for o in options for name in o.names}
        found: dict[str, Any] = {o.parameter: o.unwritten for o in options}
        texts: list[str] = []
        left = iter(args)
        for word in left:
            name, sign, value = word.partition("=")
            if not word.startswith("-") or word == "-":
                texts.append(word)
            elif (option := by_name.get(name)) is None or (sign and (option.is_flag or not name.startswith("--"))):
                return None
            elif option.is_flag:
                found[option.parameter] = True
            else:
                text = value if sign else next(left, None)
                if text is None or text.startswith("-") or not _take(option, text, found):
                    return None
        beside = [p for p in self.parameters if isinstance(p, Argument)]
        enough = len(beside) == 1 and (texts or not beside[0].required)
        return {**found, beside[0].parameter: tuple(texts)} if enough else None


def _take(option: Option, text: str, found: dict[str, Any]) -> bool:
    """Enter one value; False: it is not in order."""
    try:
        value = option.read(text)
    except ValueError:
        return False
    found[option.parameter] = (*found[option.parameter], value) if option.multiple else value
    return True


# --- how they are declared --------------------------------------------------------------------------------------------


def command(help: str | None) -> Callable[[Function], Command]:
    """Make a function a command; `help`: its page."""
    return lambda function: Command(function, getattr(function, "parameters", ()), help or "")


def argument(parameter: str, required: bool = True) -> Callable[[Function], Function]:
    """One text or more beside the options."""
    return lambda function: _with(function, Argument(parameter, required))


def option(*names: str, help: str, **more: Any) -> Callable[[Function], Function]:
    """An option: its names, and the parameter of the function where that is not the long name."""
    written = tuple(n for n in names if n.startswith("-"))
    told = [n for n in names if not n.startswith("-")]
    parameter = told[0] if told else written[-1].lstrip("-").replace("-", "_")
    return lambda function: _with(function, Option(written, parameter, help, **more))


def _with(function: Function, parameter: Option | Argument) -> Function:
    """Decorators are applied from below."""
    vars(function)["parameters"] = (parameter, *getattr(function, "parameters", ()))
    return function
