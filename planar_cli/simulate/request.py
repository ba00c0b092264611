"""What a run of `planar simulate` wants, read from its options."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TypeVar

from planar_cli.base_units import in_base
from planar_cli.errors import Diagnostic, FileProblem, Mark
from planar_cli.problem.checks.checks import check
from planar_cli.problem.language.expression import Found, Number, Relation
from planar_cli.problem.language.parser import ParseError, parse_found, parse_side, parse_statement
from planar_cli.problem.scene.scene import Find, Problem, State
from planar_cli.records import record
from planar_cli.units import TIME, parse_unit

STOP, QUANTITY = "--stop", "--quantity"
Parsed = TypeVar("Parsed")
TABLE_ROWS, DATA_ROWS = 21, 201


@record
class Request:
    """The options of one run."""

    until: float | None
    """s."""
    stops: tuple[str, ...]
    """Relations at which it ends."""
    quantities: tuple[tuple[str, str], ...]
    """Columns: name and quantity as written."""
    times: tuple[float, ...]
    """Rows at these times [s]; empty: evenly spread."""
    rows: int
    tolerance: float
    integrator: str
    step: float | None
    """s."""
    values: tuple[tuple[str, Number], ...]
    """Numbers for letters, as written."""
    case: str | None
    without: tuple[str, ...]
    effects: bool
    output: str


def request_of(
    until: str | None,
    stops: Sequence[str],
    quantities: Sequence[str],
    times: Sequence[str],
    rows: int | None,
    tolerance: float,
    integrator: str,
    step: str | None,
    values: Sequence[str],
    case: str | None,
    without: Sequence[str],
    effects: bool,
    output: str,
) -> Request:
    """The options as numbers. FileProblem: one of them can not be read."""
    return Request(
        None if until is None else time_of(until, "--until"),
        tuple(stops),
        tuple(_named(q) for q in quantities),
        tuple(time_of(t, "--at") for t in times),
        rows or (TABLE_ROWS if output == "table" else DATA_ROWS),
        tolerance,
        integrator,
        None if step is None else later_time(step, "--step"),
        tuple(_value(v) for v in values),
        case,
        tuple(without),
        effects,
        output,
    )


def time_of(text: str, option: str) -> float:
    """A time as written, `10 s` or seconds without a unit."""
    found = _number(text, option)
    if found.unit is not None and parse_unit(found.unit).dimension != TIME:
        raise _refused(option, f"{text} is no time", "write `10 s`")
    return number_of(found, us=False)


def later_time(text: str, option: str) -> float:
    """The same of a time that passes."""
    found = time_of(text, option)
    if found <= 0:
        raise _refused(option, f"{text} is no time that passes", "write more than `0 s`")
    return found


def _value(text: str) -> tuple[str, Number]:
    """NAME=VALUE."""
    name, sign, value = text.partition("=")
    if not sign or not name.strip().isidentifier():
        raise _refused("--set", f"{text} is no name with a value", "write `--set 'm=2 kg'`")
    return name.strip(), _number(value.strip(), "--set")


def _named(text: str) -> tuple[str, str]:
    """`NAME=QUANTITY`, or a quantity that is its own name."""
    name, sign, what = text.partition("=")
    return (name.strip(), what.strip()) if sign and name.strip().isidentifier() else (text, text)


def _number(text: str, option: str) -> Number:
    side = _parsed(parse_side, text, option)
    if not isinstance(side, Number):
        raise _refused(option, f"{text} is no number", "write a number with its unit, as `2.5 s`")
    return side


def number_of(number: Number, us: bool) -> float:
    """A number in the base units of a file."""
    return number.sense * float(number.value) * (in_base(parse_unit(number.unit), us) if number.unit else 1.0)


def _refused(option: str, message: str, hint: str) -> FileProblem:
    return FileProblem([Diagnostic(Mark(option, 1, 1), "PL711", message, hint)])


# --- what a request makes of a problem ------------------------------------------------------------------------------


def columns(problem: Problem, request: Request) -> tuple[Find, ...]:
    """The quantities that are asked for, as finds of the problem."""
    finds = []
    for name, text in request.quantities:
        found: Found = _parsed(parse_found, text, QUANTITY)
        finds.append(Find(name, found, Mark(QUANTITY, 1, 1)))
    asked = replace(problem, find=tuple(finds), states=(), instant=None, cases=(), answers=())
    wrong = [d for d in check(asked) if d.mark.file == QUANTITY] if finds else []
    if wrong:
        raise FileProblem(wrong)
    return tuple(finds)


def stops(problem: Problem, request: Request) -> tuple[Relation, ...]:
    """The relations at which the motion ends."""
    relations = []
    for text in request.stops:
        statement = _parsed(parse_statement, text, STOP)
        if not isinstance(statement, Relation):
            raise _refused(STOP, f"'{text}' is no relation", "write `--stop 'y(ball) = 0'`")
        relations.append(statement)
    state = State("stop", tuple(relations), Mark(STOP, 1, 1))
    first = problem.states[:1] or (State("start", problem.instant or (), Mark(problem.file, 1, 1)),)
    made = replace(problem, instant=None, states=(*first, state), find=(), cases=(), answers=())
    wrong = [d for d in check(made) if d.mark.file == STOP] if relations else []
    if wrong:
        raise FileProblem(wrong)
    return tuple(relations)


def _parsed(parse: Callable[[str, Mark], Parsed], text: str, option: str) -> Parsed:
    """What a parser makes of an option; what it refuses as a located error."""
    try:
        return parse(text, Mark(option, 1, 1))
    except ParseError as error:
        raise FileProblem([error.diagnostic]) from error
